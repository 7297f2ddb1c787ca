#include "mesh/extract.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "base/poll.hpp"
#include "base/try.hpp"

namespace sfumato::mesh {
namespace {

/// Describes the load of edge e, which is on a chord: constraint `index`, which has as many pieces.
void set_constraint(const ExtractSource& source, HalfEdge e, std::int32_t index,
                    TriangleMesh& out) {
  const Triangulation& mesh = source.mesh;
  const std::int32_t chord_index = mesh.chord[e];
  const Chord& chord = source.chords[chord_index];
  Vertex from = mesh.origin(e), to = mesh.target(e);
  const Point a = mesh.point[chord.from], b = mesh.point[chord.to];
  if (dot_from(a, b, mesh.point[from]) > dot_from(a, b, mesh.point[to])) std::swap(from, to);
  const double at_from = fraction_at(chord, chord_index, from, source.origins[from]);
  const double at_to = fraction_at(chord, chord_index, to, source.origins[to]);
  Constraint& constraint = out.constraint[index];
  constraint.from = static_cast<std::uint32_t>(source.numbering.vertex[from]);
  constraint.to = static_cast<std::uint32_t>(source.numbering.vertex[to]);
  SegmentPiece* const piece = out.piece.data() + constraint.piece_begin;
  const Owner* owner = source.chords.begin(chord);
  for (std::int32_t i = 0; i < chord.load.count; ++i) {
    const double u0 = owner[i].u_from, u1 = owner[i].u_to;
    piece[i] = {owner[i].segment, static_cast<float>(u0 * (1 - at_from) + u1 * at_from),
                static_cast<float>(u0 * (1 - at_to) + u1 * at_to)};
  }
}

std::uint32_t piece_count(const ExtractSource& source, HalfEdge e) {
  return static_cast<std::uint32_t>(source.chords[source.mesh.chord[e]].load.count);
}

/// Returns the index of a new constraint with the load of edge e.
std::int32_t add_constraint(const ExtractSource& source, HalfEdge e, TriangleMesh& out) {
  const auto index = static_cast<std::int32_t>(out.constraint.size());
  const auto begin = static_cast<std::uint32_t>(out.piece.size());
  const std::uint32_t end = begin + piece_count(source, e);
  out.piece.resize(end);
  out.constraint.push_back({0, 0, begin, end});
  set_constraint(source, e, index, out);
  return index;
}

/// Copies corners and neighbours of one slot, whose number is `number`.
void copy_triangle(const Triangle& t, std::int32_t number, const std::int32_t* vertex_number,
                   const std::int32_t* triangle_number, std::uint32_t* corner, std::int32_t* twin) {
  const std::int32_t first = 3 * number;
  for (int k = 0; k < 3; ++k) {
    corner[first + k] = static_cast<std::uint32_t>(vertex_number[t.vertex[k]]);
    const HalfEdge f = t.across[k] >> 1;
    const std::int32_t other = f < 0 ? kNone : triangle_number[triangle_of(f)];
    twin[first + k] = other == kNone ? kNone : 3 * other + corner_of(f);
  }
}

/// Copies corners and neighbours of all slots. It uses pointers: for the compiler, stores to one
/// vector could move another's data.
Status copy_triangles(const Context& context, const ExtractSource& from, TriangleMesh& out) {
  const std::int32_t* const vertex_number = from.numbering.vertex.data();
  const std::int32_t* const triangle_number = from.numbering.triangle.data();
  std::uint32_t* const corner = out.triangle_vertex.data();
  std::int32_t* const twin = out.half_edge_twin.data();
  RarePoll<65536> poll(context);
  for (std::size_t slot = 0; slot < from.mesh.triangle.size(); ++slot) {
    if (poll.cancelled()) return context.cancel_status();
    if (triangle_number[slot] == kNone) continue;
    const Triangle t = from.mesh.triangle[slot];
    copy_triangle(t, triangle_number[slot], vertex_number, triangle_number, corner, twin);
  }
  return context.check();
}

/// Returns whether a chord lies on any edge of the triangle; the hull counts as one.
bool has_wall(const Triangle& t) {
  return ((t.across[0] | t.across[1] | t.across[2]) & 1) != 0;
}

bool is_constrained(const Triangle& t, int k) {
  return (t.across[k] & 1) && t.across[k] != kHull;
}

/// Calls visit(e, h) once for every constrained edge: its half-edge e of the triangulation, which
/// is h in `out`.
template <class Visit>
Status for_each_constraint(const Context& context, const ExtractSource& from,
                           const TriangleMesh& out, Visit visit) {
  RarePoll<65536> poll(context);
  for (std::size_t slot = 0; slot < from.mesh.triangle.size(); ++slot) {
    if (poll.cancelled()) return context.cancel_status();
    const Triangle& t = from.mesh.triangle[slot];
    if (!has_wall(t) || from.numbering.triangle[slot] == kNone) continue;
    for (int k = 0; k < 3; ++k) {
      if (!is_constrained(t, k)) continue;
      const std::int32_t h = 3 * from.numbering.triangle[slot] + k;
      const std::int32_t twin = out.half_edge_twin[h];
      if (twin != kNone && twin < h) continue;
      visit(static_cast<HalfEdge>(4 * slot) + k, h);
    }
  }
  return ok_status();
}

void put_constraint(std::int32_t constraint, std::int32_t half_edge, TriangleMesh& out) {
  out.half_edge_constraint[half_edge] = constraint;
  const std::int32_t twin = out.half_edge_twin[half_edge];
  if (twin != kNone) out.half_edge_constraint[twin] = constraint;
}

Status place_vertices(const Context& context, const ExtractSource& from, TableMemory& memory,
                      TriangleMesh& out) {
  SFUMATO_TRY(memory.resize(context, out.vertex_position, from.numbering.vertex_count));
  RarePoll<65536> poll(context);
  for (std::size_t v = 0; v < from.mesh.point.size(); ++v) {
    if (poll.cancelled()) return context.cancel_status();
    if (from.numbering.vertex[v] == kNone) continue;
    out.vertex_position[from.numbering.vertex[v]] = from.lattice.position(from.mesh.point[v]);
  }
  return context.check();
}

Status place_triangles(const Context& context, const ExtractSource& from, TableMemory& memory,
                       TriangleMesh& out) {
  const std::size_t half_edges = std::size_t{3} * from.numbering.triangle_count;
  Status status = memory.resize_all(context, half_edges, out.triangle_vertex, out.half_edge_twin);
  if (status) status = memory.resize(context, out.half_edge_constraint, half_edges, kNone);
  return status ? copy_triangles(context, from, out) : status;
}

/// Places all constraints. Everything except the constraints is in place.
Status place_all_constraints(const Context& context, const ExtractSource& from, TableMemory& memory,
                             TriangleMesh& out) {
  std::size_t constraints = 0, pieces = 0;
  SFUMATO_TRY(for_each_constraint(context, from, out, [&](HalfEdge e, std::int32_t) {
    constraints += 1;
    pieces += piece_count(from, e);
  }));
  SFUMATO_TRY(memory.reserve(context, out.constraint, constraints));
  SFUMATO_TRY(memory.reserve(context, out.piece, pieces));
  return for_each_constraint(context, from, out, [&](HalfEdge e, std::int32_t h) {
    put_constraint(add_constraint(from, e, out), h, out);
  });
}

}  // namespace

Result<TriangleMesh> extract(const Context& context, const ExtractSource& from,
                             TableMemory& memory) {
  TriangleMesh out;
  out.lattice_step = from.lattice.step;
  SFUMATO_TRY(place_vertices(context, from, memory, out));
  SFUMATO_TRY(place_triangles(context, from, memory, out));
  SFUMATO_TRY(place_all_constraints(context, from, memory, out));
  SFUMATO_TRY(context.check());
  return out;
}

namespace {

/// Constraints whose edges are gone, by their number of pieces. Refinement only cuts edges on
/// chords, so that each of these finds a new edge in the same update. After an edit some may not,
/// and stay without an edge and without pieces.
class FreedConstraints {
 public:
  Status add(const Context& context, const TriangleMesh& mesh, std::int32_t index) {
    const Constraint& constraint = mesh.constraint[index];
    return memory_.push_back(context,
                             by_piece_count_[constraint.piece_end - constraint.piece_begin], index);
  }

