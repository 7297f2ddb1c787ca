#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace sfumato {

/// Writes bits, lowest first, to memory that the caller sized: whole words are stored, so
/// kSlackBytes beyond the last byte must be writable.
class BitWriter {
 public:
  static constexpr std::size_t kSlackBytes = 8;
  /// As many bits may be put between two flushes.
  static constexpr int kBitsPerFlush = 56;

  explicit BitWriter(std::uint8_t* at) : at_(at) {}

  /// Precondition: bits < 2^count.
  void put(std::uint64_t bits, int count) {
    buffer_ |= bits << count_;
    count_ += count;
  }

  void flush() {
    std::uint64_t word = buffer_;
    if constexpr (std::endian::native == std::endian::big) word = __builtin_bswap64(word);
    std::memcpy(at_, &word, sizeof(word));
    const int whole_bytes = count_ >> 3;
    at_ += whole_bytes;
    buffer_ >>= 8 * whole_bytes;
    count_ &= 7;
  }

 private:
  std::uint8_t* at_;
  std::uint64_t buffer_ = 0;
  int count_ = 0;
};

}  // namespace sfumato
