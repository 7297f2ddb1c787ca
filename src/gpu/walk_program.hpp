#pragma once

#include <cstddef>
#include <limits>

#include "gpu/device.hpp"
#include "gpu/program.hpp"

namespace sfumato::gpu {

/// The parameters for compiling point_walk.glsl for a device.
struct WalkShape {
  int stack = 16;       ///< windows that may wait, a power of two; the values hardly depend on it
  int local_size = 64;  ///< points of a work group
  bool is_precise = true;  ///< if the device supports it: the bits of the C++ twin

  /// Compares all members exactly.
  friend bool operator==(const WalkShape&, const WalkShape&) = default;
};

/// Storage blocks that the program binds; OpenGL ES 3.1 has at least four.
enum class WalkBlock : GLuint { tables, points, results };
constexpr int kWalkBlocks = 3;

/// The storage blocks of a device. Tests reduce the driver's numbers.
struct WalkLimits {
  int blocks = std::numeric_limits<int>::max();
  std::size_t block_bytes = std::numeric_limits<std::size_t>::max();
};

/// Compiles the compute shader that gathers points; `blends`: for scenes with SceneView::blend.
/// Uniforms: `hit_begin`, `blend_begin` and `triangle_begin`, the first texels of these tables,
/// which begin with the outer edges; `point_count`, `numbers_of_point`, `negligible_share`,
/// `step_limit`. Errors: internal, with the compiler's message.
Result<Program> walk_program(const Device& device, const WalkShape& shape, bool blends);

}  // namespace sfumato::gpu
