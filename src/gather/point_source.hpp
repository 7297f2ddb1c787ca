#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "gather/scene.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::gather {

/// Points of a scene's frame, and the triangle in which each lies.
struct WalkPoint {
  float x, y;
  std::int32_t triangle;
};

/// How many numbers PointSource::sum gives for each point.
inline std::size_t sums_of_point(const Scene& scene) {
  return 1 + std::size_t{kValueChannels} + static_cast<std::size_t>(scene.shader_count);
}

}  // namespace sfumato::gather

namespace sfumato {

/// Who gathers exactly at many points in place of the packets of kernels/: a GPU. Calls may come
/// from several threads at once.
class PointSource {
 public:
  virtual ~PointSource() = default;

  /// Of fewer points it is not asked.
  virtual std::size_t least_points() const = 0;

  /// Gathers by point_walk.glsl, without far fields and free ends, which are not its business.
  /// point   neighbours in the list are near each other in the mesh
  /// sums    for each point W, Σ w z of gather::kValueChannels channels and W_s of each shader,
  /// before the
  ///         division; a negative W: nothing could be found out about this point
  /// Errors  limit, cancelled; unavailable where no point can be gathered, now and later
  virtual Status sum(Context& context, const gather::Scene& scene,
                     std::span<const gather::WalkPoint> point, std::span<float> sums) = 0;
};

}  // namespace sfumato
