#include "mesh/numbering.hpp"

#include <numeric>

#include "base/poll.hpp"
#include "base/try.hpp"

namespace sfumato::mesh {
namespace {

/// A vertex that will be numbered next.
constexpr std::int32_t kAwaited = -2;

/// Numbers the triangles inside and their vertices from neighbour to neighbour. Refinement leaves
/// them in an order that jumps about, and later steps read them many times.
Status number_depth_first(const Context& context, const Triangulation& mesh, Numbering& numbering) {
  const auto wanted = [&](std::int32_t t) {
    return mesh.triangle[t].inside && numbering.triangle[t] == kNone;
  };
  TableMemory memory("the triangle mesh");
  std::vector<std::int32_t> stack;
  RarePoll<16384> poll(context);
  for (std::size_t seed = 0; seed < mesh.triangle.size(); ++seed) {
    SFUMATO_TRY(memory.push_back(context, stack, static_cast<std::int32_t>(seed)));
    while (!stack.empty()) {
      if (poll.cancelled()) return context.cancel_status();
      const std::int32_t t = stack.back();
      stack.pop_back();
      if (!wanted(t)) continue;
      SFUMATO_TRY(memory.make_room(context, stack, 3));
      numbering.triangle[t] = static_cast<std::int32_t>(numbering.triangle_count++);
      for (int k = 0; k < 3; ++k) {
        std::int32_t& vertex = numbering.vertex[mesh.triangle[t].vertex[k]];
        if (vertex == kNone) vertex = static_cast<std::int32_t>(numbering.vertex_count++);
        const HalfEdge across = mesh.triangle[t].across[k] >> 1;
        if (across >= 0 && wanted(triangle_of(across))) stack.push_back(triangle_of(across));
      }
    }
  }
  return context.check();
}

}  // namespace

Status Numbering::copy_from(const Context& context, const Numbering& other) {
  triangle_count = other.triangle_count;
  vertex_count = other.vertex_count;
  Status status = memory.assign(context, other.triangle, triangle);
  return status ? memory.assign(context, other.vertex, vertex) : status;
}

Status number_everything(const Context& context, const Triangulation& mesh, Numbering& numbering) {
  SFUMATO_TRY(numbering.memory.resize(context, numbering.triangle, mesh.triangle.size()));
  SFUMATO_TRY(numbering.memory.resize(context, numbering.vertex, mesh.point.size()));
  std::iota(numbering.triangle.begin(), numbering.triangle.end(), 0);
  std::iota(numbering.vertex.begin(), numbering.vertex.end(), 0);
  numbering.triangle_count = static_cast<std::uint32_t>(mesh.triangle.size());
  numbering.vertex_count = static_cast<std::uint32_t>(mesh.point.size());
  return ok_status();
}

Status number_inside(const Context& context, const Triangulation& mesh, Numbering& numbering) {
  const std::size_t known = numbering.triangle.size(), known_vertices = numbering.vertex.size();
  TableMemory& memory = numbering.memory;
  SFUMATO_TRY(memory.grow(context, numbering.triangle, mesh.triangle.size(),
                          mesh.triangle.capacity(), kNone));
  SFUMATO_TRY(
      memory.grow(context, numbering.vertex, mesh.point.size(), mesh.point.capacity(), kNone));
  if (known == 0) return number_depth_first(context, mesh, numbering);
  RarePoll<65536> poll(context);
  for (const std::int32_t t : mesh.changed) {
    if (poll.cancelled()) return context.cancel_status();
    for (const Vertex v : mesh.triangle[t].vertex) {
      if (numbering.vertex[v] == kNone) numbering.vertex[v] = kAwaited;
    }
  }
  for (std::size_t t = known; t < mesh.triangle.size(); ++t) {
    if (poll.cancelled()) return context.cancel_status();
    if (mesh.triangle[t].inside) {
      numbering.triangle[t] = static_cast<std::int32_t>(numbering.triangle_count++);
    }
  }
  for (std::size_t v = known_vertices; v < mesh.point.size(); ++v) {
    if (numbering.vertex[v] == kNone) continue;
    numbering.vertex[v] = static_cast<std::int32_t>(numbering.vertex_count++);
  }
  return context.check();
}

}  // namespace sfumato::mesh
