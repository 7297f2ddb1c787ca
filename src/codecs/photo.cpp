#include "codecs/photo.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <optional>
#include <string_view>
#include <utility>

#include "base/charge.hpp"
#include "base/parallel.hpp"
#include "base/public_verb.hpp"
#include "base/table_memory.hpp"
#include "codecs/image_file.hpp"
#include "codecs/jpeg_decode.hpp"
#include "codecs/photo_exif.hpp"
#include "codecs/photo_profile.hpp"
#include "codecs/photo_webp.hpp"
#include "codecs/png_decode.hpp"

namespace sfumato::codecs {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::string_view kPngSignature("\x89PNG\r\n\x1a\n", 8);
constexpr std::string_view kJpegSignature("\xff\xd8\xff", 3);

/// gAMA of a file that is meant for the usual screen, which sRGB is; what libpng takes for it, too.
constexpr double kScreenGamma = 1 / 2.2;
constexpr double kSameGamma = 0.05;

/// Pixels that are converted at once.
constexpr std::size_t kRun = 512;
/// And between two looks at the cancel flag: 0.3 µs each at most.
constexpr std::size_t kPartPixels = std::size_t{1} << 15;

bool has_at(Bytes bytes, std::size_t at, std::string_view text) {
  return bytes.size() >= at + text.size() &&
         std::memcmp(bytes.data() + at, text.data(), text.size()) == 0;
}

/// What a file of another kind is, as its first bytes show.
std::string other_kind(Bytes bytes) {
  if (has_at(bytes, 4, "ftyp")) return "a HEIC or AVIF picture";
  if (has_at(bytes, 0, "GIF8")) return "a GIF";
  if (has_at(bytes, 0, {"II*\0", 4}) || has_at(bytes, 0, {"MM\0*", 4})) return "a TIFF or raw file";
  if (has_at(bytes, 0, "<?xml") || has_at(bytes, 0, "<svg")) return "a drawing or other XML";
  return bytes.empty() ? "an empty file" : "no picture";
}

class PhotoReader {
 public:
  PhotoReader(Context& context, Bytes bytes, const std::string& file,
              std::vector<Diagnostic>* warnings)
      : context_(context), bytes_(bytes), file_(file), warnings_(warnings) {}

  Result<Image> read();

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
  std::vector<Diagnostic>* warnings_;
  ScopedCharge charge_;  ///< of all below
  Image image_;
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

bool is_inks(PhotoChannels channels) {
  return channels == PhotoChannels::cmyk || channels == PhotoChannels::cmyk_inverted;
}

Status PhotoReader::decode_png() {
  Status sized = check_png_size(context_.limits, bytes_);
  if (!sized) return sized;
  Result<PngPhoto> photo = decode_png_photo(context_, bytes_, file_);
  if (!photo) return photo.status();
  image_ = std::move(photo->image);
  channels_ = photo->is_gray ? PhotoChannels::gray : PhotoChannels::rgb;
  profile_ = std::move(photo->profile);
  has_profile_ = photo->has_profile;
  exif_ = std::move(photo->exif);
  if (photo->is_srgb) return ok_status();
  gamma_ = photo->gamma;
  chroma_ = photo->chroma;
  return ok_status();
}

Status PhotoReader::decode_jpeg() {
  Result<JpegPhoto> photo = decode_jpeg_photo(context_, bytes_);
  if (!photo) return photo.status();
  image_ = std::move(photo->image);
  if (photo->is_cmyk) {
    channels_ = photo->is_inverted ? PhotoChannels::cmyk_inverted : PhotoChannels::cmyk;
  } else if (photo->is_gray) {
    channels_ = PhotoChannels::gray;
  }
  profile_ = std::move(photo->profile);
  has_profile_ = photo->has_profile;
  exif_ = std::move(photo->exif);
  return ok_status();
}

Status PhotoReader::decode_webp() {
  Result<WebpPhoto> photo = decode_webp_photo(context_, bytes_);
  if (!photo) return photo.status();
  image_ = std::move(photo->image);
  profile_ = std::move(photo->profile);
  has_profile_ = !profile_.empty();
  exif_ = std::move(photo->exif);
  return ok_status();
}

Status PhotoReader::decode() {
  if (has_at(bytes_, 0, kPngSignature)) return decode_png();
  if (has_at(bytes_, 0, kJpegSignature)) return decode_jpeg();
  if (has_at(bytes_, 0, "RIFF") && has_at(bytes_, 8, "WEBP")) return decode_webp();
  return make_error(StatusCode::bad_input,
                    "is " + other_kind(bytes_) + "; expected a PNG, a JPEG or a WebP");
}

/// The decoders give back what they charged.
Status PhotoReader::hold_what_was_read() {
  return charge_.add(context_, capacity_bytes(image_.bytes, profile_, exif_), "a photo");
}

/// Whether the work on a profile failed for its own sake.
bool is_of_profile(const Status& status) {
  return status.code == StatusCode::bad_input;
}

/// No value: colours are as they are.
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

/// conversion: null for the formula.
Status PhotoReader::convert_inks(const ToSrgb* conversion) {
  Image out{image_.width, image_.height, PixelFormat::rgb8, {}};
  TableMemory memory("a photo");
  const std::size_t pixel_count = image_.bytes.size() / 4;
  Status status = memory.resize(context_, out.bytes, 3 * pixel_count);
  if (!status) return status;
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
  status = parallel_for(context_, pixel_count, kPartPixels, body);
  if (status) image_ = std::move(out);
  return status;
}

Result<Image> PhotoReader::read() {
  Status status = decode();
  if (status) status = hold_what_was_read();
  if (!status) return status;
  Result<std::optional<ToSrgb>> conversion = this->conversion();
  if (!conversion) return conversion.status();
  if (is_inks(channels_)) {
    status = convert_inks(*conversion ? &**conversion : nullptr);
  } else if (*conversion && !(*conversion)->is_identity()) {
    status = convert(**conversion);
  }
  if (!status) return status;
  const std::optional<Orientation> orientation = exif_.empty() ? 1 : exif_orientation(exif_);
  if (!orientation) warn("the orientation is ignored: the EXIF data are damaged");
  std::vector<std::uint8_t>().swap(profile_);
  std::vector<std::uint8_t>().swap(exif_);
  charge_ = {};  // stand_upright() charges both pictures
  status = stand_upright(context_, orientation.value_or(1), image_);
  if (!status) return status;
  return std::move(image_);
}

}  // namespace

Result<Image> read_photo(Context& context, std::span<const std::uint8_t> bytes,
                         const std::string& file, std::vector<Diagnostic>* warnings) {
  Result<Image> image =
      public_verb(context, [&] { return PhotoReader(context, bytes, file, warnings).read(); });
  const bool is_of_file =
      image.status().code == StatusCode::bad_input ||
      (image.status().code == StatusCode::limit && image.status().limit != "time");
  if (!is_of_file) return image;
  Status status = image.status();
  status.where.file = file;
  return status;
}

}  // namespace sfumato::codecs
