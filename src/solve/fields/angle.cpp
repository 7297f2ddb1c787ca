#include "solve/fields/angle.hpp"

#include <cmath>
#include <numbers>

namespace sfumato::solve {
namespace {

/// Returns atan(x) for |x| ≤ tan(π/8): the Taylor series, whose next term is below 1e-8 there.
double small_arctangent(double x) {
  const double y = x * x;
  double sum = 1.0 / 17;
  for (int n = 15; n >= 1; n -= 2) sum = 1.0 / n - y * sum;
  return x * sum;
}

/// Returns atan(y / x) for 0 ≤ y ≤ x: the half angle first, which is at most π/8.
double octant_arctangent(double y, double x) {
  return 2 * small_arctangent(y / (x + std::sqrt(x * x + y * y)));
}

}  // namespace

double turn_angle(Vec2 a, Vec2 b) {
  constexpr double pi = std::numbers::pi;
  const double x = dot(a, b), y = cross(a, b);
  const double ax = std::fabs(x), ay = std::fabs(y);
  if (ax == 0 && ay == 0) return 0;
  double angle = ay <= ax ? octant_arctangent(ay, ax) : pi / 2 - octant_arctangent(ax, ay);
  if (x < 0) angle = pi - angle;
  return y < 0 ? 2 * pi - angle : angle;
}

}  // namespace sfumato::solve
