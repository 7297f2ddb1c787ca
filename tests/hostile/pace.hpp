#pragma once

#include <limits>
#include <string>

#include "hostile/sandbox.hpp"
#include "support/sanitizers.hpp"

namespace sfumato::hostile {

/// Limit for the processor time of a case, all threads together, as a multiple of the reference's
/// time. The slowest case takes 11 times as much (README.md). Sanitizers slow down readers more
/// than drawing.
constexpr double kMostReferences = SFUMATO_HAS_SANITIZER ? 60 : 25;

/// The reference: the command draws a fixed drawing. The time limit is a multiple of its time in
/// the same run, so that a slow or busy machine lengthens both.
class Pace {
 public:
  explicit Pace(const std::string& binary);

  /// Returns the processor time, seconds, allowed to a case that has just taken `taken`. Runs the
  /// reference only if `taken` is not short and earlier runs do not allow it.
  double granted_seconds(double taken);

 private:
  double run() const;

  const std::string& binary_;
  Sandbox sandbox_;
  double least_ = std::numeric_limits<double>::infinity();
};

}  // namespace sfumato::hostile
