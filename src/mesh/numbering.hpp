#pragma once

#include <cstdint>
#include <vector>

#include "base/table_memory.hpp"
#include "mesh/triangulation.hpp"
#include "sfumato/base/context.hpp"

namespace sfumato::mesh {

/// The number of each triangle and vertex in the extracted mesh; kNone: not extracted.
struct Numbering {
  std::vector<std::int32_t> triangle;  ///< per slot of the triangulation
  std::vector<std::int32_t> vertex;    ///< per vertex of the triangulation
  std::uint32_t triangle_count = 0;
  std::uint32_t vertex_count = 0;
  TableMemory memory{"the triangle mesh"};

  /// Copies a numbering, in the existing memory where that is large enough. Errors: limit (memory),
  /// cancelled.
  Status copy_from(const Context& context, const Numbering& other);
};

/// Numbers all triangles and vertices, in their own order. Errors: limit (memory), cancelled.
Status number_everything(const Context& context, const Triangulation& mesh, Numbering& numbering);

/// Numbers the triangles inside the frame and their vertices. The first call goes from neighbour to
/// neighbour; later calls append new ones in the triangulation's order: new slots, and corners of
/// the triangles in mesh.changed. Existing numbers stay, since slots are never freed. Errors: limit
/// (memory), cancelled; the numbering is then unusable.
Status number_inside(const Context& context, const Triangulation& mesh, Numbering& numbering);

}  // namespace sfumato::mesh
