#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "base/output_buffer.hpp"

namespace sfumato::outputs {

/// Bytes of the viewer's payload (docs/viewer.md, "Payload"), least significant first. A failure is
/// kept, as in OutputBuffer.
class ByteWriter {
 public:
  explicit ByteWriter(const Context& context) : bytes_(context, "the viewer's payload") {}

  void u8(std::uint8_t value) { bytes_.push_back(value); }
  void f32(float value) { little_endian(std::bit_cast<std::uint32_t>(value), 4); }
  void f64(double value) { little_endian(std::bit_cast<std::uint64_t>(value), 8); }

  /// Seven bits a byte, the lowest first; the highest bit says that more follow.
  void varint(std::uint64_t value) {
    for (; value >= 0x80; value >>= 7) u8(static_cast<std::uint8_t>(value | 0x80));
    u8(static_cast<std::uint8_t>(value));
  }

  void raw(std::span<const std::uint8_t> bytes) { bytes_.append(bytes); }

  /// Their number, then the bytes.
  void counted(std::span<const std::uint8_t> bytes) {
    varint(bytes.size());
    raw(bytes);
  }

  /// The lowest bytes of all values, then the next ones, `byte_count` of each. Similar bytes are
  /// then adjacent, which deflate compresses well.
  void planes(std::span<const std::uint32_t> values, int byte_count) {
    bytes_.reserve(values.size() * static_cast<std::size_t>(byte_count));
    for (int shift = 0; shift < 8 * byte_count; shift += 8)
      for (std::uint32_t value : values) u8(static_cast<std::uint8_t>(value >> shift));
  }

  const Status& status() const { return bytes_.status(); }

  /// Returns the written bytes, or the error. The charge lasts while this object exists.
  Result<std::vector<std::uint8_t>> finish() { return bytes_.finish(); }

 private:
  void little_endian(std::uint64_t value, int byte_count) {
    for (int i = 0; i < byte_count; ++i) u8(static_cast<std::uint8_t>(value >> (8 * i)));
  }

  OutputBuffer bytes_;
};

/// Maps a signed number to an unsigned one that is small if the magnitude is small: 0, -1, 1, -2, …
constexpr std::uint32_t zigzag(std::int32_t value) {
  return static_cast<std::uint32_t>(value) << 1 ^ static_cast<std::uint32_t>(value >> 31);
}

}  // namespace sfumato::outputs
