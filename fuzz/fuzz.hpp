#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>
#include <string_view>

#include "sfumato/base/context.hpp"

/// Shared by the targets of this folder. A target is one function of bytes; it may refuse them, but
/// must never crash, hang or give a wrong answer.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace sfumato::fuzz {

using Bytes = std::span<const std::uint8_t>;

inline std::string_view as_text(Bytes bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Ends the program if a promise is broken; the fuzzer takes this as a find.
inline void require(bool holds, std::string_view promise) {
  if (holds) return;
  std::fprintf(stderr, "broken promise: %.*s\n", static_cast<int>(promise.size()), promise.data());
  std::abort();
}

inline void require_ok(const Status& status, std::string_view what) {
  if (status) return;
  require(false, std::string(what) + ": " + to_string(status));
}

/// Requires that a refusal has a code that input can cause, and a message.
inline void require_honest(const Status& status) {
  require(status.code == StatusCode::bad_input || status.code == StatusCode::limit,
          "an error of input has another code: " + to_string(status));
  require(!status.message.empty(), "an error without a message");
}

/// The budget of the targets' contexts: one thread, and so little memory that large inputs are
/// refused at once.
inline constexpr std::size_t kBudgetBytes = std::size_t{48} << 20;

/// Turns bytes into numbers; after the end, all numbers are zero.
class ByteReader {
 public:
  explicit ByteReader(Bytes bytes) : rest_(bytes) {}

  bool at_end() const { return rest_.empty(); }
  Bytes rest() const { return rest_; }

  std::uint8_t byte() {
    if (rest_.empty()) return 0;
    const std::uint8_t first = rest_.front();
    rest_ = rest_.subspan(1);
    return first;
  }
  unsigned word() {
    const unsigned high = byte();
    return high << 8 | byte();
  }
  /// 0 to n - 1, for n up to 256.
  unsigned below(unsigned n) { return byte() % n; }
  /// Returns a number from 0 to 1, both included.
  double unit() { return byte() / 255.0; }

 private:
  Bytes rest_;
};

}  // namespace sfumato::fuzz
