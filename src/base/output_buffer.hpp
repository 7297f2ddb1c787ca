#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato {

/// A file, text or bytes, while it is written. Its memory is charged to the Context's Budget, and
/// its capacity at least doubles when it grows. A failure is kept: from then on nothing is
/// appended, and status() and finish() return it, so that a writer need not check after each piece.
/// Loops over many pieces check status() and the cancel flag from time to time. Not thread-safe.
class OutputBuffer {
 public:
  /// purpose   the content, for the message of a limit error: "the SVG"; a literal
  OutputBuffer(const Context& context, std::string_view purpose)
      : context_(context), memory_(purpose) {}

  OutputBuffer& operator+=(std::string_view text) {
    append({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    return *this;
  }
  OutputBuffer& operator+=(char c) { return *this += std::string_view(&c, 1); }

  void push_back(std::uint8_t byte) {
    if (bytes_.size() == bytes_.capacity()) return append_large({&byte, 1});
    bytes_.push_back(byte);
  }

  void append(std::span<const std::uint8_t> bytes) {
    if (bytes.size() > bytes_.capacity() - bytes_.size() || bytes.size() > kSmall) {
      append_large(bytes);
    } else {
      bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    }
  }

  /// Reserves room for `size` more bytes, so that appending them needs no reallocation.
  void reserve(std::size_t size);

  /// Returns the text so far, valid until more is written; empty after a failure.
  std::string_view text() const {
    return {reinterpret_cast<const char*>(bytes_.data()), bytes_.size()};
  }
  /// Returns the bytes so far.
  std::size_t size() const { return bytes_.size(); }
  /// Returns ok, or the reason why nothing more is appended: limit (memory), cancelled, or the
  /// status given to fail().
  const Status& status() const { return status_; }
  /// Stops the writing with this failure, unless it has failed already or `status` is ok.
  void fail(Status status);

  /// Returns the content, or the failure. The charge lasts as long as this object.
  Result<std::vector<std::uint8_t>> finish();

 private:
  static constexpr std::size_t kSmall = std::size_t{64} << 10;

  void append_large(std::span<const std::uint8_t> bytes);

  const Context& context_;
  TableMemory memory_;
  std::vector<std::uint8_t> bytes_;
  Status status_;
};

}  // namespace sfumato
