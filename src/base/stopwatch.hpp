#pragma once

#if !defined(__wasm__)
#include <chrono>
#endif

namespace sfumato {

/// Wall-clock seconds since the start. 0 always in WebAssembly, where the core has no clock.
class Stopwatch {
 public:
#if defined(__wasm__)
  double seconds() const {
    return 0;
  }
#else
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
#endif
};

}  // namespace sfumato
