#pragma once

#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/base/vec2.hpp"
#include "trace/image/plane.hpp"

namespace sfumato::tracing {

/// The conditions for an edge.
struct EdgeOptions {
  /// Standard deviations of the Gaussians, pixels, the finest first. An edge at a coarser scale
  /// counts only away from edges at finer scales.
  std::vector<double> scales{1, 2, 4};
  /// Strengths at which an edge begins and continues, for scale 1; for other scales times
  /// scale^(-1/4). A step of height h has the strength 0.4 h at every scale.
  double high = 0.018;
  double low = 0.006;
  double noise = 0;  ///< standard deviation of the noise in a channel
  double clear = 1;  ///< of clear_distance() to what was found before
};

/// An edge in one pixel.
struct EdgePixel {
  float scale = 0;  ///< scale of the edge; 0: there is no edge
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

/// The least distance of an edge at this scale from edges at finer scales, pixels.
constexpr double clear_distance(double scale) {
  return 1 + 1.2 * scale;
}

}  // namespace sfumato::tracing
