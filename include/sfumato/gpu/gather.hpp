#pragma once

#include <string>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato {

namespace gpu {
/// Internal: defined in src/gpu/gather_device.hpp.
class GatherDevice;
}  // namespace gpu

/// A GPU that gathers the colours at points, by compute shaders of OpenGL ES 3.1 without a window;
/// without a GPU, Mesa's software driver. Put its source() into Context::point_source: it then
/// replaces the CPU in all exact gathers: diffuse(), Solution, render_pixels() and PointEvaluator.
///
/// Its values are within 0.05 code values of 255 of the integral, like the CPU's, but not equal to
/// these to the last bit; they do not depend on threads. Where max_error decides by a threshold, it
/// may split a triangle that the CPU does not split. The CPU gathers few points, points that the
/// device cannot gather, and all points after the device was lost: a call never fails because of
/// the GPU.
///
/// Movable. Several Contexts may use it at the same time, and it must outlive their calls.
class GpuGather {
 public:
  /// Opens the device. Errors: unavailable (no EGL, no context of OpenGL ES 3.1), out_of_memory.
  /// Cost: 20 to 50 ms, and 10 to 100 ms for its shader with the first points.
  static Result<GpuGather> create();

  /// Makes an empty object, whose source() is null.
  GpuGather() = default;
  /// Moves; `other` is empty afterwards.
  GpuGather(GpuGather&& other) noexcept;
  /// Exchanges the devices of both objects.
  GpuGather& operator=(GpuGather&& other) noexcept;
  ~GpuGather();

  /// Returns the source for Context::point_source.
  PointSource* source() const;

  /// Returns the device's name, from its driver.
  std::string device_name() const;

  /// Returns whether the device no longer responds, so that the CPU does all work.
  bool is_lost() const;

 private:
  explicit GpuGather(gpu::GatherDevice* device) : device_(device) {}

  gpu::GatherDevice* device_ = nullptr;
};

}  // namespace sfumato
