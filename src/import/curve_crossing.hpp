#pragma once

#include "curves/bezier.hpp"

namespace sfumato::svg_import {

/// Decides whether two cubic Béziers cross, by halving the curves until their control polygons are
/// apart or the curves are practically straight.
///
/// flat    a curve that deviates less from its chord is straight; smaller crossings may be missed
/// joint   crossings nearer than about this to the common point of two curves do not count
class CurveCrossing {
 public:
  CurveCrossing(double flat, double joint) : flat_(flat), joint_(joint) {}

  /// Returns whether the curves pass through each other. Curves that touch do not cross. If the
  /// answer needs more than kMostHalvings, it is yes.
  bool of(const curves::Cubic& a, const curves::Cubic& b);
  /// Does the same for a curve that ends where `next` begins. Their common point is not a crossing.
  bool beyond_joint(const curves::Cubic& curve, const curves::Cubic& next);
  /// Returns the approximate crossing, after one of the functions above returned true.
  Vec2 place() const { return place_; }

 private:
  static constexpr int kMostHalvings = 4096;

  bool cross(const curves::Cubic& a, const curves::Cubic& b);
  bool cross_beyond_joint(const curves::Cubic& curve, const curves::Cubic& next);

  double flat_;
  double joint_;
  Vec2 place_;
  int halvings_left_ = 0;
};

}  // namespace sfumato::svg_import
