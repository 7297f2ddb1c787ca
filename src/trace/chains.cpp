#include "trace/chains.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/poll.hpp"
#include "trace/pixel_chains.hpp"

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

/// Points smoothed along the chain. Of an open chain the ends stay where they are.
std::vector<Vec2> smoothed(const std::vector<Vec2>& points, double sigma, bool is_loop) {
  const std::vector<double> weight = weights_along(sigma);
  const auto count = static_cast<std::ptrdiff_t>(points.size());
  std::vector<Vec2> out(points.size());
  const auto at = [&](std::ptrdiff_t i) {
    i = is_loop ? (i % count + count) % count : std::clamp<std::ptrdiff_t>(i, 0, count - 1);
    return points[static_cast<std::size_t>(i)];
  };
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    Vec2 sum = weight[0] * at(i);
    double total = weight[0];
    for (std::ptrdiff_t k = 1; k < static_cast<std::ptrdiff_t>(weight.size()); ++k) {
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
  return out;
}

double median_scale(const EdgeMap& edges, const PixelChain& pixels) {
  std::vector<float> scales;
  for (const PixelPlace& p : pixels) {
    if (const float scale = edges.at(p.x, p.y).scale; scale > 0) scales.push_back(scale);
  }
  if (scales.empty()) return 1;
  const auto middle = scales.begin() + static_cast<std::ptrdiff_t>(scales.size() / 2);
  std::nth_element(scales.begin(), middle, scales.end());
  return *middle;
}

Chain chain_of(const EdgeMap& edges, const PixelChain& pixels, double scale,
               const ChainOptions& options) {
  Chain chain;
  chain.scale = scale;
  for (const PixelPlace& p : pixels) {
    const EdgePixel& edge = edges.at(p.x, p.y);
    chain.point.push_back({p.x + 0.5 + edge.offset_x, p.y + 0.5 + edge.offset_y});
    chain.strength.push_back(edge.strength);
  }
  chain.is_closed = chain.point.size() > kLoopPixels &&
                    length(chain.point.front() - chain.point.back()) < kLoopGap;
  if (chain.is_closed && chain.point.front() == chain.point.back()) {
    chain.point.pop_back();
    chain.strength.pop_back();
  }
  if (chain.point.size() > 5) {
    chain.point = smoothed(chain.point, options.smoothing * std::sqrt(scale), chain.is_closed);
  }
  if (chain.is_closed) {
    chain.point.push_back(chain.point.front());
    chain.strength.push_back(chain.strength.front());
  }
  return chain;
}

}  // namespace

Result<std::vector<Chain>> link_chains(Context& context, const EdgeMap& edges,
                                       const ChainOptions& options) {
  Result<std::vector<PixelChain>> pixels = pixel_chains(context, edges);
  if (!pixels) return pixels.status();
  Status status = join_gaps(context, *pixels, edges, options.gap);
  if (!status) return status;
  std::vector<double> scales;
  for (const PixelChain& chain : *pixels) scales.push_back(median_scale(edges, chain));
  status = snap_ends(context, edges, scales, options.snap_base, options.snap_rise, *pixels);
  if (!status) return status;
  std::vector<Chain> chains;
  for (std::size_t i = 0; i < pixels->size(); ++i) {
    if (context.cancelled()) return context.cancel_status();
    const PixelChain& chain = (*pixels)[i];
    const double least = options.least_length * std::sqrt(scales[i]);
    if (static_cast<double>(chain.size()) < least) continue;
    chains.push_back(chain_of(edges, chain, scales[i], options));
  }
  return chains;
}

}  // namespace sfumato::tracing
