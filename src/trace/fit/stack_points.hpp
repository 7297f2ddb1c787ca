#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"
#include "trace/curves/drawing_layers.hpp"
#include "trace/fit/instance_sight.hpp"
#include "trace/fit/row_color.hpp"
#include "trace/fit/sparse.hpp"
#include "trace/image/sample_pixels.hpp"

namespace sfumato::tracing {

/// Holds how points show an instance of a layer whose colours are fitted.
struct ShownInstance {
  std::uint32_t layer = 0;
  InstanceSight sight;
  /// Per point of the sight and channel: the weight of the instance's colour there, through all
  /// items above it; and the least of the three. 0 where nothing is fitted to the pixel.
  std::vector<FourFloats> coefficient;
};

/// A drawing at points of a picture: the code values of a point are the sum of coefficients times
/// colours of all instances, and `fixed`.
struct StackPoints {
  std::vector<ShownInstance> shown;
  std::vector<FourFloats> fixed;          ///< per point: the sum of all unfitted items
  std::vector<std::uint32_t> pixel_of;    ///< per point: index into SamplePixels::pixel
  std::vector<std::uint8_t> is_left_out;  ///< per pixel: 1 where that is not true
  ImageShaders color_shaders;             ///< in the drawing's interpolation space
  TableMemory memory{"what a drawing shows"};
};

/// Follows the stack of a drawing from above at the points of pixels.
///
/// Layers that have another mode than normal anywhere, themselves or in a group, are fixed, and so
/// are local curves. Modes `multiply` and `screen` outside of groups are affine in the opaque items
/// below. Pixels where another mode, or a mode in a group, shows are left out.
///
/// layers    of the drawing, as prepare_layer() gives them
/// backdrop  behind all items
/// Errors    limit (memory, counts), cancelled
/// Cost      the rows of each instance's colours, and if it has any opacities, at all points at
///           which it may show and is not hidden; local curves as they are painted
Result<StackPoints> look_through(Context& context, const Document& drawing,
                                 std::span<const std::optional<DrawnLayer>> layers,
                                 const LaidPicture& picture, const SamplePixels& pixels,
                                 const Rgb& backdrop);

}  // namespace sfumato::tracing
