#include "color/transfer.hpp"

#include <cmath>

#include "base/root.hpp"
#include "sfumato/base/color_space.hpp"

namespace sfumato::color {
namespace {

/// Extends `transfer`, which is right from 0 on, to an odd function.
template <class Transfer>
double mirrored(double x, Transfer transfer) {
  return x < 0 ? -transfer(-x) : transfer(x);
}

/// Returns x^(563/256) by square roots: 563/256 = 2 + 1/8 + 1/16 + 1/128 + 1/256.
double a98_power(double x) {
  double power = x * x;
  double part = x;
  for (int halvings = 1; halvings <= 8; ++halvings) {
    part = std::sqrt(part);
    const bool is_factor = halvings == 3 || halvings == 4 || halvings >= 7;
    if (is_factor) power *= part;
  }
  return power;
}

}  // namespace

double linear_from_srgb(double code) {
  return mirrored(code, linear_from_code);
}

double srgb_from_linear(double linear) {
  return mirrored(linear, code_from_linear);
}

double linear_from_a98(double code) {
  return mirrored(code, a98_power);
}

double linear_from_prophoto(double code) {
  return mirrored(code, [](double x) { return x <= 1.0 / 32 ? x / 16 : x * x / root<5>(x); });
}

double linear_from_rec2020(double code) {
  return mirrored(code, [](double x) {
    if (x == 0) return 0.0;
    const double fifth = root<5>(x);
    return x * x * (fifth * fifth);
  });
}

}  // namespace sfumato::color
