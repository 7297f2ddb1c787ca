#include "curves/bezier.hpp"

#include <algorithm>
#include <cmath>

namespace sfumato::curves {
namespace {

/// Returns the largest |3t(1-t)((1-t)a + tb)| over [0, 1]: the part of the deviation along one
/// axis, where a and b are the offsets of the inner control points from the thirds of the chord.
double largest_bulge(double a, double b) {
  const auto bulge = [&](double t) { return std::fabs(3 * t * (1 - t) * ((1 - t) * a + t * b)); };
  // Zeros of the derivative: (3a - 3b) t² + (2b - 4a) t + a.
  const double qa = 3 * (a - b), qb = 2 * b - 4 * a, qc = a;
  if (qa == 0) return bulge(0.5);
  const double discriminant = qb * qb - 4 * qa * qc;
  if (!(discriminant >= 0)) return bulge(0.5);
  const double root = std::sqrt(discriminant);
  double largest = 0;
  for (double t : {(-qb + root) / (2 * qa), (-qb - root) / (2 * qa)}) {
    if (t > 0 && t < 1) largest = std::max(largest, bulge(t));
  }
  return largest;
}

/// Integrates the speed by five-point Gauss–Legendre quadrature.
double quadrature(const Cubic& cubic, double t0, double t1) {
  static constexpr double kNode[3] = {0.0, 0.5384693101056831, 0.9061798459386640};
  static constexpr double kWeight[3] = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
  const double middle = 0.5 * (t0 + t1), half = 0.5 * (t1 - t0);
  double sum = kWeight[0] * length(derivative_at(cubic, middle));
  for (int i = 1; i < 3; ++i) {
    sum += kWeight[i] * (length(derivative_at(cubic, middle - half * kNode[i])) +
                         length(derivative_at(cubic, middle + half * kNode[i])));
  }
  return sum * half;
}

}  // namespace

Vec2 point_at(const Cubic& c, double t) {
  const Vec2 ab = lerp(c[0], c[1], t), bc = lerp(c[1], c[2], t), cd = lerp(c[2], c[3], t);
  if (t == 1) return c[3];
  return lerp(lerp(ab, bc, t), lerp(bc, cd, t), t);
}

Vec2 derivative_at(const Cubic& c, double t) {
  const Vec2 ab = c[1] - c[0], bc = c[2] - c[1], cd = c[3] - c[2];
  return 3 * lerp(lerp(ab, bc, t), lerp(bc, cd, t), t);
}

Cubic subcurve(const Cubic& cubic, double t0, double t1) {
  const Vec2 from = point_at(cubic, t0), to = point_at(cubic, t1);
  const double third = (t1 - t0) / 3;
  return {from, from + derivative_at(cubic, t0) * third, to - derivative_at(cubic, t1) * third, to};
}

ChordDeviation chord_deviation(const Cubic& c) {
  const Vec2 first = c[1] - lerp(c[0], c[3], 1.0 / 3), second = c[2] - lerp(c[0], c[3], 2.0 / 3);
  const Vec2 chord = c[3] - c[0];
  const double chord_length = length(chord);
  if (chord_length == 0) {
    return {largest_bulge(first.x, second.x) + largest_bulge(first.y, second.y), 0};
  }
  const Vec2 along = chord / chord_length;
  return {largest_bulge(cross(along, first), cross(along, second)),
          largest_bulge(dot(along, first), dot(along, second))};
}

Vec2 mean_deviation(const Cubic& c) {
  const Vec2 mean = 0.25 * (c[1] + c[2] - c[0] - c[3]);
  const Vec2 across = left_of(c[3] - c[0]);
  const double chord_squared = length_squared(across);
  return chord_squared > 0 ? across * (dot(mean, across) / chord_squared) : mean;
}

double nearest_parameter(const Cubic& c, Vec2 point, double t) {
  constexpr int kSteps = 4;
  for (int i = 0; i < kSteps; ++i) {
    const Vec2 off = point_at(c, t) - point, along = derivative_at(c, t);
    const Vec2 bend = 6 * lerp(c[2] - 2 * c[1] + c[0], c[3] - 2 * c[2] + c[1], t);
    const double slope = length_squared(along) + dot(off, bend);
    if (!(slope > 0)) break;
    t = std::clamp(t - dot(off, along) / slope, 0.0, 1.0);
  }
  return t;
}

double arc_length(const Cubic& cubic, double t0, double t1) {
  constexpr int kHalvings = 8;
  double coarse = quadrature(cubic, t0, t1);
  for (int depth = 1; depth <= kHalvings; ++depth) {
    const int parts = 1 << depth;
    double fine = 0;
    for (int i = 0; i < parts; ++i) {
      const double step = (t1 - t0) / parts;
      fine += quadrature(cubic, t0 + i * step, t0 + (i + 1) * step);
    }
    if (std::fabs(fine - coarse) <= 1e-9 * fine) return fine;
    coarse = fine;
  }
  return coarse;
}

double parameter_at_length(const Cubic& cubic, double wanted) {
  constexpr int kSteps = 64;
  constexpr double kSettled = 0x1p-48;
  double low = 0, high = 1, low_length = 0, t = 0.5;
  for (int i = 1; i <= kSteps && high - low > kSettled; ++i) {
    const double reached = low_length + arc_length(cubic, low, t);
    const double step = (wanted - reached) / length(derivative_at(cubic, t));
    if (std::fabs(step) <= kSettled) return std::clamp(t + step, low, high);
    if (reached < wanted) {
      low = t;
      low_length = reached;
    } else {
      high = t;
    }
    // Where the speed is nearly 0, Newton's steps leave the remaining interval, or hardly shorten
    // it.
    t += step;
    constexpr int kHalvedEach = 4;
    if (!(t > low && t < high) || i % kHalvedEach == 0) t = 0.5 * (low + high);
  }
  return 0.5 * (low + high);
}

}  // namespace sfumato::curves
