#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "gather/rows.hpp"
#include "raster/image_shader.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"
#include "trace/drawing_layers.hpp"
#include "trace/sample_pixels.hpp"
#include "trace/sparse.hpp"

namespace sfumato::tracing {

/// What some points show of an instance of a layer: `coefficient` times its colour, in code values.
struct ShownInstance {
  std::uint32_t layer = 0;
  Affine layer_from_pixel;
  std::vector<std::uint32_t> point;  ///< indices of SamplePixels::point, ascending
  std::vector<float> coefficient;    ///< per point: its opacity there, through all above it
  gather::Rows rows;                 ///< of its colours, per point
  TableMemory memory{"what a drawing shows"};
};

/// The image-domain shaders that sides name, as indices of Document::shaders.
using ImageShaders = std::vector<std::optional<raster::ImageShader>>;

/// A drawing at points of a picture: the colour of a point, in code values, is the sum of what it
/// shows of all instances and `fixed`.
struct StackPoints {
  std::vector<ShownInstance> shown;
  std::vector<FourFloats> fixed;  ///< per point: of strokes and the backdrop
  /// Per pixel: 1 where something shows that is mixed by another mode than normal. Coefficients
  /// are 0 there.
  std::vector<std::uint8_t> is_left_out;
  ImageShaders color_shaders;  ///< in the drawing's interpolation space
  TableMemory memory{"what a drawing shows"};
};

/// Follows the stack of a drawing, from above, at the points of pixels.
///
/// layers    of the drawing, as prepare_layer() gives them
/// backdrop  behind all items
/// Errors    limit (memory, counts), cancelled
/// Cost      the rows of each instance's colours, and if it has any opacities, at all points at
///           which what is above it does not hide it; strokes as they are painted
Result<StackPoints> look_through(Context& context, const Document& drawing,
                                 std::span<const std::optional<DrawnLayer>> layers,
                                 const LaidPicture& picture, const SamplePixels& pixels,
                                 const Rgb& backdrop);

}  // namespace sfumato::tracing
