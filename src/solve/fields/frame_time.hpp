#pragma once

#include <limits>
#include <optional>

#include "base/stopwatch.hpp"

namespace sfumato::solve {

/// The time limit of a frame of a drag, counted from the construction of this object.
class FrameTime {
 public:
  FrameTime() = default;
  /// seconds   at least 0; empty or infinity: no limit
  explicit FrameTime(std::optional<double> seconds) : seconds_(seconds.value_or(kNoLimit)) {}

  bool is_limited() const { return seconds_ < kNoLimit; }

  /// Returns the remaining seconds, at least 0.
  double seconds_left() const {
    if (!is_limited()) return seconds_;
    const double left = seconds_ - watch_.seconds();
    return left > 0 ? left : 0;
  }

 private:
  static constexpr double kNoLimit = std::numeric_limits<double>::infinity();

  double seconds_ = kNoLimit;
  Stopwatch watch_;
};

}  // namespace sfumato::solve
