#include "codecs/photo/photo.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <string_view>
#include <utility>

#include "base/charge.hpp"
#include "base/parallel.hpp"
#include "base/public_verb.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "codecs/file_kind.hpp"
#include "codecs/image_file.hpp"
#include "codecs/jpeg/jpeg_decode.hpp"
#include "codecs/photo/photo_exif.hpp"
#include "codecs/photo/photo_profile.hpp"
#include "codecs/photo/photo_webp.hpp"
#include "codecs/png/png_decode.hpp"

namespace sfumato::codecs {
namespace {

using Bytes = std::span<const std::uint8_t>;

/// The gAMA of files for an ordinary (sRGB) screen; libpng takes these values for sRGB too.
constexpr double kScreenGamma = 1 / 2.2;
constexpr double kSameGamma = 0.05;

/// Pixels that are converted together.
constexpr std::size_t kRun = 512;
/// Pixels between two polls of the cancel flag; each takes at most 0.3 µs.
constexpr std::size_t kPartPixels = std::size_t{1} << 15;

class PhotoReader {
 public:
  PhotoReader(Context& context, Bytes bytes, const std::string& file, int max_side,
              std::vector<Diagnostic>* warnings)
      : context_(context), bytes_(bytes), file_(file), max_side_(max_side), warnings_(warnings) {}

  Result<SizedPhoto> read();

 private:
  Status decode();
  Status decode_png();
  Status decode_jpeg();
  Status decode_webp();
  Status hold_what_was_read();
  Result<std::optional<ToSrgb>> conversion();
  Result<std::optional<ToSrgb>> conversion_by_numbers();
  Status convert(const ToSrgb& conversion);
  Status convert_inks(const ToSrgb* conversion);
  PhotoPixels pixels() const;
  void warn(std::string message);

