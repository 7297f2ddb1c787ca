#pragma once

#include <cstdint>
#include <vector>

#include "base/table_memory.hpp"
#include "mesh/triangulation.hpp"
#include "sfumato/base/context.hpp"

namespace sfumato::mesh {

/// The number under which each triangle and vertex is extracted; kNone: not extracted.
struct Numbering {
  std::vector<std::int32_t> triangle;  ///< per slot of the triangulation
  std::vector<std::int32_t> vertex;    ///< per vertex of the triangulation
  std::uint32_t triangle_count = 0;
  std::uint32_t vertex_count = 0;
  TableMemory memory{"the triangle mesh"};

  /// Becomes the same, in the memory that it has where that is large enough. Errors: limit
  /// (memory), cancelled.
  Status copy_from(const Context& context, const Numbering& other);
};

/// All triangles and vertices, in their own order. Errors: limit (memory), cancelled.
Status number_everything(const Context& context, const Triangulation& mesh, Numbering& numbering);

/// Numbers the triangles inside the frame and their vertices: the first call from neighbour to
/// neighbour, later calls append new ones in the triangulation's order; these are new slots, and
/// corners of the triangles in mesh.changed. Those that `numbering` has already keep their numbers,
/// since slots are never freed. Errors: limit (memory), cancelled; the numbering is unusable then.
Status number_inside(const Context& context, const Triangulation& mesh, Numbering& numbering);

}  // namespace sfumato::mesh
