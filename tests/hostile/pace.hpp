#pragma once

#include <limits>
#include <string>

#include "hostile/sandbox.hpp"
#include "support/sanitizers.hpp"

namespace sfumato::hostile {

/// A case may take so many times the processor time of the reference, all threads together. The
/// slowest case takes 11 times as much (README.md). Sanitizers slow readers down more than
/// drawing.
constexpr double kMostReferences = SFUMATO_HAS_SANITIZER ? 60 : 25;

/// The reference: the command draws a fixed drawing. The limit on time is a multiple of what that
/// takes in the same run, so that a slow or busy machine lengthens both.
class Pace {
 public:
  explicit Pace(const std::string& binary);

  /// Returns the processor time, seconds, that a case was granted which took `taken` just before.
  /// Runs the reference only where `taken` is not little, and earlier runs do not grant it.
  double granted_seconds(double taken);

 private:
  double run() const;

  const std::string& binary_;
  Sandbox sandbox_;
  double least_ = std::numeric_limits<double>::infinity();
};

}  // namespace sfumato::hostile
