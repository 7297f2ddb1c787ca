#include "hostile/images.hpp"

#include <zlib.h>

#include <cstddef>
#include <cstdio>
#include <cstdlib>
// jpeglib.h needs size_t and FILE before it.
#include <jpeglib.h>

#include <algorithm>

#include "codecs/base64.hpp"
#include "hostile/packer.hpp"

namespace sfumato::hostile {
namespace {

std::string big_end_first(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift);
  return bytes;
}

std::string chunk_with_crc(const std::string& type, const std::string& data) {
  const std::string body = type + data;
  const uLong crc =
      crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
  return big_end_first(static_cast<std::uint32_t>(data.size())) + body +
         big_end_first(static_cast<std::uint32_t>(crc));
}

/// Encodes one colour with an encoder that is set up except for its kind.
std::string encoded(jpeg_compress_struct& encoder, int channels) {
  unsigned char* memory = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&encoder, &memory, &size);
  jpeg_start_compress(&encoder, TRUE);
  std::vector<std::uint8_t> row(std::size_t{encoder.image_width} *
                                static_cast<std::size_t>(channels));
  for (std::size_t i = 0; i < row.size(); ++i)
    row[i] = static_cast<std::uint8_t>(90 * (i % static_cast<std::size_t>(channels)));
  while (encoder.next_scanline < encoder.image_height) {
    JSAMPROW rows = row.data();
    jpeg_write_scanlines(&encoder, &rows, 1);
  }
  jpeg_finish_compress(&encoder);
  std::string bytes(reinterpret_cast<const char*>(memory), size);
  std::free(memory);
  return bytes;
}

/// An encoder that is destroyed with its scope.
class Encoder {
 public:
  Encoder(int width, int height, int channels) {
    state_.err = jpeg_std_error(&errors_);
    jpeg_create_compress(&state_);
    state_.image_width = static_cast<JDIMENSION>(width);
    state_.image_height = static_cast<JDIMENSION>(height);
    state_.input_components = channels;
    state_.in_color_space = channels == 1 ? JCS_GRAYSCALE : channels == 3 ? JCS_RGB : JCS_CMYK;
    jpeg_set_defaults(&state_);
  }
  ~Encoder() { jpeg_destroy_compress(&state_); }
  Encoder(const Encoder&) = delete;
  Encoder& operator=(const Encoder&) = delete;

  jpeg_compress_struct& state() { return state_; }

 private:
  jpeg_compress_struct state_{};
  jpeg_error_mgr errors_{};
};

}  // namespace

std::string png_chunk(const std::string& type, const std::string& data) {
  return chunk_with_crc(type, data);
}

std::string png_header(const PngHeader& header) {
  std::string data = big_end_first(header.width) + big_end_first(header.height);
  for (const int value :
       {header.depth, header.color_type, header.compression, header.filter, header.interlace}) {
    data += static_cast<char>(value);
  }
  return kPngSignature + png_chunk("IHDR", data);
}

std::string png(const PngHeader& header, const std::string& data, const std::string& before) {
  return png_header(header) + before + png_chunk("IDAT", zlib_packed(data)) + png_chunk("IEND", "");
}

std::string good_png() {
  std::string rows;
  for (int y = 0; y < 15; ++y) {
    rows += '\0';
    for (int i = 0; i < 45; ++i) rows += static_cast<char>(37 * (45 * y + i));
  }
  return png({}, rows);
}

std::string png_of_zeros(const PngHeader& header, std::size_t row_bytes) {
  return png_header(header) +
         png_chunk("IDAT", zlib_of_zeros((row_bytes + 1) * std::size_t{header.height})) +
         png_chunk("IEND", "");
}

std::string zlib_packed(const std::string& data) {
  Packer packer(Wrapper::zlib);
  packer.add(data, Z_FINISH);
  return packer.packed();
}

std::string zlib_of_zeros(std::size_t count) {
  return packed_run(Wrapper::zlib, '\0', count);
}

std::string jpeg(int width, int height, int channels, JpegKind kind) {
  Encoder encoder(width, height, channels);
  const bool is_arithmetic =
      kind == JpegKind::arithmetic || kind == JpegKind::arithmetic_progressive;
  encoder.state().arith_code = is_arithmetic ? TRUE : FALSE;
  if (kind == JpegKind::progressive || kind == JpegKind::arithmetic_progressive) {
    jpeg_simple_progression(&encoder.state());
  }
  return encoded(encoder.state(), channels);
}

std::string jpeg_of_scans(int width, int height, int scan_count) {
  // The first scan of coefficient 1 and its refinement are written repeatedly.
  Encoder encoder(width, height, 1);
  const jpeg_scan_info scans[] = {{1, {0}, 0, 0, 0, 0}, {1, {0}, 1, 63, 0, 0}};
  encoder.state().scan_info = scans;
  encoder.state().num_scans = 2;
  const std::string whole = encoded(encoder.state(), 1);
  const std::size_t first = jpeg_marker(whole, 0xDA);
  std::size_t second = jpeg_marker(whole.substr(first + 2), 0xC4);
  if (second == std::string::npos) second = jpeg_marker(whole.substr(first + 2), 0xDA);
  second += first + 2;
  const std::string scan = whole.substr(second, whole.size() - second - 2);
  std::string bytes = whole.substr(0, second);
  for (int i = 0; i < scan_count; ++i) bytes += scan;
  return bytes + "\xFF\xD9";
}

std::size_t jpeg_marker(const std::string& jpeg, unsigned char marker) {
  return jpeg.find(std::string("\xFF") + static_cast<char>(marker));
}

std::string jpeg_of_size(std::string jpeg, unsigned width, unsigned height) {
  std::size_t frame = std::string::npos;
  for (const unsigned char marker : {0xC0, 0xC1, 0xC2, 0xC9, 0xCA}) {
    if (frame == std::string::npos) frame = jpeg_marker(jpeg, marker);
  }
  jpeg[frame + 5] = static_cast<char>(height >> 8);
  jpeg[frame + 6] = static_cast<char>(height);
  jpeg[frame + 7] = static_cast<char>(width >> 8);
  jpeg[frame + 8] = static_cast<char>(width);
  return jpeg;
}

std::string base64(const std::string& bytes) {
  return codecs::encode_base64({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

}  // namespace sfumato::hostile
