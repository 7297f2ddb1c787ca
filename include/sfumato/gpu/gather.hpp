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
/// where there is none, Mesa's software driver. Put into Context::point_source, it takes the place
/// of the CPU in all that gathers exactly: diffuse(), Solution, render_pixels() and PointEvaluator.
///
/// Its values are within 0.05 code values of 255 of the integral, like the CPU's, but not those to
/// the last bit; they do not depend on threads. Where max_error decides by a threshold, a triangle
/// may be split that is not split by the CPU. Few points, those that it cannot gather, and all
/// after the device was lost, the CPU gathers: a call never fails for want of a GPU.
///
/// Movable. It may be used by several Contexts at the same time, and must outlive their calls.
class GpuGather {
 public:
  /// Errors: unavailable (no EGL, no context of OpenGL ES 3.1), out_of_memory. Cost: 20 to 50 ms,
  /// and 10 to 100 ms for its shader with the first points.
  static Result<GpuGather> create();

  /// One of nothing, whose source() is null.
  GpuGather() = default;
  /// `other` has nothing afterwards.
  GpuGather(GpuGather&& other) noexcept;
  /// `other` has what this had.
  GpuGather& operator=(GpuGather&& other) noexcept;
  ~GpuGather();

  /// For Context::point_source.
  PointSource* source() const;

  /// The device's name, as its driver gives it.
  std::string device_name() const;

  /// Whether the device answers no more, so that the CPU does all.
  bool is_lost() const;

 private:
  explicit GpuGather(gpu::GatherDevice* device) : device_(device) {}

  gpu::GatherDevice* device_ = nullptr;
};

}  // namespace sfumato
