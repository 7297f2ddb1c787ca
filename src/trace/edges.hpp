#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/base/vec2.hpp"
#include "trace/plane.hpp"

namespace sfumato::tracing {

/// What counts as an edge.
struct EdgeOptions {
  /// Standard deviations of the Gaussians, pixels, the finest first. A coarser one counts only away
  /// from what finer ones found.
  std::vector<double> scales{1, 2, 4};
  /// Strengths with which an edge begins and goes on, for scale 1; for another times scale^(-1/4).
  /// A step of height h has the strength 0.4 h at every scale.
  double high = 0.018;
  double low = 0.006;
  double noise = 0;  ///< standard deviation of the noise in a channel
};

/// An edge in one pixel.
struct EdgePixel {
  float scale = 0;  ///< at which it was found; 0: there is none
  float strength = 0;
  float offset_x = 0;  ///< from the pixel's centre to the edge
  float offset_y = 0;
};

/// Thin lines of pixels along edges.
struct EdgeMap {
  int width = 0;
  int height = 0;
  std::vector<EdgePixel> pixel;
  TableMemory memory{"the edges of a picture"};

  const EdgePixel& at(int x, int y) const {
    return pixel[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                 static_cast<std::size_t>(x)];
  }
};

/// Edges where the gradient of all channels together is greatest across (Canny 1986, Di Zenzo
/// 1986).
///
/// taken    at pixels that are not to be found again 0, or less: -r² where the distance to be kept,
///          d, becomes √(d² + r²); kFar elsewhere. Empty: nothing is taken
/// Errors   limit (memory), cancelled
Result<EdgeMap> find_edges(Context& context, std::span<const Plane> channels,
                           const EdgeOptions& options, const Plane& taken = {});

/// How far from what was found at finer scales an edge at this one must be, pixels.
constexpr double clear_distance(double scale) {
  return 1 + 1.2 * scale;
}

}  // namespace sfumato::tracing
