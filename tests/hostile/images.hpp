#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

/// PNG and JPEG files, valid and invalid.
namespace sfumato::hostile {

/// Returns a PNG chunk with its length and CRC.
std::string png_chunk(const std::string& type, const std::string& data);

struct PngHeader {
  std::uint32_t width = 15;
  std::uint32_t height = 15;
  int depth = 8;
  int color_type = 2;  ///< 0 gray, 2 RGB, 3 palette, 4 gray and alpha, 6 RGBA
  int compression = 0;
  int filter = 0;
  int interlace = 0;
};

inline const std::string kPngSignature = "\x89PNG\r\n\x1a\n";
std::string png_header(const PngHeader& header);

/// Returns a PNG with this header: `data` packed into one IDAT, after `before`.
std::string png(const PngHeader& header, const std::string& data, const std::string& before = "");

/// Returns a PNG of 15 × 15 RGB pixels.
std::string good_png();

/// Returns a PNG of so many rows of zeros, packed without using their memory.
std::string png_of_zeros(const PngHeader& header, std::size_t row_bytes);

std::string zlib_packed(const std::string& data);
std::string zlib_of_zeros(std::size_t count);

enum class JpegKind { baseline, progressive, arithmetic, arithmetic_progressive };

/// Returns a JPEG of one colour; 1 channel is gray, 3 are RGB, 4 CMYK.
std::string jpeg(int width, int height, int channels, JpegKind kind);

/// Returns a progressive gray JPEG with repeated scans.
std::string jpeg_of_scans(int width, int height, int scan_count);

/// Returns the offset of a marker's 0xFF, by the byte after it; npos if there is none.
std::size_t jpeg_marker(const std::string& jpeg, unsigned char marker);

/// Returns the file with another size in its header.
std::string jpeg_of_size(std::string jpeg, unsigned width, unsigned height);

std::string base64(const std::string& bytes);

}  // namespace sfumato::hostile
