#pragma once

#include <limits>
#include <optional>

#include "base/stopwatch.hpp"

namespace sfumato::solve {

/// How long a frame of a drag may take, counted from the construction of this.
class FrameTime {
 public:
  FrameTime() = default;
  /// seconds   at least 0; none, or infinity: as long as it takes
  explicit FrameTime(std::optional<double> seconds) : seconds_(seconds.value_or(kNoLimit)) {}

  bool is_limited() const { return seconds_ < kNoLimit; }

  /// What is left, at least 0.
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