  /// Empties the remaining constraints.
  void empty_rest(TriangleMesh& mesh) const {
    for (const auto& [count, indices] : by_piece_count_) {
      for (const std::int32_t index : indices) {
        Constraint& constraint = mesh.constraint[static_cast<std::size_t>(index)];
        constraint.piece_end = constraint.piece_begin;
      }
    }
  }

  /// Returns a constraint, or kNone where none is left.
  std::int32_t take(std::uint32_t pieces) {
    const auto place = by_piece_count_.find(pieces);
    if (place == by_piece_count_.end() || place->second.empty()) return kNone;
    const std::int32_t index = place->second.back();
    place->second.pop_back();
    return index;
  }

 private:
  std::map<std::uint32_t, std::vector<std::int32_t>> by_piece_count_;
  TableMemory memory_{"curve pieces"};
};

/// Updates a TriangleMesh: see update_extract.
class MeshUpdate {
 public:
  MeshUpdate(const Context& context, const ExtractSource& from,
             std::span<const std::int32_t> changed, TableMemory& memory, TriangleMesh& out)
      : context_(context),
        poll_(context),
        from_(from),
        changed_(changed),
        memory_(memory),
        out_(out) {}

  Status run() {
    SFUMATO_TRY(free_constraints());
    SFUMATO_TRY(grow_tables());
    SFUMATO_TRY(copy_changed());
    SFUMATO_TRY(place_constraints());
    freed_.empty_rest(out_);
    return context_.check();
  }

