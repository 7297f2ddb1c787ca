#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "solve/nodes.hpp"

namespace sfumato::solve {

/// What update_layout keeps from one update of a layout to the next. Empty at first.
struct LayoutHistory {
  std::vector<std::uint32_t> fresh;        ///< nodes to gather, of the last update: see there
  std::vector<std::uint32_t> unused;       ///< nodes that no triangle has any more, for later ones
  std::vector<std::uint32_t> node_seen;    ///< per node: the last update that met it
  std::vector<std::uint32_t> vertex_seen;  ///< per vertex, likewise
  std::vector<std::uint8_t> is_changed;    ///< per triangle; 0 between updates
  std::uint32_t updates = 0;

  /// Gives back to `memory`, the layout's, what the tables took from it.
  void free(TableMemory& memory);
};

/// Lays out the nodes of the triangles that changed, and anew those at their corners: curves there
/// have shorter edges now, which moves the last bits of what they give. What an unchanged triangle
/// has keeps its number and, where it is free, its value (but for values of two curves that were
/// the same within rounding and are so no more). Beside the numbers of nodes, those that no
/// triangle has and the values of free ones the layout is what lay_out_nodes would make.
///
/// Refinement keeps this simple. Curves are only cut, so that the sectors at a vertex stay, and so
/// does what has a value there. And what a triangle shares with others depends on its neighbours
/// and on the fans at its corners: no fan changes without a changed triangle in it.
///
/// seams     of the mesh as it is now
/// changed   triangles, new ones among them, ascending: Mesher::update_patch_mesh
/// memory    that of the layout, and of the history's tables
/// history   history.fresh: the free nodes whose values nobody knows, in the order in which
///           lay_out_nodes would put them
/// Errors    limit (memory), cancelled; the layout is good for nothing then
/// Cost      O(fans around changed triangles · log)
Status update_layout(const Context& context, const mesh::TriangleMesh& mesh,
                     const curves::SegmentAttributes& attributes, const Seams& seams,
                     std::span<const std::uint32_t> changed, TableMemory& memory,
                     NodeLayout& layout, LayoutHistory& history);

}  // namespace sfumato::solve
