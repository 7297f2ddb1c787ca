#pragma once

#include <limits>

#include "base/stopwatch.hpp"

namespace sfumato::solve {

/// How long a frame of a drag may take, counted from the construction of this.
class FrameTime {
 public:
  FrameTime() = default;
  /// seconds   at least 0; infinity: as long as it takes
  explicit FrameTime(double seconds) : seconds_(seconds) {}

  bool is_limited() const { return seconds_ < std::numeric_limits<double>::infinity(); }

  /// What is left, at least 0.
  double seconds_left() const {
    if (!is_limited()) return seconds_;
    const double left = seconds_ - watch_.seconds();
    return left > 0 ? left : 0;
  }

 private:
  double seconds_ = std::numeric_limits<double>::infinity();
  Stopwatch watch_;
};

}  // namespace sfumato::solve
