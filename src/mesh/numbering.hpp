#pragma once

#include <cstdint>
#include <vector>

#include "base/table_memory.hpp"
#include "mesh/triangulation.hpp"
#include "sfumato/base/context.hpp"

namespace sfumato::mesh {

/// Which triangles and vertices leave, and under which numbers: kNone stays.
struct Numbering {
  std::vector<std::int32_t> triangle;  ///< per slot of the triangulation
  std::vector<std::int32_t> vertex;    ///< per vertex of the triangulation
  std::uint32_t triangle_count = 0;
  std::uint32_t vertex_count = 0;
  TableMemory memory{"the triangle mesh"};
};

/// All triangles and vertices, in their own order. Errors: limit (memory), cancelled.
Status number_everything(const Context& context, const Triangulation& mesh, Numbering& numbering);

/// Triangles inside the frame and their vertices: at first from neighbour to neighbour, later ones
/// in their own order. Vertices that `numbering` has already keep their numbers; more are appended.
/// Triangles do too, since slots are never freed. Errors: limit (memory), cancelled; the numbering
/// is good for nothing then.
Status number_inside(const Context& context, const Triangulation& mesh, Numbering& numbering);

}  // namespace sfumato::mesh
