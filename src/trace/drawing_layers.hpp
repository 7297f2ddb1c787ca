#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/charge.hpp"
#include "base/table_memory.hpp"
#include "curves/attributes.hpp"
#include "curves/flatten.hpp"
#include "mesh/triangle_mesh.hpp"
#include "sfumato/base/affine.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"
#include "trace/sample_pixels.hpp"

namespace sfumato::tracing {

/// A picture as it is laid over a drawing's artboard.
struct LaidPicture {
  int width = 0;   ///< pixels
  int height = 0;  ///< pixels
  Affine artboard_from_pixel;
};

/// A layer of a drawing, prepared for the rows of its colours and opacities.
struct DrawnLayer {
  curves::FlatCurves flat;
  ScopedCharge flat_charge;
  mesh::TriangleMesh mesh;
  curves::SegmentAttributes color_places;
  std::optional<curves::SegmentAttributes> opacity_places;  ///< none: it is opaque
  std::vector<float> opacity;                               ///< of each stop of opacity
  double px_per_unit = 1;  ///< of the instance that enlarges it most
  TableMemory memory{"the layers of a drawing"};
};

/// The longest image of a unit vector.
double largest_scale(const Affine& map);

/// Prepares a layer; nothing where it has no curves or no instance can be painted.
/// Errors: limit (counts, memory), cancelled.
Result<std::optional<DrawnLayer>> prepare_layer(Context& context, const Document& drawing,
                                                std::uint32_t layer, const LaidPicture& picture);

/// Marks the pixels that sharp curves of an instance cross. Errors: cancelled.
Status mark_sharp_curves(const Context& context, const std::vector<Curve>& curves,
                         const curves::FlatCurves& flat, const Affine& pixel_from_layer,
                         PixelMarks& marks);

}  // namespace sfumato::tracing
