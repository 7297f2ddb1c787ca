#pragma once

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "fuzz.hpp"

/// Builds PNG files for the targets.
namespace sfumato::fuzz {

using File = std::vector<std::uint8_t>;

inline constexpr std::array<std::uint8_t, 8> kPngSignature{0x89, 'P',  'N',  'G',
                                                           '\r', '\n', 0x1a, '\n'};

inline std::uint32_t big_endian(const std::uint8_t* bytes) {
  return std::uint32_t{bytes[0]} << 24 | std::uint32_t{bytes[1]} << 16 |
         std::uint32_t{bytes[2]} << 8 | bytes[3];
}

inline void put_big_endian(std::uint32_t number, std::span<std::uint8_t> four_bytes) {
  for (std::uint8_t& byte : four_bytes) {
    byte = static_cast<std::uint8_t>(number >> 24);
    number <<= 8;
  }
}

inline std::uint32_t png_checksum(const std::uint8_t* bytes, std::size_t count) {
  return static_cast<std::uint32_t>(crc32(0, bytes, static_cast<uInt>(count)));
}

/// Returns the file with correct checksums, because otherwise no changed byte would pass them.
inline File with_checksums(Bytes bytes) {
  File file(bytes.begin(), bytes.end());
  for (std::size_t at = kPngSignature.size(); at + 12 <= file.size();) {
    const std::size_t length = big_endian(&file[at]);
    if (length > file.size() - at - 12) break;
    put_big_endian(png_checksum(&file[at + 4], length + 4),
                   std::span(file).subspan(at + 8 + length, 4));
    at += length + 12;
  }
  return file;
}

/// Returns whether bytes begin like a PNG.
inline bool is_png(Bytes bytes) {
  return bytes.size() >= kPngSignature.size() &&
         std::equal(kPngSignature.begin(), kPngSignature.end(), bytes.begin());
}

}  // namespace sfumato::fuzz
