#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "gather/scene/scene.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::gather {

/// A point in a scene's frame, and the triangle that contains it.
struct WalkPoint {
  float x, y;
  std::int32_t triangle;
};

/// Returns how many numbers PointSource::sum gives for each point.
inline std::size_t sums_of_point(const Scene& scene) {
  return 1 + std::size_t{kValueChannels} + static_cast<std::size_t>(scene.shader_count);
}

}  // namespace sfumato::gather

namespace sfumato {

/// Gathers exactly at many points instead of the packets of kernels/: a GPU. Calls may come from
/// several threads at once.
class PointSource {
 public:
  virtual ~PointSource() = default;

  /// Returns the fewest points that are worth a call.
  virtual std::size_t least_points() const = 0;

  /// Gathers by point_walk.glsl, without far fields and free ends, which the caller adds.
  ///
  /// point   neighbours in the list are near each other in the mesh
  /// sums    for each point W, Σ w z of gather::kValueChannels channels and W_s of each shader,
  ///         before the division; a negative W: the point could not be gathered
  /// Errors  limit, cancelled; unavailable where no point can be gathered, now and later
  virtual Status sum(Context& context, const gather::Scene& scene,
                     std::span<const gather::WalkPoint> point, std::span<float> sums) = 0;
};

}  // namespace sfumato
