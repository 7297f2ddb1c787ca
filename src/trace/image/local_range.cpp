#include "trace/image/local_range.hpp"

#include <cstddef>

#include "base/parallel.hpp"
#include "base/try.hpp"

namespace sfumato::tracing {
namespace {

/// With blur, half the side of the square is at least this many radii.
constexpr double kNearRadii = 1.0;

void add_bounds(const Picture& picture, const TracedCurve& curve, double parameter, FourFloats& low,
                FourFloats& high) {
  const Vec2 p = point_on(curve, parameter);
  const int reach = static_cast<int>(std::max(kNearPx, kNearRadii * curve.radius));
  for (std::size_t c = 0; c < 3; ++c) {
    const Range range = range_near(picture.code[c], p, reach);
    low[c] = std::max(range.low - kWiderRange, 0.0f);
    high[c] = std::min(range.high + kWiderRange, 1.0f);
  }
  low[3] = 0;
  high[3] = 1;
}

}  // namespace

Range range_near(const Plane& plane, Vec2 p, int reach) {
  const int x0 = std::clamp(static_cast<int>(p.x) - reach, 0, plane.width - 1);
  const int x1 = std::clamp(static_cast<int>(p.x) + reach, 0, plane.width - 1);
  const int y0 = std::clamp(static_cast<int>(p.y) - reach, 0, plane.height - 1);
  const int y1 = std::clamp(static_cast<int>(p.y) + reach, 0, plane.height - 1);
  Range range;
  for (int y = y0; y <= y1; ++y) {
    const float* row = plane.row(y);
    for (int x = x0; x <= x1; ++x) range.extend(row[x]);
  }
  return range;
}

Result<ValueBounds> bounds_near(Context& context, const Picture& picture,
                                std::span<const TracedCurve> curves) {
  std::vector<std::size_t> first;
  std::size_t count = 0;
  for (const TracedCurve& curve : curves) {
    first.push_back(count);
    count += stop_count(curve);
  }
  ValueBounds bounds{std::vector<FourFloats>(count), std::vector<FourFloats>(count)};
  SFUMATO_TRY(parallel_for(context, curves.size(), 4, [&](std::size_t i, std::size_t end) {
    for (; i < end; ++i) {
      std::size_t at = first[i];
      for (const SideStops& side : curves[i].side) {
        for (const double parameter : side.place) {
          add_bounds(picture, curves[i], parameter, bounds.low[at], bounds.high[at]);
          ++at;
        }
      }
    }
  }));
  return bounds;
}

}  // namespace sfumato::tracing
