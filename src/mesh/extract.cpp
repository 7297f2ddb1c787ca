#include "mesh/extract.hpp"

#include <numeric>
#include <utility>
#include <vector>

#include "base/large_vector.hpp"

namespace sfumato::mesh {
namespace {

/// Adds the constraint of edge e, which lies on a chord, with what the chord carries there.
void add_constraint(const Triangulation& mesh, const ChordStore& chords,
                    const std::vector<VertexOrigin>& origins, const Numbering& numbering,
                    HalfEdge e, TriangleMesh& out) {
  const std::int32_t index = mesh.chord[e];
  const Chord& chord = chords[index];
  Vertex from = mesh.origin(e), to = mesh.target(e);
  const Point a = mesh.point[chord.from], b = mesh.point[chord.to];
  if (dot_from(a, b, mesh.point[from]) > dot_from(a, b, mesh.point[to])) std::swap(from, to);
  const double at_from = fraction_at(chord, index, from, origins[from]);
  const double at_to = fraction_at(chord, index, to, origins[to]);
  const auto piece_begin = static_cast<std::uint32_t>(out.piece.size());
  const Owner* owner = chords.begin(chord);
  for (std::int32_t i = 0; i < chord.load.count; ++i) {
    const double u0 = owner[i].u_from, u1 = owner[i].u_to;
    out.piece.push_back({owner[i].segment, static_cast<float>(u0 * (1 - at_from) + u1 * at_from),
                         static_cast<float>(u0 * (1 - at_to) + u1 * at_to)});
  }
  out.constraint.push_back({static_cast<std::uint32_t>(numbering.vertex[from]),
                            static_cast<std::uint32_t>(numbering.vertex[to]), piece_begin,
                            static_cast<std::uint32_t>(out.piece.size())});
}

/// Numbers the triangles inside and their vertices from neighbour to neighbour: refinement left
/// them in an order that jumps about, and what follows reads them again and again.
void number_depth_first(const Context& context, const Triangulation& mesh, Numbering& numbering) {
  const auto wanted = [&](std::int32_t t) {
    return mesh.triangle[t].inside && numbering.triangle[t] == kNone;
  };
  std::vector<std::int32_t> stack;
  RarePoll<16384> poll(context);
  for (std::size_t seed = 0; seed < mesh.triangle.size(); ++seed) {
    stack.assign(1, static_cast<std::int32_t>(seed));
    while (!stack.empty()) {
      if (poll.cancelled()) return;
      const std::int32_t t = stack.back();
      stack.pop_back();
      if (!wanted(t)) continue;
      numbering.triangle[t] = static_cast<std::int32_t>(numbering.triangle_count++);
      for (int k = 0; k < 3; ++k) {
        std::int32_t& vertex = numbering.vertex[mesh.triangle[t].vertex[k]];
        if (vertex == kNone) vertex = static_cast<std::int32_t>(numbering.vertex_count++);
        const HalfEdge across = mesh.triangle[t].across[k] >> 1;
        if (across >= 0 && wanted(triangle_of(across))) stack.push_back(triangle_of(across));
      }
    }
  }
}

}  // namespace

Numbering number_everything(const Triangulation& mesh) {
  Numbering numbering;
  numbering.triangle.resize(mesh.triangle.size());
  numbering.vertex.resize(mesh.point.size());
  std::iota(numbering.triangle.begin(), numbering.triangle.end(), 0);
  std::iota(numbering.vertex.begin(), numbering.vertex.end(), 0);
  numbering.triangle_count = static_cast<std::uint32_t>(mesh.triangle.size());
  numbering.vertex_count = static_cast<std::uint32_t>(mesh.point.size());
  return numbering;
}

void number_inside(const Context& context, const Triangulation& mesh, Numbering& numbering) {
  const std::size_t known = numbering.triangle.size(), known_vertices = numbering.vertex.size();
  if (!resize_large(context, numbering.triangle, mesh.triangle.size(), std::int32_t{kNone}) ||
      !resize_large(context, numbering.vertex, mesh.point.size(), std::int32_t{kNone})) {
    return;
  }
  RarePoll<65536> poll(context);
  if (known == 0) return number_depth_first(context, mesh, numbering);
  // All later triangles and vertices come from refinement, which works inside and on the frame.
  for (std::size_t t = known; t < mesh.triangle.size() && !poll.cancelled(); ++t) {
    if (mesh.triangle[t].inside) {
      numbering.triangle[t] = static_cast<std::int32_t>(numbering.triangle_count++);
    }
  }
  for (std::size_t v = known_vertices; v < mesh.point.size(); ++v) {
    numbering.vertex[v] = static_cast<std::int32_t>(numbering.vertex_count++);
  }
}

namespace {

/// Corners and neighbours. Pointers, since stores to one vector could move another's data for all
/// that the compiler knows.
void copy_triangles(const Context& context, const Triangulation& mesh, const Numbering& numbering,
                    TriangleMesh& out) {
  const std::int32_t* const vertex_number = numbering.vertex.data();
  const std::int32_t* const triangle_number = numbering.triangle.data();
  std::uint32_t* const corner = out.triangle_vertex.data();
  std::int32_t* const twin = out.half_edge_twin.data();
  RarePoll<65536> poll(context);
  for (std::size_t slot = 0; slot < mesh.triangle.size() && !poll.cancelled(); ++slot) {
    if (triangle_number[slot] == kNone) continue;
    const std::int32_t first = 3 * triangle_number[slot];
    const Triangle t = mesh.triangle[slot];
    for (int k = 0; k < 3; ++k) {
      corner[first + k] = static_cast<std::uint32_t>(vertex_number[t.vertex[k]]);
      const HalfEdge f = t.across[k] >> 1;
      const std::int32_t other = f < 0 ? kNone : triangle_number[triangle_of(f)];
      twin[first + k] = other == kNone ? kNone : 3 * other + corner_of(f);
    }
  }
}

/// Calls visit(e, h) for every constrained edge, once: its half-edge e of the triangulation, which
/// is h in `out`.
template <class Visit>
void for_each_constraint(const Context& context, const Triangulation& mesh,
                         const Numbering& numbering, const TriangleMesh& out, Visit visit) {
  RarePoll<65536> poll(context);
  for (std::size_t slot = 0; slot < mesh.triangle.size() && !poll.cancelled(); ++slot) {
    const Triangle& t = mesh.triangle[slot];
    if (!((t.across[0] | t.across[1] | t.across[2]) & 1)) continue;
    if (numbering.triangle[slot] == kNone) continue;
    for (int k = 0; k < 3; ++k) {
      if (!(t.across[k] & 1) || t.across[k] == kHull) continue;
      const std::int32_t h = 3 * numbering.triangle[slot] + k;
      const std::int32_t twin = out.half_edge_twin[h];
      if (twin != kNone && twin < h) continue;
      visit(static_cast<HalfEdge>(4 * slot) + k, h);
    }
  }
}

}  // namespace

TriangleMesh extract(const Context& context, const Triangulation& mesh, const ChordStore& chords,
                     const std::vector<VertexOrigin>& origins, const Lattice& lattice,
                     const Numbering& numbering) {
  TriangleMesh out;
  out.lattice_step = lattice.step;
  out.vertex_position.resize(numbering.vertex_count);
  RarePoll<65536> poll(context);
  for (std::size_t v = 0; v < mesh.point.size() && !poll.cancelled(); ++v) {
    if (numbering.vertex[v] == kNone) continue;
    out.vertex_position[numbering.vertex[v]] = lattice.position(mesh.point[v]);
  }
  if (context.cancelled()) return {};
  const std::size_t half_edges = std::size_t{3} * numbering.triangle_count;
  if (!resize_large(context, out.triangle_vertex, half_edges) ||
      !resize_large(context, out.half_edge_twin, half_edges) ||
      !resize_large(context, out.half_edge_constraint, half_edges, std::int32_t{kNone})) {
    return {};
  }
  copy_triangles(context, mesh, numbering, out);
  if (context.cancelled()) return {};
  std::size_t constraints = 0, pieces = 0;
  for_each_constraint(context, mesh, numbering, out, [&](HalfEdge e, std::int32_t) {
    constraints += 1;
    pieces += static_cast<std::size_t>(chords[mesh.chord[e]].load.count);
  });
  out.constraint.reserve(constraints);
  out.piece.reserve(pieces);
  for_each_constraint(context, mesh, numbering, out, [&](HalfEdge e, std::int32_t h) {
    const auto constraint = static_cast<std::int32_t>(out.constraint.size());
    add_constraint(mesh, chords, origins, numbering, e, out);
    out.half_edge_constraint[h] = constraint;
    const std::int32_t twin = out.half_edge_twin[h];
    if (twin != kNone) out.half_edge_constraint[twin] = constraint;
  });
  return out;
}

}  // namespace sfumato::mesh
