#include "trace/curves/candidates.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include "base/parallel.hpp"
#include "base/try.hpp"
#include "curves/fit.hpp"
#include "trace/curves/chains.hpp"
#include "trace/image/distance.hpp"

namespace sfumato::tracing {
namespace {

/// A candidate is dropped if a larger share of it lies on other curves.
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
    for_each_sample(curve, 0.5, [&](const CurveSample& sample) {
      visit(std::clamp(static_cast<int>(sample.point.x), 0, width_ - 1),
            std::clamp(static_cast<int>(sample.point.y), 0, height_ - 1));
    });
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
  SFUMATO_TRY(make_plane(context, width, height, memory, taken));
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

/// Makes a curve that has nothing yet but room.
void fit(const Chain& chain, double tolerance, TracedCurve& curve) {
  curve.scale = chain.scale;
  tolerance *= slack_of(chain);
  curves::fit_curve(chain.point, {.tolerance = tolerance * std::sqrt(chain.scale)},
                    curve.control_points);
  curve.control_points.shrink_to_fit();
  for (const float strength : chain.strength) curve.benefit += double{strength} * strength;
  curve.benefit *= std::max(chain.scale, kLeastScale);
}

double worth(const TracedCurve& curve, double price) {
  return curve.benefit / (static_cast<double>(curve.control_points.size()) + price);
}

Result<std::vector<TracedCurve>> curves_along(Context& context, std::span<const Chain> chains,
                                              double tolerance, TableMemory& memory) {
  std::vector<TracedCurve> curves;
  SFUMATO_TRY(memory.resize(context, curves, chains.size()));
  for (std::size_t i = 0; i < chains.size(); ++i) {
    if (context.cancelled()) return context.cancel_status();
    const std::size_t most = curves::most_control_points(chains[i].point.size());
    SFUMATO_TRY(memory.reserve(context, curves[i].control_points, most));
  }
  SFUMATO_TRY(parallel_for(context, chains.size(), 8, [&](std::size_t i, std::size_t end) {
    for (; i < end; ++i) fit(chains[i], tolerance, curves[i]);
  }));
  return curves;
}

/// Lists the indices of the curves, the most valuable first.
Status rank(const Context& context, std::span<const TracedCurve> curves, double price,
            TableMemory& memory, std::vector<std::uint32_t>& order) {
  SFUMATO_TRY(memory.resize(context, order, curves.size()));
  std::iota(order.begin(), order.end(), 0u);
  return TableMemory::sort(context, order, [curves, price](std::uint32_t a, std::uint32_t b) {
    const double worth_a = worth(curves[a], price), worth_b = worth(curves[b], price);
    return worth_a > worth_b || (worth_a == worth_b && a < b);
  });
}

}  // namespace

Result<std::vector<TracedCurve>> find_candidates(Context& context, std::span<const Plane> channels,
                                                 const EdgeOptions& options, double tolerance,
                                                 std::span<const TracedCurve> present,
                                                 TableMemory& memory) {
  TableMemory edge_memory("the edges of a picture");
  Plane taken;
  SFUMATO_TRY(
      mark_present(context, channels[0].width, channels[0].height, present, edge_memory, taken));
  SFUMATO_TRY_ASSIGN(const EdgeMap& edges, find_edges(context, channels, options, taken));
  SFUMATO_TRY_ASSIGN(const std::vector<Chain>& chains, link_chains(context, edges, edge_memory));
  return curves_along(context, chains, tolerance, memory);
}

Result<std::vector<TracedCurve>> choose_curves(Context& context,
                                               std::vector<TracedCurve> candidates, int width,
                                               int height, const CurveBudget& budget,
                                               std::span<const TracedCurve> present,
                                               TableMemory& memory) {
  TableMemory own_memory("the edges of a picture");
  std::vector<std::uint32_t> order;
  SFUMATO_TRY(rank(context, candidates, budget.curve_price, own_memory, order));
  PixelMask mask(width, height);
  SFUMATO_TRY(mask.create(context));
  mask.draw_border();
  for (const TracedCurve& curve : present) {
    if (!curve.is_frame) mask.draw(curve, 0);
  }
  std::vector<TracedCurve> chosen;
  std::size_t used = 0;
  for (const std::uint32_t i : order) {
    TracedCurve& candidate = candidates[i];
    if (context.cancelled()) return context.cancel_status();
    const std::size_t points = candidate.control_points.size();
    if (chosen.size() == budget.curves) break;
    if (used + points > budget.points) continue;
    if (mask.share_set(candidate) > kLargestOverlap) continue;
    mask.draw(candidate, std::max(budget.apart, static_cast<int>(0.6 * candidate.scale)));
    used += points;
    SFUMATO_TRY(memory.push_back(context, chosen, std::move(candidate)));
  }
  return chosen;
}

}  // namespace sfumato::tracing
