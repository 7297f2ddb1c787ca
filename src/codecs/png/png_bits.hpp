#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace sfumato::codecs {

/// Writes bits as deflate orders them, the lowest first.
class BitWriter {
 public:
  /// Bytes after the valid ones that are written as well, because whole words are faster.
  static constexpr std::size_t kSlack = sizeof(std::uint64_t);

  explicit BitWriter(std::uint8_t* out) : out_(out) {}

  /// Appends bits, at most 57 in all until flush().
  void put(std::uint64_t bits, int bit_count) {
    bits_ |= bits << bit_count_;
    bit_count_ += bit_count;
  }

  void flush() {
    for (std::size_t i = 0; i < kSlack; ++i) {
      out_[i] = static_cast<std::uint8_t>(bits_ >> (8 * i));
    }
    out_ += bit_count_ >> 3;
    bits_ >>= bit_count_ & ~7;
    bit_count_ &= 7;
  }

  /// Fills up the last byte with zeros.
  void align() {
    bit_count_ = (bit_count_ + 7) & ~7;
    flush();
  }

  /// When aligned.
  void copy(std::span<const std::uint8_t> bytes) {
    out_ = std::copy(bytes.begin(), bytes.end(), out_);
  }

  /// Returns the place after the last whole byte.
  const std::uint8_t* end() const { return out_; }

 private:
  std::uint8_t* out_;
  std::uint64_t bits_ = 0;
  int bit_count_ = 0;
};

}  // namespace sfumato::codecs
