#include "trace/image/sample_pixels.hpp"

#include <algorithm>
#include <utility>

#include "base/poll.hpp"
#include "base/try.hpp"

namespace sfumato::tracing {
namespace {

/// Points off the middle, so that none lies on a curve with simple coordinates.
constexpr Vec2 kOff{0.0137, 0.0071};
/// A rotated grid: in a pixel that an upright or level line cuts, it resolves fourths of the area;
/// an upright grid would resolve halves.
constexpr Vec2 kInCrossed[] = {{-0.125, -0.375}, {0.375, -0.125}, {-0.375, 0.125}, {0.125, 0.375}};
/// Side of the squares of pixels that follow each other.
constexpr int kTile = 16;

/// 2⁶⁴
constexpr double kAllChances = 18446744073709551616.0;

/// Returns a hash of 64 bits (the finaliser of SplitMix64).
std::uint64_t scrambled(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15;
  x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9;
  x = (x ^ x >> 27) * 0x94d049bb133111eb;
  return x ^ x >> 31;
}

/// Adds the sample points of a pixel.
Status add_points(const Context& context, int x, int y, bool is_crossed, SamplePixels& out) {
  const Vec2 middle = Vec2{x + 0.5, y + 0.5} + kOff;
  if (!is_crossed) {
    SFUMATO_TRY(out.memory.push_back(context, out.point, middle));
  } else {
    for (const Vec2 offset : kInCrossed) {
      SFUMATO_TRY(out.memory.push_back(context, out.point, middle + offset));
    }
  }
  return out.memory.push_back(context, out.point_begin,
                              static_cast<std::uint32_t>(out.point.size()));
}

}  // namespace

Result<PixelMarks> PixelMarks::create(Context& context, int width, int height) {
  PixelMarks marks;
  marks.width_ = width;
  marks.height_ = height;
  const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  SFUMATO_TRY(marks.memory_.resize(context, marks.mark_, count));
  return marks;
}

void PixelMarks::raise(int x, int y, Mark mark) {
  x = std::clamp(x, 0, width_ - 1);
  y = std::clamp(y, 0, height_ - 1);
  std::uint8_t& at = mark_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                           static_cast<std::size_t>(x)];
  at = std::max<std::uint8_t>(at, mark);
}

void PixelMarks::cross(Vec2 p) {
  const int x = std::clamp(static_cast<int>(p.x), 0, width_ - 1);
  const int y = std::clamp(static_cast<int>(p.y), 0, height_ - 1);
  raise(x, y, crossed);
  for (const auto& [dx, dy] : {std::pair(-1, 0), {1, 0}, {0, -1}, {0, 1}}) {
    raise(x + dx, y + dy, beside);
  }
}

Result<PixelMarks> mark_curves(Context& context, int width, int height,
                               std::span<const TracedCurve> curves) {
  SFUMATO_TRY_ASSIGN(auto&& marks, PixelMarks::create(context, width, height));
  for (const TracedCurve& curve : curves) {
    if (context.cancelled()) return context.cancel_status();
    if (curve.is_frame || curve.radius > kSharpRadiusPx) continue;
    for_each_sample(curve, 0.4, [&](const CurveSample& at) { marks.cross(at.point); });
  }
  return std::move(marks);
}

Result<SamplePixels> choose_pixels(Context& context, const PixelMarks& marks,
                                   const PixelChoice& choice) {
  SamplePixels out;
  SFUMATO_TRY(out.memory.push_back(context, out.point_begin, 0));
  RarePoll<4096> poll(context);
  const double most = kAllChances / choice.one_in;
  const auto consider = [&](int x, int y) -> Status {
    const auto pixel = static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(marks.width()) +
                       static_cast<std::uint32_t>(x);
    const auto chance = static_cast<double>(scrambled(choice.seed * 0x2545f4914f6cdd1d + pixel));
    const double limit = marks.is_near(pixel) ? 2 * most : most;
    if (chance > limit) return ok_status();
    SFUMATO_TRY(out.memory.push_back(context, out.pixel, pixel));
    const auto stands_for = static_cast<float>(std::max(1.0, kAllChances / limit));
    SFUMATO_TRY(out.memory.push_back(context, out.stands_for, stands_for));
    return add_points(context, x, y, marks.is_crossed(pixel), out);
  };
  for (int y0 = choice.first_row; y0 < choice.end_row; y0 += kTile) {
    for (int x0 = 0; x0 < marks.width(); x0 += kTile) {
      for (int y = y0; y < std::min(y0 + kTile, choice.end_row); ++y) {
        for (int x = x0; x < std::min(x0 + kTile, marks.width()); ++x) {
          if (poll.cancelled()) return context.cancel_status();
          SFUMATO_TRY(consider(x, y));
        }
      }
    }
  }
  return out;
}

}  // namespace sfumato::tracing
