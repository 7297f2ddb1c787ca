#pragma once

#include <bit>
#include <cstdint>

namespace sfumato {

/// Returns the n-th root of x > 0. Dividing the exponent by n is right within 7 %, and each Newton
/// step squares the error. The bits are the same on every machine.
template <int kDegree>
double root(double x) {
  constexpr int kSteps = 5;
  constexpr std::uint64_t kOne = std::bit_cast<std::uint64_t>(1.0);
  double y =
      std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) / kDegree + (kOne - kOne / kDegree));
  for (int step = 0; step < kSteps; ++step) {
    double power = y;
    for (int i = 2; i < kDegree; ++i) power *= y;
    y += (x / power - y) / kDegree;
  }
  return y;
}

inline double cube_root(double x) {
  if (x == 0) return 0;
  return x < 0 ? -root<3>(-x) : root<3>(x);
}

}  // namespace sfumato
