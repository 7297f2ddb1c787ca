#pragma once

#include <optional>

#include "gpu/table.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato::gpu {

/// One field of a layer on the device.
struct FieldTables {
  Table node;                   ///< indices
  Table value;                  ///< colours, or opacities
  std::optional<Table> weight;  ///< of the field's shaders, four to a texel
};

/// A layer on the device.
struct LayerTables {
  Vec2 origin;  ///< layer frame; positions are relative to it
  Table triangle_vertex;
  Table vertex_position;
  FieldTables color;
  std::optional<FieldTables> opacity;
  Table edge_slot;  ///< edges that are curves
  std::uint32_t curve_edge_count = 0;
  Table is_bent;                    ///< one flag per triangle
  std::optional<Table> soft_edge;   ///< three numbers each; none if no edge is soft
  std::optional<Table> soft_reach;  ///< one texel each
  std::uint32_t soft_edge_count = 0;
  std::optional<Table> edge_is_curve;
};

/// Uploads a layer of a checked picture.
///
/// origin        layer frame; near the visible part, where single precision is finest
/// with_overlay  uploads edge_is_curve too
///
/// Errors: limit. Cost: O(triangles + nodes).
Result<LayerTables> upload_layer(Context& context, const Device& device, const PatchLayer& layer,
                                 Vec2 origin, bool with_overlay);

}  // namespace sfumato::gpu
