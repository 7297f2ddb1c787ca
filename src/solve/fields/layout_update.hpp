#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "solve/fields/nodes.hpp"

namespace sfumato::solve {

/// Data that update_layout keeps from one update of a layout to the next. Empty at first.
struct LayoutHistory {
  std::vector<std::uint32_t> fresh;        ///< nodes of the last update to be gathered
  std::vector<std::uint32_t> unused;       ///< nodes that no triangle uses any more, to be reused
  std::vector<std::uint32_t> node_seen;    ///< per node: the last update that met it
  std::vector<std::uint32_t> vertex_seen;  ///< per vertex: the last update that met it
  std::vector<std::uint8_t> is_changed;    ///< per triangle; 0 between updates
  std::uint32_t updates = 0;
  /// Whether updates will be undone. The lists then contain the nodes that they met, and triangles
  /// that did not change but have other nodes. Either may be listed more than once.
  bool is_logged = false;
  std::vector<std::uint32_t> met;
  std::vector<std::uint32_t> reassigned;

  /// Releases the tables to `memory`, which is the layout's.
  void free(TableMemory& memory);

  /// Returns whether the last update placed the node, or found it unused: other nodes are
  /// unchanged.
  bool was_met(std::uint32_t node) const { return node_seen[node] == updates; }
};

/// Lays out the nodes of the triangles that changed, and again the nodes at their corners. Curves
/// there have shorter edges now, which changes the last bits of their values. A node of an
/// unchanged triangle keeps its number and, if it is free, its value. (Exception: values of two
/// curves that were equal within rounding and no longer are.) The layout becomes the one that
/// lay_out_nodes would make, except for the numbers of nodes, nodes that no triangle uses and the
/// values of free nodes.
///
/// Refinement keeps this simple: curves are only cut, so that the sectors at a vertex and the sides
/// that have a value there stay the same. The nodes that a triangle shares with others depend only
/// on its neighbours and on the fans at its corners, and no fan changes without a changed triangle
/// in it. Where curves were inserted that does not hold at their vertices: all triangles there must
/// be in `changed`.
///
/// seams     of the current mesh
/// changed   triangles, including new ones, ascending; see Mesher::update_patch_mesh
/// memory    memory of the layout and of the history's tables
/// history   history.fresh: the free nodes whose values are unknown, in the order of lay_out_nodes
/// Errors    limit (memory), cancelled; the layout is then unusable
/// Cost      O(fans around changed triangles · log)
Status update_layout(const Context& context, const mesh::TriangleMesh& mesh,
                     const curves::SegmentAttributes& attributes, const Seams& seams,
                     std::span<const std::uint32_t> changed, TableMemory& memory,
                     NodeLayout& layout, LayoutHistory& history);

/// Restores `layout`, a copy of `before` with logged updates, to `before`, except for the values of
/// free nodes that no update met; and the history to its empty state.
///
/// changed   the triangles that changed in these updates
/// Cost      O(changes)
void take_back(const NodeLayout& before, std::span<const std::uint32_t> changed, NodeLayout& layout,
               LayoutHistory& history);

}  // namespace sfumato::solve
