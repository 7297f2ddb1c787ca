#include "trace/candidates.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "base/parallel.hpp"
#include "curves/fit.hpp"
#include "trace/chains.hpp"
#include "trace/distance.hpp"

namespace sfumato::tracing {
namespace {

/// What a curve costs beside its control points: few long curves are easier to edit than many short
/// ones.
constexpr double kCurvePrice = 12;
/// A candidate of which more lies on others is dropped.
constexpr double kLargestOverlap = 0.15;
constexpr double kLeastScale = 1.5;
/// A curve may miss a weak edge by more than a strong one, whose error shows more: in proportion to
/// (kUsualStrength / strength)^kContrastPower, within bounds.
constexpr float kUsualStrength = 0.05f;
constexpr double kContrastPower = 0.3;
constexpr double kLeastSlack = 0.6;
constexpr double kMostSlack = 1.7;

/// Pixels that curves pass through.
class PixelMask {
 public:
  PixelMask(int width, int height) : width_(width), height_(height) {}

  /// Before anything but along(). Errors: limit (memory), cancelled.
  Status create(const Context& context) {
    return memory_.resize(context, is_set_,
                          static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  }

  template <class Visit>
  void along(const TracedCurve& curve, Visit visit) {
    for (const CurveSample& sample : samples_along(curve, 0.5)) {
      visit(std::clamp(static_cast<int>(sample.point.x), 0, width_ - 1),
            std::clamp(static_cast<int>(sample.point.y), 0, height_ - 1));
    }
  }

  std::uint8_t& at(int x, int y) {
    return is_set_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                   static_cast<std::size_t>(x)];
  }

  double share_set(const TracedCurve& curve) {
    double set = 0, count = 0;
    along(curve, [&](int x, int y) { set += at(x, y), ++count; });
    return count > 0 ? set / count : 1.0;
  }

  /// The pixels along the border of the picture, where its frame runs.
  void draw_border() {
    for (int x = 0; x < width_; ++x) at(x, 0) = at(x, height_ - 1) = 1;
    for (int y = 0; y < height_; ++y) at(0, y) = at(width_ - 1, y) = 1;
  }

  /// Sets a diamond around each pixel of the curve.
  void draw(const TracedCurve& curve, int reach) {
    along(curve, [&](int x, int y) {
      for (int dy = -reach; dy <= reach; ++dy) {
        const int across = reach - std::abs(dy);
        for (int dx = -across; dx <= across; ++dx) {
          const int px = x + dx, py = y + dy;
          if (px >= 0 && py >= 0 && px < width_ && py < height_) at(px, py) = 1;
        }
      }
    });
  }

 private:
  int width_, height_;
  TableMemory memory_{"the edges of a picture"};
  std::vector<std::uint8_t> is_set_;
};

Status mark_present(Context& context, int width, int height, std::span<const TracedCurve> present,
                    TableMemory& memory, Plane& taken) {
  Status status = make_plane(context, width, height, memory, taken);
  if (!status) return status;
  std::ranges::fill(taken.value, kFar);
  PixelMask mask(width, height);
  for (const TracedCurve& curve : present) {
    if (curve.is_frame) continue;
    mask.along(curve, [&](int x, int y) { taken.row(y)[x] = 0; });
  }
  return context.check();
}

double slack_of(const Chain& chain) {
  std::vector<float> strengths = chain.strength;
  const auto middle = strengths.begin() + static_cast<std::ptrdiff_t>(strengths.size() / 2);
  std::nth_element(strengths.begin(), middle, strengths.end());
  const double weakness = kUsualStrength / std::max(*middle, 1e-4f);
  return std::clamp(std::pow(weakness, kContrastPower), kLeastSlack, kMostSlack);
}

TracedCurve curve_of(const Chain& chain, double tolerance) {
  TracedCurve curve;
  curve.scale = chain.scale;
  tolerance *= slack_of(chain);
  curve.control_points =
      curves::fit_curve(chain.point, {.tolerance = tolerance * std::sqrt(chain.scale)});
  for (const float strength : chain.strength) curve.benefit += double{strength} * strength;
  curve.benefit *= std::max(chain.scale, kLeastScale);
  return curve;
}

double worth(const TracedCurve& curve) {
  return curve.benefit / (static_cast<double>(curve.control_points.size()) + kCurvePrice);
}

}  // namespace

Result<std::vector<TracedCurve>> find_candidates(Context& context, std::span<const Plane> channels,
                                                 const EdgeOptions& options, double tolerance,
                                                 std::span<const TracedCurve> present) {
  TableMemory memory("the edges of a picture");
  Plane taken;
  Status status =
      mark_present(context, channels[0].width, channels[0].height, present, memory, taken);
  if (!status) return status;
  const Result<EdgeMap> edges = find_edges(context, channels, options, taken);
  if (!edges) return edges.status();
  const Result<std::vector<Chain>> chains = link_chains(context, *edges);
  if (!chains) return chains.status();
  std::vector<TracedCurve> candidates(chains->size());
  status = parallel_for(context, chains->size(), 8, [&](std::size_t i, std::size_t end) {
    for (; i < end; ++i) candidates[i] = curve_of((*chains)[i], tolerance);
  });
  if (!status) return status;
  return candidates;
}

Result<std::vector<TracedCurve>> choose_curves(Context& context,
                                               std::vector<TracedCurve> candidates, int width,
                                               int height, const CurveBudget& budget,
                                               std::span<const TracedCurve> present) {
  std::ranges::stable_sort(
      candidates, [](const TracedCurve& a, const TracedCurve& b) { return worth(a) > worth(b); });
  PixelMask mask(width, height);
  if (Status status = mask.create(context); !status) return status;
  mask.draw_border();
  for (const TracedCurve& curve : present) {
    if (!curve.is_frame) mask.draw(curve, 0);
  }
  std::vector<TracedCurve> chosen;
  std::size_t used = 0;
  for (TracedCurve& candidate : candidates) {
    if (context.cancelled()) return context.cancel_status();
    const std::size_t points = candidate.control_points.size();
    if (chosen.size() == budget.curves) break;
    if (used + points > budget.points) continue;
    if (mask.share_set(candidate) > kLargestOverlap) continue;
    mask.draw(candidate, std::max(1, static_cast<int>(0.6 * candidate.scale)));
    used += points;
    chosen.push_back(std::move(candidate));
  }
  return chosen;
}

}  // namespace sfumato::tracing
