#pragma once

#include <cstdint>
#include <vector>

#include "base/table_memory.hpp"
#include "curves/attributes.hpp"
#include "mesh/triangle_mesh.hpp"
#include "sfumato/picture/picture.hpp"
#include "solve/fields/seams.hpp"

namespace sfumato::solve {

/// The channel of opacity in a field of colour and opacity.
inline constexpr int kOpacityChannel = 3;

/// Stands for a place without a node.
inline constexpr std::uint32_t kNoNode = 0xffffffff;

/// The evaluation nodes of one attribute on a patch mesh (paper section 4, Fig. 3 and 4): the node
/// at each of a triangle's ten places, and its value if this is known without a gather.
///
/// Nodes off the curves with the attribute are shared by the triangles around them. On such a curve
/// each side has separate nodes; a side with a shader fixes their values, an open side leaves them
/// free.
struct NodeLayout {
  int channel_count = 0;                     ///< SegmentAttributes::channel_count()
  std::vector<std::uint32_t> triangle_node;  ///< as in PatchField
  std::vector<std::uint8_t> edge_is_curve;   ///< 3 per triangle, as in PatchLayer
  std::vector<Vec2> position;          ///< per node, layer frame: where it is gathered if free
  std::vector<std::uint8_t> is_fixed;  ///< per node: 1 where the curve gives the value
  std::vector<float> value;            ///< channel_count per node; 0 where free

  std::uint32_t node_count() const { return static_cast<std::uint32_t>(position.size()); }
};

/// Lays out the nodes in the order of the triangles, so that neighbours in the list are neighbours
/// in the plane. `seams` is made from the same mesh and attributes. The layout is allocated from
/// `memory`, with room for about `spare` more triangles. Errors: limit (memory), cancelled. Cost:
/// O(triangles). Use solve/fields/layout_update.hpp for a mesh that changes.
Result<NodeLayout> lay_out_nodes(const Context& context, const mesh::TriangleMesh& mesh,
                                 const curves::SegmentAttributes& attributes, const Seams& seams,
                                 TableMemory& memory, std::size_t spare = 0);

}  // namespace sfumato::solve