  Context& context_;
  Bytes bytes_;
  const std::string& file_;
  int max_side_;  ///< 0: all pixels are wanted
  std::vector<Diagnostic>* warnings_;
  ScopedCharge charge_;  ///< of all below
  Image image_;
  int width_ = 0, height_ = 0;  ///< of the file
  PhotoChannels channels_ = PhotoChannels::rgb;
  std::vector<std::uint8_t> profile_, exif_;
  bool has_profile_ = false;
  std::optional<double> gamma_;
  std::optional<std::array<Vec2, 4>> chroma_;
};

void PhotoReader::warn(std::string message) {
  if (warnings_) warnings_->push_back({std::move(message), {file_}});
}

PhotoPixels PhotoReader::pixels() const {
  return {channels_, channel_count(image_.format), bytes_per_channel(image_.format)};
}

Status PhotoReader::decode_png() {
  SFUMATO_TRY(check_png_size(context_.limits, bytes_));
  SFUMATO_TRY_ASSIGN(auto&& photo,
                     decode_png_photo(context_, bytes_, file_, {max_side_, kWholePhotoBytes}));
  image_ = std::move(photo.image);
  width_ = photo.width;
  height_ = photo.height;
  channels_ = photo.is_gray ? PhotoChannels::gray : PhotoChannels::rgb;
  profile_ = std::move(photo.profile);
  has_profile_ = photo.has_profile;
  exif_ = std::move(photo.exif);
  if (photo.is_srgb) return ok_status();
  gamma_ = photo.gamma;
  chroma_ = photo.chroma;
  return ok_status();
}

Status PhotoReader::decode_jpeg() {
  SFUMATO_TRY_ASSIGN(auto&& photo, decode_jpeg_photo(context_, bytes_));
  image_ = std::move(photo.image);
  if (photo.is_cmyk) {
    channels_ = photo.is_inverted ? PhotoChannels::cmyk_inverted : PhotoChannels::cmyk;
  } else if (photo.is_gray) {
    channels_ = PhotoChannels::gray;
  }
  profile_ = std::move(photo.profile);
  has_profile_ = photo.has_profile;
  exif_ = std::move(photo.exif);
  return ok_status();
}

Status PhotoReader::decode_webp() {
  SFUMATO_TRY_ASSIGN(auto&& photo, decode_webp_photo(context_, bytes_));
  image_ = std::move(photo.image);
  profile_ = std::move(photo.profile);
  has_profile_ = !profile_.empty();
  exif_ = std::move(photo.exif);
  return ok_status();
}

Status PhotoReader::decode() {
  const FileKind kind = file_kind(text_view(bytes_));
  if (kind == FileKind::png) return decode_png();
  Status status;
  if (kind == FileKind::jpeg) {
    status = decode_jpeg();
  } else if (kind == FileKind::webp) {
    status = decode_webp();
  } else {
    const std::string_view text = kind_text(kind);
    return make_error(StatusCode::bad_input,
                      "is " + std::string(text.empty() ? "not a picture" : text) +
                          "; use a PNG, a JPEG or a WebP");
  }
  width_ = image_.width;
  height_ = image_.height;
  return status;
}

/// The decoders give back what they charged.
Status PhotoReader::hold_what_was_read() {
  return charge_.add(context_, capacity_bytes(image_.bytes, profile_, exif_), "a photo");
}

/// Returns whether the work failed because of the profile itself.
bool is_of_profile(const Status& status) {
  return status.code == StatusCode::bad_input;
}

/// No value: the colours stay as they are.
Result<std::optional<ToSrgb>> PhotoReader::conversion_by_numbers() {
  if (gamma_ && std::abs(*gamma_ / kScreenGamma - 1) <= kSameGamma) gamma_.reset();
  if (!gamma_ && !chroma_) return std::optional<ToSrgb>();
  Result<ToSrgb> made = ToSrgb::by_numbers(context_, gamma_, chroma_, pixels());
  if (made) return std::optional(std::move(*made));
  if (!is_of_profile(made.status())) return made.status();
  warn("gAMA and cHRM are ignored: " + made.status().message);
  return std::optional<ToSrgb>();
}

Result<std::optional<ToSrgb>> PhotoReader::conversion() {
  if (!has_profile_) return conversion_by_numbers();
  Result<ToSrgb> made = profile_.empty()
                            ? Result<ToSrgb>(make_error(StatusCode::bad_input, "it is damaged"))
                            : ToSrgb::by_profile(context_, profile_, pixels());
  if (made) return std::optional(std::move(*made));
  if (!is_of_profile(made.status())) return made.status();
  warn("the colour profile is ignored: " + made.status().message);
  return conversion_by_numbers();
}

/// Alpha stays.
Status PhotoReader::convert(const ToSrgb& conversion) {
  const PhotoPixels each = pixels();
  const auto color_bytes = static_cast<std::size_t>(3 * each.bytes_per_channel);
  const auto pixel_bytes = static_cast<std::size_t>(each.channel_count * each.bytes_per_channel);
  const auto body = [&](std::size_t begin, std::size_t end) {
    std::array<std::uint8_t, 6 * kRun> rgb;
    for (std::size_t first = begin; first < end; first += kRun) {
      const std::size_t count = std::min(kRun, end - first);
      std::uint8_t* const run = &image_.bytes[pixel_bytes * first];
      conversion.convert(run, rgb.data(), count);
      for (std::size_t i = 0; i < count; ++i) {
        std::memcpy(run + pixel_bytes * i, &rgb[color_bytes * i], color_bytes);
      }
    }
  };
  return parallel_for(context_, image_.bytes.size() / pixel_bytes, kPartPixels, body);
}

/// conversion: null to use the formula.
Status PhotoReader::convert_inks(const ToSrgb* conversion) {
  Image out{image_.width, image_.height, PixelFormat::rgb8, {}};
  TableMemory memory("a photo");
  const std::size_t pixel_count = image_.bytes.size() / 4;
  SFUMATO_TRY(memory.resize(context_, out.bytes, 3 * pixel_count));
  const bool is_inverted = channels_ == PhotoChannels::cmyk_inverted;
  const auto body = [&](std::size_t begin, std::size_t end) {
    if (conversion) {
      conversion->convert(&image_.bytes[4 * begin], &out.bytes[3 * begin], end - begin);
      return;
    }
    for (std::size_t i = begin; i < end; ++i) {
      rgb_of_inks(&image_.bytes[4 * i], is_inverted, &out.bytes[3 * i]);
    }
  };
  SFUMATO_TRY(parallel_for(context_, pixel_count, kPartPixels, body));
  image_ = std::move(out);
  return ok_status();
}

Result<SizedPhoto> PhotoReader::read() {
  SFUMATO_TRY(decode());
  SFUMATO_TRY(hold_what_was_read());
  SFUMATO_TRY_ASSIGN(auto&& conversion, this->conversion());
  if (is_cmyk(channels_)) {
    SFUMATO_TRY(convert_inks(conversion ? &*conversion : nullptr));
  } else if (conversion && !conversion->is_identity()) {
    SFUMATO_TRY(convert(*conversion));
  }
  const std::optional<Orientation> orientation = exif_.empty() ? 1 : exif_orientation(exif_);
  if (!orientation) warn("the orientation is ignored: the EXIF data are damaged");
  std::vector<std::uint8_t>().swap(profile_);
  std::vector<std::uint8_t>().swap(exif_);
  charge_ = {};  // stand_upright() charges both pictures
  SFUMATO_TRY(stand_upright(context_, orientation.value_or(1), image_));
  if (orientation.value_or(1) >= kFirstSideways) std::swap(width_, height_);
  return SizedPhoto{std::move(image_), width_, height_};
}

}  // namespace

Result<SizedPhoto> read_sized_photo(Context& context, std::span<const std::uint8_t> bytes,
                                    const std::string& file, int max_side,
                                    std::vector<Diagnostic>* warnings) {
  Result<SizedPhoto> photo = public_verb(
      context, [&] { return PhotoReader(context, bytes, file, max_side, warnings).read(); });
  const bool is_of_file =
      photo.status().code == StatusCode::bad_input ||
      (photo.status().code == StatusCode::limit && photo.status().limit != "time");
  if (!is_of_file) return photo;
  Status status = photo.status();
  status.where.file = file;
  return status;
}

Result<Image> read_photo(Context& context, std::span<const std::uint8_t> bytes,
                         const std::string& file, std::vector<Diagnostic>* warnings) {
  SFUMATO_TRY_ASSIGN(auto&& photo, read_sized_photo(context, bytes, file, 0, warnings));
  return std::move(photo.image);
}

}  // namespace sfumato::codecs
