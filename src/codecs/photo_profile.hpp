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

/// What a pixel's channels are.
enum class PhotoChannels : std::uint8_t {
  gray,           ///< three that are the same
  rgb,            ///< red, green and blue
  cmyk,           ///< inks; 255 is all of one
  cmyk_inverted,  ///< inks; 255 is none of one
};

/// How pixels lie in memory.
struct PhotoPixels {
  PhotoChannels channels = PhotoChannels::rgb;
  int channel_count = 3;      ///< of the image, alpha included
  int bytes_per_channel = 1;  ///< 1 or 2
};

/// A conversion of pixels to sRGB, relative colorimetric with black point compensation.
class ToSrgb {
 public:
  /// By an ICC profile.
  /// Errors: bad_input (damaged, or not for such channels; the message says which), limit (memory),
  /// out_of_memory.
  static Result<ToSrgb> by_profile(const Context& context, std::span<const std::uint8_t> profile,
                                   const PhotoPixels& pixels);

  /// From code values that are light to the power `gamma`, or sRGB's where there is no gamma, of
  /// lights of this chromaticity, or sRGB's: x and y of white, red, green and blue.
  /// Errors: as by_profile().
  static Result<ToSrgb> by_numbers(const Context& context, std::optional<double> gamma,
                                   const std::optional<std::array<Vec2, 4>>& chroma,
                                   const PhotoPixels& pixels);

  ToSrgb(ToSrgb&&) noexcept;
  ToSrgb& operator=(ToSrgb&&) noexcept;
  ~ToSrgb();

  /// Whether it changes no colour by more than half a code value of 8 bits, and is better left out.
  bool is_identity() const { return is_identity_; }

  /// Converts `count` pixels to three channels each, as deep as they are. From any thread.
  void convert(const std::uint8_t* from, std::uint8_t* rgb, std::size_t count) const;

 private:
  struct Library;

  explicit ToSrgb(std::unique_ptr<Library> library);
  static Result<ToSrgb> make(std::unique_ptr<Library> library, const PhotoPixels& pixels);

  std::unique_ptr<Library> library_;
  bool is_identity_ = false;
};

}  // namespace sfumato::codecs
