#pragma once

#include <cstdint>
#include <vector>

#include "base/half_edge.hpp"
#include "base/table_memory.hpp"
#include "export/html/viewer_bytes.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato::outputs {

/// The triangles of a layer in the order of the viewer. If possible each is adjacent to an earlier
/// one, so that most of its data is already known. Half-edge 3t + k runs from corner k of triangle
/// t to the next.
struct ViewerMesh {
  std::vector<std::uint32_t> triangle;       ///< of the layer
  std::vector<std::uint8_t> first_corner;    ///< the layer's corner that is corner 0 here
  std::vector<std::uint32_t> corner_vertex;  ///< 3 per triangle, numbered as they appear
  std::vector<std::uint32_t> vertex;         ///< of the layer; unused vertices are left out
  std::vector<std::uint32_t> mate;  ///< per half-edge: the last earlier one there, or kNoHalfEdge
  std::vector<std::uint8_t> codes;  ///< varints: the vertices of the triangles
  std::vector<std::uint32_t> apex;  ///< per vertex: the half-edge it was reached across, or none
  TableMemory memory{"the viewer's triangles"};

  std::uint32_t triangle_count() const { return static_cast<std::uint32_t>(triangle.size()); }
};

/// Errors: limit (memory), cancelled. Cost: O(n log n).
Result<ViewerMesh> order_for_viewer(Context& context, const PatchLayer& layer);

struct GridPoint {
  std::int32_t x = 0, y = 0;
};

/// Where vertices are put: 22 bits on each axis.
struct ViewerGrid {
  Vec2 min;   ///< layer frame
  Vec2 step;  ///< above 0

  GridPoint nearest(Vec2 position) const;
  /// As the viewer has a point: relative to the middle of the grid, single precision.
  struct Place {
    float x = 0, y = 0;
  };
  Place place(GridPoint point) const;
  /// The same, relative to another point of the layer frame.
  Place place(GridPoint point, Vec2 origin) const;
  /// Returns the grid's middle, layer frame.
  Vec2 middle() const;
};

/// Returns the smallest that holds the vertices.
ViewerGrid grid_of(const PatchLayer& layer, const ViewerMesh& mesh);

/// Its corner and step.
void write_grid(const ViewerGrid& grid, ByteWriter& out);

/// A byte for each triangle: bit k where its edge k is a curve.
void write_curves(const PatchLayer& layer, const ViewerMesh& mesh, ByteWriter& out);

/// Positions on a grid over the layer's bounds, 22 bits on each axis, then topology and curve
/// edges. Errors: limit (memory), cancelled.
Status write_mesh(const Context& context, const PatchLayer& layer, const ViewerMesh& mesh,
                  ByteWriter& out);

}  // namespace sfumato::outputs
