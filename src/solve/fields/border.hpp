#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "mesh/triangle_mesh.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/function_ref.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato::solve {

/// Callbacks that report to the border finder what the points of a layer see.
struct Sight {
  /// Returns whether a node of a triangle sees a curve; places as in PatchLayer.
  FunctionRef<bool(std::uint32_t triangle, std::size_t place)> node_sees;
  /// Returns whether the field may jump across the edge, so that its sides see different curves.
  FunctionRef<bool(std::uint32_t half_edge)> is_seam;
  /// Does node_sees for any points. Errors: limit, cancelled.
  FunctionRef<Status(std::span<const Vec2> points, std::span<std::uint8_t> seen)> look;
};

/// Replacements of the triangles that the border of the seen region cuts: their parts on the seen
/// side.
struct BorderCuts {
  static constexpr std::int32_t kInside = -1;  ///< an edge between two parts of a triangle
  static constexpr std::int32_t kBorder = -2;  ///< an edge on the border

  std::vector<std::uint8_t> is_cut;  ///< per triangle of the mesh; empty: no triangle is cut
  std::vector<Vec2> vertex;          ///< new vertices, numbered from the mesh's last vertex on
  std::vector<std::uint32_t> triangle_vertex;  ///< 3 per part
  std::vector<std::int32_t> edge;              ///< 3 per part: its half-edge, kInside or kBorder
  std::vector<std::uint32_t> parent;           ///< per part: the triangle that was cut
  /// kNodesPerTriangle per part: a place in the parent, or -1 - index in `point`.
  std::vector<std::int32_t> node;
  std::vector<Vec2> point;  ///< where new nodes are gathered: inside, on the seen side
  TableMemory memory{"patches at a border"};

  std::size_t part_count() const { return parent.size(); }
};

/// Cuts the triangles of a patch mesh along the border between the points that see a curve and the
/// points that see none. It consists of straight lines through ends of curves. Its crossing with an
/// edge is found by bisection; both triangles at the edge get the same vertex there.
///
/// accuracy  accuracy of these vertices, layer units
/// Errors    limit (memory), cancelled
/// Cost      O(triangles) to find a border; for each edge that it crosses one bisection step
///           per bit
Result<BorderCuts> cut_at_border(Context& context, const mesh::TriangleMesh& mesh,
                                 const Sight& sight, double accuracy);

}  // namespace sfumato::solve
