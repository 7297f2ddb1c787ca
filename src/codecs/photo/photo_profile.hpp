#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/base/vec2.hpp"

/// Colour profiles, by lcms2.
namespace sfumato::codecs {

/// The meaning of a pixel's channels.
enum class PhotoChannels : std::uint8_t {
  gray,           ///< three that are the same
  rgb,            ///< red, green and blue
  cmyk,           ///< inks; 255 is full ink
  cmyk_inverted,  ///< inks; 255 is no ink
};

inline bool is_cmyk(PhotoChannels channels) {
  return channels == PhotoChannels::cmyk || channels == PhotoChannels::cmyk_inverted;
}

/// The layout of pixels in memory.
struct PhotoPixels {
  PhotoChannels channels = PhotoChannels::rgb;
  int channel_count = 3;      ///< of the image, alpha included
  int bytes_per_channel = 1;  ///< 1 or 2
};

/// A conversion of pixels to sRGB, relative colorimetric with black point compensation.
class ToSrgb {
 public:
  /// Makes a conversion by an ICC profile. Errors: bad_input (damaged, or not for such channels;
  /// the message says which), limit (memory), out_of_memory.
  static Result<ToSrgb> by_profile(const Context& context, std::span<const std::uint8_t> profile,
                                   const PhotoPixels& pixels);

  /// Makes a conversion from code values that are light to the power `gamma` (without a gamma,
  /// sRGB's curve), with primaries of this chromaticity (without one, sRGB's): x and y of white,
  /// red, green and blue. Errors: as by_profile().
  static Result<ToSrgb> by_numbers(const Context& context, std::optional<double> gamma,
                                   const std::optional<std::array<Vec2, 4>>& chroma,
                                   const PhotoPixels& pixels);

  ToSrgb(ToSrgb&&) noexcept;
  ToSrgb& operator=(ToSrgb&&) noexcept;
  ~ToSrgb();

  /// Returns whether the conversion changes no colour by more than half a code value of 8 bits, so
  /// that it is better left out.
  bool is_identity() const { return is_identity_; }

  /// Converts `count` pixels to three channels each, with the same depth. Any thread may call this.
  void convert(const std::uint8_t* from, std::uint8_t* rgb, std::size_t count) const;

 private:
  struct Library;

  explicit ToSrgb(std::unique_ptr<Library> library);
  static Result<ToSrgb> make(std::unique_ptr<Library> library, const PhotoPixels& pixels);

  std::unique_ptr<Library> library_;
  bool is_identity_ = false;
};

}  // namespace sfumato::codecs
