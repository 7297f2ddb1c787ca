#include "trace/image/edges.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/parallel.hpp"
#include "base/poll.hpp"
#include "base/try.hpp"
#include "trace/image/distance.hpp"
#include "trace/image/gradient.hpp"
#include "trace/image/thinning.hpp"

namespace sfumato::tracing {
namespace {

constexpr std::size_t kEdgeRows = 16;

/// In pixels: an edge is never farther from the centre of its pixel.
constexpr float kMostOffset = 0.7f;

/// Less is nothing, and has no logarithm.
constexpr float kLeastStrength = 1e-6f;

/// The two neighbours of a pixel across the edge, one pixel away.
struct Across {
  float ahead, behind;
};

Across across(const Gradient& gradient, int x, int y) {
  const Vec2 p{x + 0.5, y + 0.5};
  const Vec2 normal{gradient.normal_x.at(x, y), gradient.normal_y.at(x, y)};
  return {gradient.strength.sample(p + normal), gradient.strength.sample(p - normal)};
}

/// Strengths at one scale.
struct Thresholds {
  float low, high;
};

/// The gradient of white noise after a Gaussian has the standard deviation n / (s² √(8π)) in each
/// direction; three channels, three standard deviations.
Thresholds thresholds_of(const EdgeOptions& options, double scale) {
  const double fall = std::pow(scale, -0.25);
  const double noise =
      3 * std::sqrt(3.0) * options.noise / (scale * std::sqrt(8 * std::numbers::pi));
  return {static_cast<float>(std::max(options.low * fall, noise)),
          static_cast<float>(std::max(options.high * fall, 2 * noise))};
}

class EdgeFinder {
 public:
  EdgeFinder(Context& context, std::span<const Plane> channels, const EdgeOptions& options)
      : context_(context), channels_(channels), options_(options) {}

  Result<EdgeMap> run(const Plane& taken) {
    map_.width = set_.width = channels_[0].width;
    map_.height = set_.height = channels_[0].height;
    const std::size_t pixels = channels_[0].value.size();
    SFUMATO_TRY(map_.memory.resize(context_, map_.pixel, pixels));
    SFUMATO_TRY(scratch_.resize(context_, set_.is_set,
                                set_.stride() * (static_cast<std::size_t>(set_.height) + 2)));
    SFUMATO_TRY(make_plane(context_, map_.width, map_.height, scratch_, distance_));
    SFUMATO_TRY(make_plane(context_, map_.width, map_.height, scratch_, taken_));
    if (taken.value.empty()) {
      std::ranges::fill(taken_.value, kFar);
    } else {
      std::ranges::copy(taken.value, taken_.value.begin());
    }
    SFUMATO_TRY(find_distance());
    for (const double scale : options_.scales) {
      SFUMATO_TRY(add_scale(scale));
    }
    return std::move(map_);
  }

 private:
  Status add_scale(double scale) {
    Status status = find_gradient(context_, channels_, scale, scratch_, gradient_);
    for (float& strength : gradient_.strength.value) strength *= static_cast<float>(scale);
    if (status) status = mark_maxima();
    if (status) status = keep_connected(thresholds_of(options_, scale));
    if (status) status = thin(context_, set_);
    if (status) take(scale);
    return status ? find_distance() : status;
  }

  Status mark_maxima() {
    const auto height = static_cast<std::size_t>(map_.height);
    return parallel_for(context_, height, kEdgeRows, [&](std::size_t begin, std::size_t end) {
      for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y) {
        for (int x = 0; x < map_.width; ++x) {
          const float here = gradient_.strength.at(x, y);
          const Across beside = across(gradient_, x, y);
          set_.is_set[set_.index(x, y)] = here >= beside.ahead && here > beside.behind;
        }
      }
    });
  }

  /// Keeps maxima above the low threshold that are connected with one above the high threshold.
  Status keep_connected(const Thresholds& thresholds) {
    RarePoll<4096> poll(context_);
    const std::size_t stride = set_.stride();
    constexpr std::uint8_t kWeak = 1, kStrong = 2, kKept = 3;
    for (int y = 0; y < map_.height; ++y) {
      for (int x = 0; x < map_.width; ++x) {
        std::uint8_t& mark = set_.is_set[set_.index(x, y)];
        const float strength = gradient_.strength.at(x, y);
        if (mark) mark = strength > thresholds.high ? kStrong : strength > thresholds.low;
      }
    }
    std::vector<std::size_t> waiting;
    for (std::size_t i = 0; i < set_.is_set.size(); ++i) {
      if (set_.is_set[i] != kStrong) continue;
      set_.is_set[i] = kKept;
      waiting.push_back(i);
      while (!waiting.empty()) {
        if (poll.cancelled()) return context_.cancel_status();
        const std::size_t at = waiting.back();
        waiting.pop_back();
        for (const std::size_t row : {at - stride, at, at + stride}) {
          for (std::size_t near = row - 1; near <= row + 1; ++near) {
            if (set_.is_set[near] != kWeak && set_.is_set[near] != kStrong) continue;
            set_.is_set[near] = kKept;
            waiting.push_back(near);
          }
        }
      }
    }
    for (std::uint8_t& mark : set_.is_set) mark = mark == kKept;
    return context_.check();
  }

  void take(double scale) {
    const double clear = options_.clear * clear_distance(scale);
    const auto least = static_cast<float>(clear * clear);
    for (int y = 0; y < map_.height; ++y) {
      for (int x = 0; x < map_.width; ++x) {
        if (!set_.is_set[set_.index(x, y)]) continue;
        if (distance_.at(x, y) <= least) continue;
        map_.pixel[distance_.index(x, y)] = edge_at(x, y, scale);
        taken_.value[distance_.index(x, y)] = std::min(taken_.at(x, y), 0.0f);
      }
    }
  }

  /// Returns the top of the parabola through the logarithms of the strength in the pixel and beside
  /// it across: that of a blurred step is a Gaussian.
  EdgePixel edge_at(int x, int y, double scale) const {
    const float here = gradient_.strength.at(x, y);
    const auto [ahead, behind] = across(gradient_, x, y);
    const float rise_ahead = std::log(std::max(ahead, kLeastStrength) / here);
    const float rise_behind = std::log(std::max(behind, kLeastStrength) / here);
    const float bend = rise_ahead + rise_behind;
    const float top = bend < 0 ? 0.5f * (rise_behind - rise_ahead) / bend : 0.0f;
    const float offset = std::clamp(top, -kMostOffset, kMostOffset);
    return {static_cast<float>(scale), here, offset * gradient_.normal_x.at(x, y),
            offset * gradient_.normal_y.at(x, y)};
  }

  Status find_distance() {
    std::ranges::copy(taken_.value, distance_.value.begin());
    return transform_distance(context_, distance_);
  }

  Context& context_;
  std::span<const Plane> channels_;
  const EdgeOptions& options_;
  EdgeMap map_;
  PixelSet set_;
  Gradient gradient_;
  Plane taken_;     ///< the input of find_edges(), plus the edges found since
  Plane distance_;  ///< squared, to these
  TableMemory scratch_{"the edges of a picture"};
};

}  // namespace

Result<EdgeMap> find_edges(Context& context, std::span<const Plane> channels,
                           const EdgeOptions& options, const Plane& taken) {
  return EdgeFinder(context, channels, options).run(taken);
}

}  // namespace sfumato::tracing
