#include "base/angle.hpp"

#include <cmath>
#include <numbers>

namespace sfumato {
namespace {

// Computes Taylor's series on ±45°: the first omitted term is below 1e-18.
double sine(double x) {
  const double s = x * x;
  double sum = 0;
  for (int k = 17; k >= 3; k -= 2) sum = (1 - sum) * s / (k * (k - 1));
  return x * (1 - sum);
}

double cosine(double x) {
  const double s = x * x;
  double sum = 0;
  for (int k = 18; k >= 2; k -= 2) sum = (1 - sum) * s / (k * (k - 1));
  return 1 - sum;
}

}  // namespace

SinCos sin_cos_degrees(double degrees) {
  const double turn = std::fmod(degrees, 360.0);
  const double quarter = std::floor(turn / 90 + 0.5);
  const double rest = (turn - 90 * quarter) * (std::numbers::pi / 180);
  const double s = sine(rest), c = cosine(rest);
  switch (static_cast<int>(quarter) & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

}  // namespace sfumato
