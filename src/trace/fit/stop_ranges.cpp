#include "trace/fit/stop_ranges.hpp"

#include <cmath>
#include <limits>

#include "base/largest_scale.hpp"
#include "base/parallel.hpp"
#include "base/try.hpp"
#include "curves/attributes.hpp"
#include "curves/bezier.hpp"
#include "curves/stop_parameters.hpp"
#include "trace/curves/drawing_layers.hpp"
#include "trace/curves/drawing_stops.hpp"

namespace sfumato::tracing {
namespace {

/// Half the side of the examined square, pixels; with blur one radius, but at most this many.
constexpr double kNearPx = 8;
constexpr double kFarthestPx = 32;
/// Stops may leave the range near them by this much, and by more if more pixels determine them.
constexpr float kWider = 0.1f;
constexpr float kWiderPerPixel = 0.05f;
/// Pixels that make a range.
constexpr int kLeastRangePixels = 24;
/// Curves of one task.
constexpr std::size_t kCurves = 4;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

struct Ranges {
  FourFloats low{kInfinity, kInfinity, kInfinity, 0};
  FourFloats high{-kInfinity, -kInfinity, -kInfinity, 0};
  int pixels = 0;
};

class RangeFinder {
 public:
  RangeFinder(std::span<const Affine> pixel_from_layer, const Channels& color,
              const SolidBlocks& blocks)
      : pixel_from_layer_(pixel_from_layer), color_(color), blocks_(blocks) {}

  /// Narrows the ranges of the stops of one side.
  void narrow(const Curve& curve, const ColorStops& list, std::span<const float> weight,
              std::span<FourFloats> low, std::span<FourFloats> high) const {
    const std::vector<double> parameter = curves::stop_parameters(curve.control_points, list);
    const double radius = largest_radius(curve);
    const double last = static_cast<double>(curve.piece_count()) - 1;
    for (std::size_t i = 0; i < parameter.size(); ++i) {
      const double piece = std::clamp(std::floor(parameter[i]), 0.0, last);
      const curves::Cubic cubic =
          curves::piece(curve.control_points, static_cast<std::size_t>(piece));
      const Ranges near = ranges_near(curves::point_at(cubic, parameter[i] - piece), radius);
      if (near.pixels < kLeastRangePixels) continue;
      const float wider = kWider + kWiderPerPixel * weight[i];
      for (std::size_t c = 0; c < 3; ++c) {
        low[i][c] = std::max(low[i][c], near.low[c] - wider);
        high[i][c] = std::min(high[i][c], near.high[c] + wider);
      }
    }
  }

 private:
  Ranges ranges_near(Vec2 place, double radius) const {
    Ranges ranges;
    for (const Affine& map : pixel_from_layer_) {
      extend(map(place), std::clamp(radius * largest_scale(map), kNearPx, kFarthestPx), ranges);
    }
    return ranges;
  }

  void extend(Vec2 p, double reach, Ranges& ranges) const {
    const auto within = [](double at, int side) {
      return static_cast<int>(std::clamp(at, 0.0, static_cast<double>(side)));
    };
    const int x0 = within(p.x - reach, color_[0].width), y0 = within(p.y - reach, color_[0].height);
    const int x1 = within(p.x + reach + 1, color_[0].width);
    const int y1 = within(p.y + reach + 1, color_[0].height);
    for (int y = y0; y < y1; ++y) {
      for (int x = x0; x < x1; ++x) {
        if (!blocks_.is_solid(x, y)) continue;
        ++ranges.pixels;
        for (std::size_t c = 0; c < 3; ++c) {
          const float value = color_[c].at(x, y);
          ranges.low[c] = std::min(ranges.low[c], value);
          ranges.high[c] = std::max(ranges.high[c], value);
        }
      }
    }
  }

  std::span<const Affine> pixel_from_layer_;
  const Channels& color_;
  const SolidBlocks& blocks_;
};

}  // namespace

Result<SolidBlocks> SolidBlocks::create(Context& context, int width, int height) {
  SolidBlocks blocks;
  blocks.width_ = width;
  blocks.columns_ = (width + kSide - 1) / kSide;
  const int rows = (height + kSide - 1) / kSide;
  SFUMATO_TRY(blocks.memory_.resize(
      context, blocks.state_,
      static_cast<std::size_t>(blocks.columns_) * static_cast<std::size_t>(rows)));
  return blocks;
}

void SolidBlocks::add(std::uint32_t pixel, bool is_solid) {
  const int x = static_cast<int>(pixel) % width_, y = static_cast<int>(pixel) / width_;
  State& state = state_[index(x, y)];
  if (!is_solid) state = mixed;
  if (is_solid && state == unknown) state = solid;
}

Status find_stop_ranges(Context& context, const std::vector<Curve>& curves,
                        std::span<const Affine> pixel_from_layer, const Channels& color,
                        const SolidBlocks& blocks, std::span<const float> weight,
                        std::span<FourFloats> low, std::span<FourFloats> high) {
  TableMemory memory("the colours of a fit");
  std::vector<std::size_t> first;
  SFUMATO_TRY(memory.resize(context, first, curves.size()));
  std::size_t count = 0;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    first[i] = count;
    count += curves::stop_count({&curves[i], 1}, StopAttribute::color);
  }
  const RangeFinder finder(pixel_from_layer, color, blocks);
  return try_parallel_for(context, curves.size(), kCurves, [&](std::size_t i, std::size_t end) {
    for (; i < end; ++i) {
      std::size_t at = first[i];
      for (const Side* side : {&curves[i].left, &curves[i].right}) {
        if (context.cancelled()) return context.cancel_status();
        if (side->color.kind != ShaderKind::curve_domain) continue;
        const std::size_t stops = side->color.stops.stops.size();
        finder.narrow(curves[i], side->color.stops, weight.subspan(at, stops),
                      low.subspan(at, stops), high.subspan(at, stops));
        at += stops;
      }
    }
    return ok_status();
  });
}

}  // namespace sfumato::tracing
