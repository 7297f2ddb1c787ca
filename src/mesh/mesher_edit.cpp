#include <algorithm>
#include <memory>
#include <span>

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

/// The lattice points of the polylines from where the list of them ends.
Status append_drawn(const Context& context, const curves::FlatCurves& flat, const Lattice& lattice,
                    TableMemory& memory, std::vector<Point>& drawn) {
  const std::size_t first = drawn.size();
  Status status = memory.make_room(context, drawn, flat.vertex.size() - first);
  if (!status) return status;
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
  Status status = memory.resize(arrangement.context(), vertex_of, flat.vertex.size() - first);
  if (!status) return status;
  // All vertices before the first segment.
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
  const State& s = *state_;
  auto copy = std::make_unique<State>(context.budget);
  copy->options = s.options;
  copy->lattice = s.lattice;
  copy->has_cut_chords = s.has_cut_chords;
  copy->set_quality();
  Status status = copy->mesh.copy_from(context, s.mesh);
  if (status) status = copy->chords.copy_from(context, s.chords);
  if (status) status = copy->refiner.copy_origins(context, s.refiner);
  if (status) status = copy->drawn_memory.append(context, s.drawn, copy->drawn);
  if (!status) return status;
  return Mesher(std::move(copy));
}

Result<std::vector<std::int32_t>> Mesher::kept_triangles(const Context& context,
                                                         const Mesher& before,
                                                         TableMemory& memory) const {
  const std::vector<Refiner::Target>& patched = before.state_->patched;
  std::vector<std::int32_t> kept;
  Status status = memory.resize(context, kept, patched.size(), kNone);
  if (!status) return status;
  const State& s = *state_;
  for (std::size_t t = 0; t < kept.size(); ++t) {
    const Triangle& now = s.mesh.triangle[patched[t].triangle];
    if (now.stamp == patched[t].stamp) kept[t] = s.numbering.triangle[patched[t].triangle];
  }
  return kept;
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
  Status status = append_drawn(context, flat, s.lattice, s.drawn_memory, s.drawn);
  if (status && s.has_cut_chords) {
    status = bake_chords(context, s.budget, s.mesh, s.chords, s.refiner.origins());
    s.has_cut_chords = false;
  }
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
  // Vertices outside may have come in, and constraints have gone: tables are extracted anew.
  s.numbering = Numbering{{}, {}, 0, 0, {State::kPurpose, s.budget}};
  if (!status || !refines) {
    s.mesh.take_touched([](std::int32_t) {});
    return status;
  }
  if (moves_frame) return refine(context);  // what came in was not tracked
  s.has_cut_chords = true;
  return s.refiner.refine_touched(context);
}

}  // namespace sfumato::mesh
