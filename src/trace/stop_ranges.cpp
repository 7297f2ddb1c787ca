#include "trace/stop_ranges.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/parallel.hpp"
#include "curves/bezier.hpp"
#include "curves/stop_parameters.hpp"
#include "trace/drawing_layers.hpp"

namespace sfumato::tracing {
namespace {

constexpr float kMixed = 0.1f;
/// With blur the square looked at reaches as far as this, at most so many pixels.
constexpr double kFarthestPx = 32;
/// Curves that one task looks at.
constexpr std::size_t kCurves = 4;

class CurveRanges {
 public:
  CurveRanges(std::span<const Affine> pixel_from_layer, const Channels& color)
      : pixel_from_layer_(pixel_from_layer), color_(color) {}

  /// Of the stops of one side.
  void find(const Curve& curve, const Side& side, std::span<const float> mixed,
            std::span<FourFloats> low, std::span<FourFloats> high) const {
    const std::vector<double> parameter =
        curves::stop_parameters(curve.control_points, side.color.stops);
    double radius = 0;
    for (const Stop<float>& stop : side.blur_radius.stops) {
      radius = std::max(radius, double{stop.value});
    }
    for (std::size_t i = 0; i < parameter.size(); ++i) {
      if (mixed[i] > kMixed) continue;
      const double last = static_cast<double>(curve.piece_count()) - 1;
      const double piece = std::clamp(std::floor(parameter[i]), 0.0, last);
      const Vec2 place =
          curves::point_at(curves::piece(curve.control_points, static_cast<std::size_t>(piece)),
                           parameter[i] - piece);
      extend(place, radius, low[i], high[i]);
    }
  }

 private:
  void extend(Vec2 place, double radius, FourFloats& low, FourFloats& high) const {
    Range range[3];
    const double width = color_[0].width, height = color_[0].height;
    for (const Affine& map : pixel_from_layer_) {
      const Vec2 p = map(place);
      const double reach = std::clamp(radius * largest_scale(map), kNearPx, kFarthestPx);
      if (!(p.x > -reach && p.y > -reach && p.x < width + reach && p.y < height + reach)) continue;
      for (std::size_t c = 0; c < 3; ++c) {
        const Range near = range_near(color_[c], p, static_cast<int>(reach));
        range[c].extend(near.low);
        range[c].extend(near.high);
      }
    }
    for (std::size_t c = 0; c < 3; ++c) {
      if (range[c].low > range[c].high) continue;
      low[c] = std::max(low[c], range[c].low - kWiderRange);
      high[c] = std::min(high[c], range[c].high + kWiderRange);
    }
  }

  std::span<const Affine> pixel_from_layer_;
  const Channels& color_;
};

}  // namespace

Status find_stop_ranges(Context& context, const std::vector<Curve>& curves,
                        std::span<const Affine> pixel_from_layer, const Channels& color,
                        std::span<const float> mixed, std::span<FourFloats> low,
                        std::span<FourFloats> high) {
  TableMemory memory("the colours of a fit");
  std::vector<std::size_t> first;
  Status status = memory.resize(context, first, curves.size());
  if (!status) return status;
  std::size_t count = 0;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    first[i] = count;
    count += curves::stop_count({&curves[i], 1}, StopAttribute::color);
  }
  const CurveRanges ranges(pixel_from_layer, color);
  return parallel_for(context, curves.size(), kCurves, [&](std::size_t i, std::size_t end) {
    for (; i < end; ++i) {
      std::size_t at = first[i];
      for (const Side* side : {&curves[i].left, &curves[i].right}) {
        if (context.cancelled()) return;
        if (side->color.kind != ShaderKind::curve_domain) continue;
        const std::size_t stops = side->color.stops.stops.size();
        ranges.find(curves[i], *side, mixed.subspan(at, stops), low.subspan(at, stops),
                    high.subspan(at, stops));
        at += stops;
      }
    }
  });
}

}  // namespace sfumato::tracing
