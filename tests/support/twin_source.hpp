#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>

#include "gather/kernels/negligible.hpp"
#include "gather/point_source.hpp"
#include "gather/point_walk_twin.hpp"

namespace sfumato::test {

/// Sums by point_walk.glsl compiled as C++: the result of a device, bit for bit.
template <int kStack = 16>
class TwinSource : public PointSource {
 public:
  std::size_t least_points() const override { return least; }

  Status sum(Context&, const gather::Scene& scene, std::span<const gather::WalkPoint> point,
             std::span<float> sums) override {
    const gather::SceneView view = scene.view();
    const std::size_t stride = gather::sums_of_point(scene);
    std::ranges::fill(sums, 0.0f);
    for (std::size_t i = 0; i < point.size(); ++i) {
      float* const row = sums.data() + i * stride;
      float* const shares = row + 1 + gather::kValueChannels;
      if (view.blend) {
        walk(gather::glsl::BlendedPointWalk<kStack>(view, shares), point[i], row);
      } else {
        walk(gather::glsl::SharpPointWalk<kStack>(view, shares), point[i], row);
      }
    }
    asked_ += point.size();
    return ok_status();
  }

  std::size_t asked() const { return asked_; }
  /// Returns the largest number of steps of a point.
  int most_steps() const { return most_steps_; }

  std::size_t least = 0;  ///< least_points()
  float negligible = gather::kPointNegligible;
  int step_limit = 1 << 17;

 private:
  template <class Walk>
  void walk(Walk walk, const gather::WalkPoint& point, float* row) {
    walk.gather({point.x, point.y}, point.triangle, negligible, step_limit);
    most_steps_ = std::max(most_steps_, walk.steps);
    row[0] = walk.failed ? -1 : walk.weight;
    row[1] = walk.value.x, row[2] = walk.value.y, row[3] = walk.value.z, row[4] = walk.value.w;
  }

  std::atomic<std::size_t> asked_ = 0;
  int most_steps_ = 0;
};

}  // namespace sfumato::test
