#pragma once

#include <cstdint>
#include <vector>

#include "mesh/triangulation.hpp"
#include "sfumato/base/context.hpp"

namespace sfumato::mesh {

/// Which triangles and vertices leave, and under which numbers: kNone stays.
struct Numbering {
  std::vector<std::int32_t> triangle;  ///< per slot of the triangulation
  std::vector<std::int32_t> vertex;    ///< per vertex of the triangulation
  std::uint32_t triangle_count = 0;
  std::uint32_t vertex_count = 0;
};

/// All triangles and vertices, in their own order.
Numbering number_everything(const Triangulation& mesh);

/// Triangles inside the frame and their vertices: at first from neighbour to neighbour, later ones
/// in their own order. Vertices that `numbering` has already keep their numbers; more are appended.
/// Triangles do too, since slots are never freed. Error: cancelled; the numbering is good for
/// nothing then.
Status number_inside(const Context& context, const Triangulation& mesh, Numbering& numbering);

}  // namespace sfumato::mesh
