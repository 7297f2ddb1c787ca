#include <algorithm>
#include <memory>
#include <span>

#include "base/try.hpp"
#include "mesh/arrangement.hpp"
#include "mesh/edit.hpp"
#include "mesh/inside.hpp"
#include "mesh/mesher_state.hpp"

namespace sfumato::mesh {
namespace {

bool is_within(const Lattice& lattice, Vec2 p) {
  const double x = p.x * lattice.inverse_step - lattice.origin.x;
  const double y = p.y * lattice.inverse_step - lattice.origin.y;
  return x >= 1 && y >= 1 && x <= lattice.width - 1.0 && y <= lattice.height - 1.0;
}

/// Appends the lattice points of the polylines that follow the current list.
Status append_drawn(const Context& context, const curves::FlatCurves& flat, const Lattice& lattice,
                    TableMemory& memory, std::vector<Point>& drawn) {
  const std::size_t first = drawn.size();
  SFUMATO_TRY(memory.make_room(context, drawn, flat.vertex.size() - first));
  for (std::size_t v = first; v < flat.vertex.size(); ++v) {
    drawn.push_back(is_within(lattice, flat.vertex[v]) ? lattice.nearest(flat.vertex[v]) : Point{});
  }
  return context.check();
}

Status insert(Arrangement& arrangement, const curves::FlatCurves& flat,
              std::span<const Point> drawn, std::uint32_t first) {
  arrangement.set_segments(drawn);
  TableMemory memory("mesh input");
  std::vector<Vertex> vertex_of;
  SFUMATO_TRY(memory.resize(arrangement.context(), vertex_of, flat.vertex.size() - first));
  // Inserts all vertices before the first segment.
  for (std::size_t i = 0; i < vertex_of.size(); ++i) {
    vertex_of[i] = arrangement.insert_point(drawn[first + i]);
  }
  for (std::uint32_t i = 0; i < vertex_of.size(); ++i) {
    if (!flat.begins_segment(first + i)) continue;
    arrangement.insert_segment(vertex_of[i], vertex_of[i + 1], first + i);
  }
  return arrangement.status();
}

}  // namespace

Result<Mesher> Mesher::copy(const Context& context) const {
  Mesher copy(std::make_unique<State>(context.budget));
  SFUMATO_TRY(copy.copy_from(context, *this));
  return copy;
}

Status Mesher::copy_from(const Context& context, const Mesher& other) {
  const State& from = *other.state_;
  State& s = *state_;
  s.options = from.options;
  s.lattice = from.lattice;
  s.has_cut_chords = from.has_cut_chords;
  s.set_quality();
  Status status;
  if (s.copied_from == &from && s.change_count_of_copy == from.change_count &&
      s.mesh.knows_changes()) {
    s.mesh.take_back(from.mesh);
  } else {
    status = s.mesh.copy_from(context, from.mesh);
  }
  s.copied_from = &from;
  s.change_count_of_copy = from.change_count;
  if (status) status = s.chords.copy_from(context, from.chords);
  if (status) status = s.refiner.copy_origins(context, from.refiner);
  if (status) status = s.drawn_memory.assign(context, from.drawn, s.drawn);
  // A patch mesh that did not follow the last changes must be extracted again.
  if (!from.mesh.changed.empty()) {
    s.forget_numbers();
    return status;
  }
  if (status) status = s.numbering.copy_from(context, from.numbering);
  return status ? s.memory.assign(context, from.patched, s.patched) : status;
}

Result<std::vector<std::int32_t>> Mesher::kept_triangles(const Context& context,
                                                         const Mesher& before,
                                                         TableMemory& memory) const {
  const std::vector<Refiner::Target>& patched = before.state_->patched;
  std::vector<std::int32_t> kept;
  SFUMATO_TRY(memory.resize(context, kept, patched.size(), kNone));
  const State& s = *state_;
  for (std::size_t t = 0; t < kept.size(); ++t) {
    if (static_cast<std::size_t>(patched[t].triangle) >= s.mesh.triangle.size()) continue;
    const Triangle& now = s.mesh.triangle[patched[t].triangle];
    if (now.stamp == patched[t].stamp) kept[t] = s.numbering.triangle[patched[t].triangle];
  }
  return kept;
}

Result<std::vector<std::uint8_t>> Mesher::same_triangles(const Context& context,
                                                         const Mesher& before,
                                                         TableMemory& memory) const {
  const std::vector<Triangle>& then = before.state_->mesh.triangle;
  std::vector<std::uint8_t> is_same;
  SFUMATO_TRY(memory.resize(context, is_same, then.size()));
  for (std::size_t t = 0; t < then.size(); ++t) {
    is_same[t] = state_->mesh.triangle[t].stamp == then[t].stamp;
  }
  return is_same;
}

Result<TriangleMesh> Mesher::copy_mesh(const Context& context, const TriangleMesh& mesh) {
  State& s = *state_;
  s.extracted = TableMemory(State::kPurpose, s.budget);
  TriangleMesh out;
  out.lattice_step = mesh.lattice_step;
  Status status;
  const auto copy = [&](const auto& from, auto& to, std::size_t more) {
    if (status) status = s.extracted.reserve(context, to, from.size() + more);
    if (status) status = s.extracted.append(context, from, to);
  };
  // The numbers of vertices and triangles that edits have added so far.
  const bool is_numbered = follows_changes();
  const std::size_t vertices =
      s.mesh.point.size() - (is_numbered ? s.numbering.vertex.size() : mesh.vertex_position.size());
  const std::size_t half_edges =
      3 * (s.mesh.triangle.size() -
           (is_numbered ? s.numbering.triangle.size() : std::size_t{mesh.triangle_count()}));
  copy(mesh.vertex_position, out.vertex_position, vertices);
  copy(mesh.triangle_vertex, out.triangle_vertex, half_edges);
  copy(mesh.half_edge_twin, out.half_edge_twin, half_edges);
  copy(mesh.half_edge_constraint, out.half_edge_constraint, half_edges);
  copy(mesh.constraint, out.constraint, half_edges);
  copy(mesh.piece, out.piece, half_edges);
  if (!status) return status;
  return out;
}

Status Mesher::update_visibility_mesh(const Context& context, std::span<const std::uint8_t> is_same,
                                      TriangleMesh& mesh, TableMemory& memory,
                                      std::vector<std::uint32_t>& changed) {
  State& s = *state_;
  Numbering everything{{}, {}, 0, 0, {State::kPurpose, s.budget}};
  TableMemory scratch(State::kPurpose);
  std::vector<std::int32_t> slots;
  SFUMATO_TRY(number_everything(context, s.mesh, everything));
  SFUMATO_TRY(scratch.reserve(context, slots, s.mesh.triangle.size()));
  for (std::size_t t = 0; t < s.mesh.triangle.size(); ++t) {
    if (t >= is_same.size() || !is_same[t]) slots.push_back(static_cast<std::int32_t>(t));
  }
  changed.clear();
  SFUMATO_TRY(memory.reserve(context, changed, slots.size()));
  changed.assign(slots.begin(), slots.end());
  const ExtractSource source{s.mesh, s.chords, s.refiner.origins(), s.lattice, everything};
  return update_extract(context, source, slots, s.extracted, mesh);
}

bool Mesher::follows_changes() const {
  return state_->numbering.triangle_count > 0;
}

Status Mesher::bake(const Context& context) {
  State& s = *state_;
  if (!s.has_cut_chords) return ok_status();
  s.has_cut_chords = false;
  ++s.change_count;
  s.mesh.forget_changes();
  Status status = bake_chords(context, s.budget, s.mesh, s.chords, s.refiner.origins());
  return status ? s.chords.seal(context) : status;
}

bool Mesher::holds(const curves::FlatCurves& flat, std::uint32_t first) const {
  return std::all_of(flat.vertex.begin() + first, flat.vertex.end(),
                     [&](Vec2 p) { return is_within(state_->lattice, p); });
}

Status Mesher::edit(const Context& context, const curves::FlatCurves& flat, const MeshEdit& edit,
                    bool refines) {
  State& s = *state_;
  if (!holds(flat, edit.first_inserted)) {
    return make_error(StatusCode::bad_input, "a curve lies outside of the lattice of its mesh");
  }
  ++s.change_count;
  Status status = append_drawn(context, flat, s.lattice, s.drawn_memory, s.drawn);
  if (status) status = bake(context);
  s.mesh.tracking = true;
  if (status && !edit.is_removed.empty()) {
    status = take_segments_off(context, edit.is_removed, s.mesh, s.chords);
  }
  Arrangement arrangement(context, s.mesh, s.chords, s.lattice.weld_squared);
  if (status) status = insert(arrangement, flat, s.drawn, edit.first_inserted);
  s.mesh.tracking = false;
  if (status) status = s.chords.seal(context);
  const bool moves_frame = arrangement.moved_frame();
  if (status && moves_frame) status = flood_inside(context, s.mesh, s.chords);
  if (status) status = s.refiner.start(context);
  if (moves_frame) {
    s.mesh.forget_changes();
    s.forget_numbers();  // vertices outside may have become inside
  }
  if (!status || !refines) {
    s.mesh.take_touched([](std::int32_t) {});
    return status;
  }
  if (moves_frame) return refine(context);  // triangles that became inside were not tracked
  const std::size_t vertices = s.mesh.point.size();
  status = s.refiner.refine_touched(context);
  s.has_cut_chords = s.mesh.point.size() > vertices;
  return status;
}

}  // namespace sfumato::mesh
