#include "codecs/png/png_decode.hpp"

#include <spng.h>

#include <algorithm>
#include <cstring>
#include <string_view>
#include <utility>

#include "base/limit_error.hpp"
#include "base/owned.hpp"
#include "base/poll.hpp"
#include "base/public_verb.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "codecs/file_kind.hpp"
#include "codecs/png/row_shrink.hpp"
#include "sfumato/base/function_ref.hpp"
#include "sfumato/base/limits.hpp"
#include "sfumato/codecs/png.hpp"

namespace sfumato {
namespace {

/// The tightest packing of deflate: 258 bytes in two bits.
constexpr std::uint64_t kMaxDeflateRatio = 1032;

/// The most bytes of texts, profiles and other chunks without pixels.
constexpr std::size_t kOtherChunkBytes = std::size_t{16} << 20;

constexpr std::size_t kSignatureBytes = 8;
/// Length, type and CRC of a chunk.
constexpr std::size_t kChunkFrameBytes = 12;

class Decoder {
 public:
  /// wants_alpha: the image always gets an alpha channel.
  Decoder(Context& context, std::span<const std::uint8_t> bytes, const std::string& file,
          bool wants_alpha, const codecs::PhotoShrink& shrink = {})
      : context_(context),
        bytes_(bytes),
        file_(file),
        wants_alpha_(wants_alpha),
        shrink_(shrink),
        png_(spng_ctx_new(0)) {}

  Result<Image> decode();
  Result<codecs::PngPhoto> decode_photo();

 private:
  Status read_header();
  Status check_header();
  Status make_room(Image& image);
  bool is_to_shrink(const Image& image) const;
  Status decode_rows(int spng_format, int flags, Image& image);
  Status decode_smaller(int spng_format, int flags, Image& image);
  Status for_each_row(int spng_format, int flags, std::size_t row_bytes,
                      FunctionRef<std::uint8_t*(const spng_row_info&)> room,
                      FunctionRef<void(const spng_row_info&)> take);
  Result<Image> decode_as(int spng_format, PixelFormat format);
  Result<Image> without_alpha16(const Image& from);
  void find_colors(codecs::PngPhoto& photo);
  Status find_profile(codecs::PngPhoto& photo);
  Status find_exif(codecs::PngPhoto& photo);
  Status error(StatusCode code, std::string message) const;
  /// Converts the result of a library call to a status.
  Status status_of(int error_code) const;