 private:
  /// Returns the first of the three half-edges of a slot in `out`.
  std::int32_t first_half_edge(std::int32_t slot) const {
    return 3 * from_.numbering.triangle[slot];
  }

  /// Removes constraints from the triangles that changed. A constraint is free once neither of its
  /// half-edges has it; a neighbour that did not change keeps it.
  Status free_constraints() {
    const auto half_edges = static_cast<std::int32_t>(out_.triangle_vertex.size());
    for (const std::int32_t slot : changed_) {
      if (poll_.cancelled()) return context_.cancel_status();
      const std::int32_t first = first_half_edge(slot);
      if (first >= half_edges) continue;
      for (std::int32_t h = first; h < first + 3; ++h) {
        const std::int32_t constraint = std::exchange(out_.half_edge_constraint[h], kNone);
        if (constraint == kNone) continue;
        const std::int32_t twin = out_.half_edge_twin[h];
        if (twin != kNone && out_.half_edge_constraint[twin] != kNone) continue;
        SFUMATO_TRY(freed_.add(context_, out_, constraint));
      }
    }
    return ok_status();
  }

  Status grow_tables() {
    const Triangulation& mesh = from_.mesh;
    const std::size_t vertices = out_.vertex_position.size();
    const std::size_t half_edges = std::size_t{3} * from_.numbering.triangle_count;
    const std::size_t most = 3 * mesh.triangle.capacity();
    SFUMATO_TRY(memory_.grow(context_, out_.vertex_position, from_.numbering.vertex_count,
                             mesh.point.capacity()));
    SFUMATO_TRY(memory_.grow(context_, out_.triangle_vertex, half_edges, most));
    for (std::vector<std::int32_t>* table : {&out_.half_edge_twin, &out_.half_edge_constraint})
      SFUMATO_TRY(memory_.grow(context_, *table, half_edges, most, kNone));
    // The newest vertices are the last, and have the highest numbers.
    std::size_t more = out_.vertex_position.size() - vertices;
    for (std::size_t v = mesh.point.size(); more > 0; --v) {
      if (poll_.cancelled()) return context_.cancel_status();
      const std::int32_t number = from_.numbering.vertex[v - 1];
      if (number == kNone) continue;
      out_.vertex_position[number] = from_.lattice.position(mesh.point[v - 1]);
      --more;
    }
    return ok_status();
  }

