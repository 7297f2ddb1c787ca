#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/charge.hpp"
#include "base/table_memory.hpp"
#include "curves/attributes.hpp"
#include "curves/flatten.hpp"
#include "gather/gather.hpp"
#include "mesh/triangle_mesh.hpp"
#include "sfumato/base/affine.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"
#include "trace/fit/sparse.hpp"
#include "trace/image/sample_pixels.hpp"

namespace sfumato::tracing {

/// A picture as it is laid over a drawing's artboard.
struct LaidPicture {
  int width = 0;   ///< pixels
  int height = 0;  ///< pixels
  Affine artboard_from_pixel;
};

/// A layer of a drawing, prepared for its opacities and for rows of its colours.
struct DrawnLayer {
  curves::FlatCurves flat;
  ScopedCharge flat_charge;
  mesh::TriangleMesh mesh;
  Box frame;  ///< covered by the mesh
  curves::SegmentAttributes color_places;
  std::vector<FourFloats> color;  ///< of each stop, in the drawing's interpolation space
  std::optional<curves::SegmentAttributes> opacities{};  ///< none: it is opaque
  std::optional<gather::Gatherer> opacity_gatherer{};
  Box opacity_box;         ///< around all curves with opacity, including their blur
  double px_per_unit = 1;  ///< of the instance that enlarges it most
  TableMemory memory{"the layers of a drawing"};
};

/// Prepares a layer. Returns nothing if it has no curves or no instance can be painted. Errors:
/// limit (counts, memory), cancelled.
Result<std::optional<DrawnLayer>> prepare_layer(Context& context, const Document& drawing,
                                                std::uint32_t layer, const LaidPicture& picture);

/// Marks the pixels that sharp curves of an instance cross. Errors: cancelled.
Status mark_sharp_curves(const Context& context, const std::vector<Curve>& curves,
                         const curves::FlatCurves& flat, const Affine& pixel_from_layer,
                         PixelMarks& marks);

}  // namespace sfumato::tracing