  Context& context_;
  std::span<const std::uint8_t> bytes_;
  const std::string& file_;
  bool wants_alpha_;
  codecs::PhotoShrink shrink_;
  Owned<spng_ctx, spng_ctx_free> png_;
  spng_ihdr header_{};
  bool has_alpha_ = false;
  TableMemory memory_{"a PNG image"};
};

/// Returns whether there is a chunk of that type.
bool has_chunk(std::span<const std::uint8_t> png, const char* type) {
  std::size_t at = kSignatureBytes;
  while (at + kChunkFrameBytes <= png.size()) {
    const std::size_t length = std::size_t{png[at]} << 24 | std::size_t{png[at + 1]} << 16 |
                               std::size_t{png[at + 2]} << 8 | png[at + 3];
    if (length > png.size() - at - kChunkFrameBytes) return false;
    if (std::memcmp(&png[at + 4], type, 4) == 0) return true;
    at += length + kChunkFrameBytes;
  }
  return false;
}

Status Decoder::error(StatusCode code, std::string message) const {
  return make_error(code, std::move(message), {file_});
}

Status Decoder::status_of(int error_code) const {
  if (error_code == SPNG_OK) return ok_status();
  if (error_code == SPNG_EMEM || error_code == SPNG_EZLIB_INIT) {
    return error(StatusCode::out_of_memory, "no memory to read the PNG image");
  }
  return error(StatusCode::bad_input,
               std::string("the PNG image is damaged: ") + spng_strerror(error_code));
}

Status Decoder::read_header() {
  if (!png_) return status_of(SPNG_EMEM);
  if (const auto kind = codecs::file_kind(codecs::text_view(bytes_));
      kind != codecs::FileKind::png) {
    const std::string_view text = codecs::kind_text(kind);
    return error(StatusCode::bad_input,
                 text.empty() ? "is not a PNG image" : "is " + std::string(text) + "; use a PNG");
  }
  SFUMATO_TRY(status_of(spng_set_crc_action(png_.get(), SPNG_CRC_ERROR, SPNG_CRC_ERROR)));
  SFUMATO_TRY(status_of(spng_set_chunk_limits(png_.get(), kOtherChunkBytes, kOtherChunkBytes)));
  SFUMATO_TRY(status_of(spng_set_png_buffer(png_.get(), bytes_.data(), bytes_.size())));
  SFUMATO_TRY(status_of(spng_get_ihdr(png_.get(), &header_)));
  return check_header();
}

Status Decoder::check_header() {
  if (std::max(header_.width, header_.height) > context_.limits.image_side) {
    return make_limit_error(
        &Limits::image_side,
        "an image of " + std::to_string(header_.width) + " × " + std::to_string(header_.height) +
            " pixels; the limit is " +
            limit_text(context_.limits, &Limits::image_side, "pixels on a side"),
        {file_});
  }
  const bool has_three_channels = header_.color_type == SPNG_COLOR_TYPE_TRUECOLOR ||
                                  header_.color_type == SPNG_COLOR_TYPE_TRUECOLOR_ALPHA;
  const std::uint64_t bits = std::uint64_t{header_.width} * header_.height * header_.bit_depth *
                             (has_three_channels ? 3 : 1);
  if (bits / 8 > kMaxDeflateRatio * bytes_.size()) {
    return error(StatusCode::bad_input, "the PNG image is damaged: too few bytes for " +
                                            std::to_string(header_.width) + " × " +
                                            std::to_string(header_.height) + " pixels");
  }
  return ok_status();
}

Result<Image> Decoder::decode() {
  SFUMATO_TRY(read_header());
  spng_trns transparency{};
  const int has_transparency = spng_get_trns(png_.get(), &transparency);
  if (has_transparency != SPNG_ECHUNKAVAIL) {
    SFUMATO_TRY(status_of(has_transparency));
  }
  has_alpha_ = header_.color_type == SPNG_COLOR_TYPE_GRAYSCALE_ALPHA ||
               header_.color_type == SPNG_COLOR_TYPE_TRUECOLOR_ALPHA || has_transparency == SPNG_OK;
  if (header_.bit_depth < 16) {
    return has_alpha_ || wants_alpha_ ? decode_as(SPNG_FMT_RGBA8, PixelFormat::rgba8)
                                      : decode_as(SPNG_FMT_RGB8, PixelFormat::rgb8);
  }
  if (has_alpha_ || wants_alpha_) return decode_as(SPNG_FMT_RGBA16, PixelFormat::rgba16);
  if (header_.color_type == SPNG_COLOR_TYPE_TRUECOLOR) {
    return decode_as(SPNG_FMT_PNG, PixelFormat::rgb16);
  }
  // The library makes no gray image rgb16.
  Result<Image> image = decode_as(SPNG_FMT_RGBA16, PixelFormat::rgba16);
  if (!image || image->format == PixelFormat::rgb16) return image;
  return without_alpha16(*image);
}

Result<Image> Decoder::without_alpha16(const Image& from) {
  Image to{from.width, from.height, PixelFormat::rgb16, {}};
  SFUMATO_TRY(make_room(to));
  RarePoll<65536> poll(context_);
  const std::size_t pixel_count = from.bytes.size() / 8;
  for (std::size_t i = 0; i < pixel_count; ++i) {
    if (poll.cancelled()) return context_.cancel_status();
    std::memcpy(&to.bytes[6 * i], &from.bytes[8 * i], 6);
  }
  return to;
}

Status Decoder::make_room(Image& image) {
  const std::size_t size = image.row_bytes() * header_.height;
  Status status = memory_.resize(context_, image.bytes, size);
  if (status.code == StatusCode::limit) status.where.file = file_;
  return status;
}

/// Decodes row by row, so that the work can be cancelled; interlaced images come row by row in
/// seven passes.
Status Decoder::for_each_row(int spng_format, int flags, std::size_t row_bytes,
                             FunctionRef<std::uint8_t*(const spng_row_info&)> room,
                             FunctionRef<void(const spng_row_info&)> take) {
  int code =
      spng_decode_image(png_.get(), nullptr, 0, spng_format, flags | SPNG_DECODE_PROGRESSIVE);
  while (code == SPNG_OK) {
    if (context_.cancelled()) return context_.cancel_status();
    spng_row_info row{};
    code = spng_get_row_info(png_.get(), &row);
    if (code != SPNG_OK) break;
    code = spng_decode_row(png_.get(), room(row), row_bytes);
    if (code == SPNG_OK || code == SPNG_EOI) take(row);
  }
  return status_of(code == SPNG_EOI ? SPNG_OK : code);
}

Status Decoder::decode_rows(int spng_format, int flags, Image& image) {
  return for_each_row(
      spng_format, flags, image.row_bytes(),
      [&](const spng_row_info& row) { return &image.bytes[row.row_num * image.row_bytes()]; },
      [](const spng_row_info&) {});
}

bool Decoder::is_to_shrink(const Image& image) const {
  const int longer = std::max(image.width, image.height);
  return shrink_.side > 0 && longer > shrink_.side &&
         image.row_bytes() * header_.height > shrink_.whole_bytes;
}

/// Decodes with one row in memory at a time. In an interlaced image a row of a pass has some of the
/// pixels.
Status Decoder::decode_smaller(int spng_format, int flags, Image& image) {
  constexpr codecs::RowShrinker::Columns kPasses[] = {{0, 8}, {4, 8}, {0, 4}, {2, 4},
                                                      {0, 2}, {1, 2}, {0, 1}};
  const bool is_interlaced = header_.interlace_method != SPNG_INTERLACE_NONE;
  const bool has_alpha = has_alpha_ || wants_alpha_;
  codecs::RowShrinker shrinker;
  TableMemory memory("a PNG image");
  std::vector<std::uint8_t> bytes;
  SFUMATO_TRY(memory.resize(context_, bytes, image.row_bytes()));
  SFUMATO_TRY(shrinker.create(context_, image.width, image.height, image.format, shrink_.side));
  SFUMATO_TRY(for_each_row(
      spng_format, flags, bytes.size(), [&](const spng_row_info&) { return bytes.data(); },
      [&](const spng_row_info& row) {
        const auto pass = static_cast<std::size_t>(row.pass);
        const codecs::RowShrinker::Columns all;
        shrinker.add(row.row_num, bytes, is_interlaced ? kPasses[pass] : all);
      }));
  return shrinker.finish(context_, has_alpha, memory_, image);
}

Result<Image> Decoder::decode_as(int spng_format, PixelFormat format) {
  Image image{static_cast<int>(header_.width), static_cast<int>(header_.height), format, {}};
  const int flags = has_alpha_ ? SPNG_DECODE_TRNS : 0;
  if (is_to_shrink(image)) {
    SFUMATO_TRY(decode_smaller(spng_format, flags, image));
  } else {
    SFUMATO_TRY(make_room(image));
    SFUMATO_TRY(decode_rows(spng_format, flags, image));
  }
  SFUMATO_TRY(status_of(spng_decode_chunks(png_.get())));
  // The library reads no farther than it needs pixels.
  if (!has_chunk(bytes_, "IEND")) {
    return error(StatusCode::bad_input, "the PNG image is damaged: it has no end");
  }
  return image;
}

void Decoder::find_colors(codecs::PngPhoto& photo) {
  photo.is_gray = header_.color_type == SPNG_COLOR_TYPE_GRAYSCALE ||
                  header_.color_type == SPNG_COLOR_TYPE_GRAYSCALE_ALPHA;
  std::uint8_t intent = 0;
  photo.is_srgb = spng_get_srgb(png_.get(), &intent) == SPNG_OK;
  double gamma = 0;
  if (spng_get_gama(png_.get(), &gamma) == SPNG_OK) photo.gamma = gamma;
  spng_chrm chroma{};
  if (spng_get_chrm(png_.get(), &chroma) == SPNG_OK) {
    photo.chroma = {{{chroma.white_point_x, chroma.white_point_y},
                     {chroma.red_x, chroma.red_y},
                     {chroma.green_x, chroma.green_y},
                     {chroma.blue_x, chroma.blue_y}}};
  }
}

Status Decoder::find_profile(codecs::PngPhoto& photo) {
  photo.has_profile = has_chunk(bytes_, "iCCP");
  spng_iccp profile{};
  if (spng_get_iccp(png_.get(), &profile) != SPNG_OK) return ok_status();
  return memory_.append(context_, std::string_view(profile.profile, profile.profile_len),
                        photo.profile);
}

Status Decoder::find_exif(codecs::PngPhoto& photo) {
  spng_exif exif{};
  if (spng_get_exif(png_.get(), &exif) != SPNG_OK) return ok_status();
  return memory_.append(context_, std::string_view(exif.data, exif.length), photo.exif);
}

Result<codecs::PngPhoto> Decoder::decode_photo() {
  codecs::PngPhoto photo;
  SFUMATO_TRY_ASSIGN(photo.image, decode());
  photo.width = static_cast<int>(header_.width);
  photo.height = static_cast<int>(header_.height);
  find_colors(photo);
  SFUMATO_TRY(find_profile(photo));
  SFUMATO_TRY(find_exif(photo));
  return photo;
}

}  // namespace

namespace codecs {

Result<PngPhoto> decode_png_photo(Context& context, std::span<const std::uint8_t> bytes,
                                  const std::string& file, const PhotoShrink& shrink) {
  return public_verb(context,
                     [&] { return Decoder(context, bytes, file, false, shrink).decode_photo(); });
}

}  // namespace codecs

Result<Image> decode_png(Context& context, std::span<const std::uint8_t> bytes,
                         const std::string& file) {
  return public_verb(context, [&] { return Decoder(context, bytes, file, false).decode(); });
}

Result<Image> decode_png_with_alpha(Context& context, std::span<const std::uint8_t> bytes,
                                    const std::string& file) {
  return public_verb(context, [&] { return Decoder(context, bytes, file, true).decode(); });
}

}  // namespace sfumato