  Status copy_changed() {
    std::int32_t* const twin = out_.half_edge_twin.data();
    for (const std::int32_t slot : changed_) {
      if (poll_.cancelled()) return context_.cancel_status();
      copy_triangle(from_.mesh.triangle[slot], from_.numbering.triangle[slot],
                    from_.numbering.vertex.data(), from_.numbering.triangle.data(),
                    out_.triangle_vertex.data(), twin);
      const std::int32_t first = first_half_edge(slot);
      for (std::int32_t h = first; h < first + 3; ++h)
        if (twin[h] != kNone) twin[twin[h]] = h;
    }
    return ok_status();
  }

  Status place_constraints() {
    for (const std::int32_t slot : changed_) {
      if (poll_.cancelled()) return context_.cancel_status();
      const Triangle& t = from_.mesh.triangle[slot];
      if (!has_wall(t)) continue;
      for (int k = 0; k < 3; ++k) {
        const std::int32_t h = first_half_edge(slot) + k;
        if (!is_constrained(t, k) || out_.half_edge_constraint[h] != kNone) continue;
        const std::int32_t twin = out_.half_edge_twin[h];
        std::int32_t constraint = twin == kNone ? kNone : out_.half_edge_constraint[twin];
        if (constraint == kNone) {
          SFUMATO_TRY(make_room(4 * slot + k));
          constraint = place_constraint(4 * slot + k);
        }
        put_constraint(constraint, h, out_);
      }
    }
    return ok_status();
  }

  /// Makes room for one more constraint, with the load of edge e.
  Status make_room(HalfEdge e) {
    Status status = memory_.make_room(context_, out_.constraint);
    return status ? memory_.make_room(context_, out_.piece, piece_count(from_, e)) : status;
  }

  std::int32_t place_constraint(HalfEdge e) {
    const std::int32_t freed = freed_.take(piece_count(from_, e));
    if (freed == kNone) return add_constraint(from_, e, out_);
    set_constraint(from_, e, freed, out_);
    return freed;
  }

  const Context& context_;
  RarePoll<16384> poll_;
  const ExtractSource& from_;
  std::span<const std::int32_t> changed_;
  TableMemory& memory_;
  TriangleMesh& out_;
  FreedConstraints freed_;
};

}  // namespace

Status update_extract(const Context& context, const ExtractSource& from,
                      std::span<const std::int32_t> changed, TableMemory& memory,
                      TriangleMesh& out) {
  return MeshUpdate(context, from, changed, memory, out).run();
}

void take_back(const TriangleMesh& before, std::span<const std::uint32_t> changed,
               TriangleMesh& mesh) {
  mesh.vertex_position.resize(before.vertex_position.size());
  mesh.triangle_vertex.resize(before.triangle_vertex.size());
  mesh.half_edge_twin.resize(before.half_edge_twin.size());
  mesh.half_edge_constraint.resize(before.half_edge_constraint.size());
  mesh.constraint.resize(before.constraint.size());
  mesh.piece.resize(before.piece.size());
  const auto take_back_constraint = [&](std::size_t h) {
    const std::int32_t c = before.half_edge_constraint[h];
    mesh.half_edge_constraint[h] = c;
    if (c == kNone) return;
    const Constraint& constraint = before.constraint[static_cast<std::size_t>(c)];
    mesh.constraint[static_cast<std::size_t>(c)] = constraint;
    std::ranges::copy(before.pieces(constraint), mesh.piece.data() + constraint.piece_begin);
  };
  for (const std::uint32_t t : changed) {
    if (t >= before.triangle_count()) continue;
    for (std::size_t h = 3 * std::size_t{t}; h < 3 * std::size_t{t} + 3; ++h) {
      mesh.triangle_vertex[h] = before.triangle_vertex[h];
      mesh.half_edge_twin[h] = before.half_edge_twin[h];
      take_back_constraint(h);
      if (before.half_edge_twin[h] == kNone) continue;
      const auto twin = static_cast<std::size_t>(before.half_edge_twin[h]);
      mesh.half_edge_twin[twin] = static_cast<std::int32_t>(h);
      mesh.half_edge_constraint[twin] = before.half_edge_constraint[twin];
    }
  }
}

}  // namespace sfumato::mesh
