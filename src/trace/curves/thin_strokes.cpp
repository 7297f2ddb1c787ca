#include "trace/curves/thin_strokes.hpp"

#include <algorithm>
#include <cstddef>

namespace sfumato::tracing {
namespace {

/// The widest stroke, pixels.
constexpr double kWidestStroke = 4;
constexpr double kStrokeStep = 0.5;  ///< between places across a curve
/// How far beside a curve its sides' own values are.
constexpr double kOwnSide = 1;
/// A squared difference below this share of the squared jump counts as none.
constexpr double kSameShare = 0.25;

double squared_jump(std::span<const Plane> channels, Vec2 a, Vec2 b) {
  double sum = 0;
  for (const Plane& channel : channels) {
    const double difference = double{channel.sample(a)} - channel.sample(b);
    sum += difference * difference;
  }
  return sum;
}

bool is_stroke_side(std::span<const Plane> channels, const CurveSample& at) {
  const Vec2 own = kOwnSide * at.left;
  const double same = kSameShare * squared_jump(channels, at.point + own, at.point - own);
  for (double far = kOwnSide + kStrokeStep; far <= kWidestStroke; far += kStrokeStep) {
    for (const double sign : {-1.0, 1.0}) {
      const Vec2 there = at.point + sign * far * at.left, behind = at.point - sign * own;
      if (squared_jump(channels, there, behind) < same) return true;
    }
  }
  return false;
}

}  // namespace

Result<double> stroke_share(const Context& context, std::span<const Plane> channels,
                            std::span<const TracedCurve> curves) {
  std::size_t all = 0, of_strokes = 0;
  for (const TracedCurve& curve : curves) {
    if (context.cancelled()) return context.cancel_status();
    for_each_sample(curve, 1, [&](const CurveSample& at) {
      ++all;
      if (is_stroke_side(channels, at)) ++of_strokes;
    });
  }
  return static_cast<double>(of_strokes) / static_cast<double>(std::max<std::size_t>(all, 1));
}

}  // namespace sfumato::tracing
