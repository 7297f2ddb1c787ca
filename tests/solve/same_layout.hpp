#pragma once

#include <string>

#include "solve/fields/layout_order.hpp"
#include "solve/fields/nodes.hpp"

namespace sfumato::solve {

/// Returns the difference of two layouts, except in the values of free nodes; empty: none.
inline std::string difference_of(const NodeLayout& layout, const NodeLayout& anew) {
  if (layout.position != anew.position) return "positions";
  if (layout.is_fixed != anew.is_fixed) return "fixed nodes";
  if (layout.triangle_node != anew.triangle_node) return "nodes of triangles";
  if (layout.edge_is_curve != anew.edge_is_curve) return "edges on curves";
  if (layout.value.size() != anew.value.size()) return "number of values";
  const auto channels = static_cast<std::size_t>(layout.channel_count);
  for (std::size_t i = 0; i < layout.value.size(); ++i) {
    if (layout.is_fixed[i / channels] && layout.value[i] != anew.value[i])
      return "value of fixed node " + std::to_string(i / channels);
  }
  return "";
}

/// Returns the difference of a sorted layout from a new layout of the mesh.
inline std::string difference_from_new_layout(const Context& context,
                                              const mesh::TriangleMesh& mesh,
                                              const curves::SegmentAttributes& attributes,
                                              NodeLayout layout) {
  TableMemory memory("a test");
  const Result<std::vector<std::uint32_t>> order = put_in_order(context, mesh, memory, layout);
  if (!order) return order.status().message;
  const Result<Seams> seams = Seams::create(context, mesh, attributes);
  if (!seams) return seams.status().message;
  const Result<NodeLayout> anew = lay_out_nodes(context, mesh, attributes, *seams, memory);
  return anew ? difference_of(layout, *anew) : anew.status().message;
}

}  // namespace sfumato::solve
