#pragma once

#include <chrono>

namespace sfumato {

/// Measures wall-clock seconds since the start. In WebAssembly the host provides the clock (WASI's
/// clock_time_get).
class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace sfumato
