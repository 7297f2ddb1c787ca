#include "trace/curves/chains.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <span>
#include <utility>

#include "base/try.hpp"
#include "trace/image/pixel_chains.hpp"

namespace sfumato::tracing {
namespace {

/// A chain whose ends are closer than this, and that has more than kLoopPixels, is a loop.
constexpr double kLoopGap = 2;
constexpr std::size_t kLoopPixels = 12;

/// Weights of a Gaussian along a chain, from the middle outwards.
std::vector<double> weights_along(double sigma) {
  std::vector<double> weight;
  const int reach = static_cast<int>(std::ceil(3 * sigma));
  for (int i = 0; i <= reach; ++i) weight.push_back(std::exp(-0.5 * i * i / (sigma * sigma)));
  return weight;
}

/// Smooths points along their chain. The ends of an open chain stay in place.
/// out   as large as the points, to be changed
void smooth(double sigma, bool is_loop, std::span<Vec2> out, std::span<Vec2> points) {
  const std::vector<double> weight = weights_along(sigma);
  const auto count = std::ssize(points);
  const auto at = [&](std::ptrdiff_t i) {
    i = is_loop ? (i % count + count) % count : std::clamp<std::ptrdiff_t>(i, 0, count - 1);
    return points[static_cast<std::size_t>(i)];
  };
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    Vec2 sum = weight[0] * at(i);
    double total = weight[0];
    for (std::ptrdiff_t k = 1; k < std::ssize(weight); ++k) {
      const double w = weight[static_cast<std::size_t>(k)];
      sum = sum + w * (at(i - k) + at(i + k));
      total += 2 * w;
    }
    out[static_cast<std::size_t>(i)] = sum / total;
  }
  if (!is_loop) {
    out.front() = points.front();
    out.back() = points.back();
  }
  std::ranges::copy(out, points.begin());
}

/// Makes chains of points from chains of pixels.
class ChainMaker {
 public:
  ChainMaker(const Context& context, const EdgeMap& edges, const ChainOptions& options)
      : context_(context), edges_(edges), options_(options) {}

  /// Reserves memory for chains of this many pixels. Errors: limit (memory), cancelled.
  Status make_room(std::size_t longest) {
    Status status = memory_.reserve(context_, found_at_, longest);
    return status ? memory_.resize(context_, smoothed_, longest) : status;
  }

  double median_scale(PixelChain pixels) {
    found_at_.clear();
    for (const PixelPlace& p : pixels) {
      if (const float scale = edges_.at(p.x, p.y).scale; scale > 0) found_at_.push_back(scale);
    }
    if (found_at_.empty()) return 1;
    const auto middle = found_at_.begin() + std::ssize(found_at_) / 2;
    std::nth_element(found_at_.begin(), middle, found_at_.end());
    return *middle;
  }

  /// Errors: limit (memory), cancelled.
  Status make(PixelChain pixels, double scale, TableMemory& memory, Chain& chain) {
    SFUMATO_TRY(memory.reserve(context_, chain.point, pixels.size() + 1));
    SFUMATO_TRY(memory.reserve(context_, chain.strength, pixels.size() + 1));
    chain.scale = scale;
    for (const PixelPlace& p : pixels) {
      const EdgePixel& edge = edges_.at(p.x, p.y);
      chain.point.push_back({p.x + 0.5 + edge.offset_x, p.y + 0.5 + edge.offset_y});
      chain.strength.push_back(edge.strength);
    }
    close_and_smooth(chain);
    return ok_status();
  }

 private:
  void close_and_smooth(Chain& chain) {
    chain.is_closed = chain.point.size() > kLoopPixels &&
                      length(chain.point.front() - chain.point.back()) < kLoopGap;
    if (chain.is_closed && chain.point.front() == chain.point.back()) {
      chain.point.pop_back();
      chain.strength.pop_back();
    }
    if (chain.point.size() > 5) {
      smooth(options_.smoothing * std::sqrt(chain.scale), chain.is_closed,
             std::span(smoothed_).first(chain.point.size()), chain.point);
    }
    if (chain.is_closed) {
      chain.point.push_back(chain.point.front());
      chain.strength.push_back(chain.strength.front());
    }
  }

  const Context& context_;
  const EdgeMap& edges_;
  const ChainOptions& options_;
  TableMemory memory_{"the edges of a picture"};
  std::vector<float> found_at_;
  std::vector<Vec2> smoothed_;
};

std::size_t longest_of(const PixelChains& chains) {
  std::size_t longest = 0;
  for (std::size_t i = 0; i < chains.size(); ++i) longest = std::max(longest, chains[i].size());
  return longest;
}

}  // namespace

Result<std::vector<Chain>> link_chains(Context& context, const EdgeMap& edges, TableMemory& memory,
                                       const ChainOptions& options) {
  SFUMATO_TRY_ASSIGN(auto&& pixels, pixel_chains(context, edges));
  SFUMATO_TRY(join_gaps(context, pixels, edges, options.gap));
  ChainMaker maker(context, edges, options);
  // Two more run on at its ends.
  SFUMATO_TRY(maker.make_room(longest_of(pixels) + 2));
  TableMemory own_memory("the edges of a picture");
  std::vector<double> scales;
  SFUMATO_TRY(own_memory.reserve(context, scales, pixels.size()));
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    if (context.cancelled()) return context.cancel_status();
    scales.push_back(maker.median_scale(pixels[i]));
  }
  SFUMATO_TRY(snap_ends(context, edges, scales, options.snap_base, options.snap_rise, pixels));
  std::vector<Chain> chains;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    if (context.cancelled()) return context.cancel_status();
    const double least = options.least_length * std::sqrt(scales[i]);
    if (static_cast<double>(pixels[i].size()) < least) continue;
    Chain chain;
    SFUMATO_TRY(maker.make(pixels[i], scales[i], memory, chain));
    SFUMATO_TRY(memory.push_back(context, chains, std::move(chain)));
  }
  return chains;
}

}  // namespace sfumato::tracing
