// PNG files. Bytes that begin like a PNG get correct checksums, because otherwise no changed byte
// would pass them. Other bytes become a PNG: header, palette, transparency, rows.
#include <zlib.h>

#include <string_view>
#include <vector>

#include "codecs/image_file.hpp"
#include "fuzz.hpp"
#include "png_file.hpp"
#include "sfumato/codecs/png.hpp"

using namespace sfumato;

namespace {

/// Memory for the largest image: larger ones would be slow without running other code.
constexpr std::size_t kPngBudgetBytes = std::size_t{1} << 20;

using fuzz::File;

void append_big_endian(std::uint32_t number, File& file) {
  for (int shift = 24; shift >= 0; shift -= 8) {
    file.push_back(static_cast<std::uint8_t>(number >> shift));
  }
}

void add_chunk(File& file, std::string_view type, const File& content) {
  append_big_endian(static_cast<std::uint32_t>(content.size()), file);
  const std::size_t at = file.size();
  for (const char c : type) file.push_back(static_cast<std::uint8_t>(c));
  for (const std::uint8_t byte : content) file.push_back(byte);
  append_big_endian(fuzz::png_checksum(&file[at], file.size() - at), file);
}

File packed(fuzz::Bytes rows) {
  uLongf size = compressBound(static_cast<uLong>(rows.size()));
  File result(size);
  compress2(result.data(), &size, rows.data(), static_cast<uLong>(rows.size()), 1);
  result.resize(size);
  return result;
}

/// Builds a file from width, height, depth, kind, interlace, the sizes of the palette and of tRNS,
/// their bytes, and rows.
File composed(fuzz::Bytes bytes) {
  fuzz::ByteReader reader(bytes);
  File header;
  append_big_endian(reader.byte(), header);
  append_big_endian(reader.byte(), header);
  constexpr std::uint8_t kDepths[] = {1, 2, 4, 8, 16, 0, 3, 32};
  constexpr std::uint8_t kKinds[] = {0, 2, 3, 4, 6, 1, 5, 255};
  header.push_back(kDepths[reader.below(8)]);
  header.push_back(kKinds[reader.below(8)]);
  header.insert(header.end(), 2, 0);
  header.push_back(static_cast<std::uint8_t>(reader.below(3)));
  const auto take = [&reader](unsigned count) {
    File taken;
    for (unsigned i = 0; i < count && !reader.at_end(); ++i) taken.push_back(reader.byte());
    return taken;
  };
  const File palette = take(reader.byte()), transparency = take(reader.below(64));
  File file;
  for (const std::uint8_t byte : fuzz::kPngSignature) file.push_back(byte);
  add_chunk(file, "IHDR", header);
  if (!palette.empty()) add_chunk(file, "PLTE", palette);
  if (!transparency.empty()) add_chunk(file, "tRNS", transparency);
  add_chunk(file, "IDAT", packed(reader.rest()));
  add_chunk(file, "IEND", {});
  return file;
}

void check_size(const Image& image) {
  fuzz::require(image.width > 0 && image.height > 0, "an image of no pixels");
  fuzz::require(image.bytes.size() == image.row_bytes() * static_cast<std::size_t>(image.height),
                "an image of another size than its bytes");
}

/// Requires that the image is the same after writing and reading.
void check_round_trip(const Image& image) {
  Context context;
  const Result<std::vector<std::uint8_t>> png = encode_png(context, image);
  fuzz::require_ok(png.status(), "a decoded image cannot be encoded");
  const Result<Image> again = decode_png(context, *png, "again.png");
  fuzz::require_ok(again.status(), "an encoded image cannot be decoded");
  fuzz::require(again->width == image.width && again->height == image.height &&
                    again->format == image.format && again->bytes == image.bytes,
                "an image changed on its way through a file");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fuzz::Bytes bytes(data, size);
  const File file = fuzz::is_png(bytes) ? fuzz::with_checksums(bytes) : composed(bytes);
  Context context{.budget = Budget(kPngBudgetBytes)};
  const Result<Image> image = decode_png(context, file, "fuzz.png");
  const Result<codecs::RgbaImage> texture = codecs::decode_image(context, file);
  fuzz::require(context.budget.used() == 0, "a decoder keeps what it charged");
  if (image) {
    check_size(*image);
    check_round_trip(*image);
  } else {
    fuzz::require_honest(image.status());
  }
  if (texture) {
    fuzz::require(image.ok(), "a texture that is no image");
    fuzz::require(texture->rgba.size() == 4 * static_cast<std::size_t>(texture->width) *
                                              static_cast<std::size_t>(texture->height),
                  "a texture of another size than its bytes");
  } else {
    fuzz::require_honest(texture.status());
  }
  return 0;
}
