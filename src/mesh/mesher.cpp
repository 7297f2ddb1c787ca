#include "mesh/mesher.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>

#include "base/limit_error.hpp"
#include "base/poll.hpp"
#include "base/try.hpp"
#include "mesh/arrangement.hpp"
#include "mesh/insertion_order.hpp"
#include "mesh/inside.hpp"
#include "mesh/mesher_state.hpp"

namespace sfumato::mesh {

namespace {

Status check_sizes(const Limits& limits, const curves::FlatCurves& flat) {
  if (flat.curve_begin.empty() || flat.segment_count() <= limits.segments) return ok_status();
  return limit_error(limits, &Limits::segments, "segments in one layer");
}

/// Inserts all curve vertices. Returns per curve vertex its vertex of the mesh.
Result<std::vector<Vertex>> insert_points(Arrangement& arrangement, std::span<const Point> points,
                                          const Lattice& lattice, TableMemory& memory) {
  const std::int32_t extent = std::max(lattice.width, lattice.height);
  SFUMATO_TRY_ASSIGN(const std::vector<std::uint32_t>& order,
                     insertion_order(arrangement.context(), points, extent, memory));
  std::vector<Vertex> vertex_of;
  SFUMATO_TRY(memory.resize(arrangement.context(), vertex_of, points.size()));
  for (const std::uint32_t i : order) vertex_of[i] = arrangement.insert_point(points[i]);
  if (!arrangement.status()) return arrangement.status();
  return vertex_of;
}

Status arrange(Arrangement& arrangement, const curves::FlatCurves& flat, const Lattice& lattice) {
  const Point low = lattice.frame_min, high = lattice.frame_max;
  const Vertex corner[4] = {
      arrangement.insert_point(low), arrangement.insert_point({high.x, low.y}),
      arrangement.insert_point(high), arrangement.insert_point({low.x, high.y})};
  TableMemory memory("mesh input");
  std::vector<Point> points;
  SFUMATO_TRY(memory.resize(arrangement.context(), points, flat.vertex.size()));
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = lattice.nearest(flat.vertex[i]);
  SFUMATO_TRY_ASSIGN(const std::vector<Vertex>& inserted,
                     insert_points(arrangement, points, lattice, memory));
  const std::vector<Vertex>& vertex_of = inserted;
  for (int k = 0; k < 4; ++k) arrangement.insert_frame_side(corner[k], corner[(k + 1) % 4]);
  arrangement.set_segments(points);
  for (std::uint32_t s = 0; s < flat.vertex.size(); ++s) {
    if (flat.begins_segment(s)) arrangement.insert_segment(vertex_of[s], vertex_of[s + 1], s);
  }
  return arrangement.status();
}

/// Constraints that are meshed again: constraint[i] runs from point 2 i to point 2 i + 1.
struct KeptConstraints {
  std::vector<std::uint32_t> constraint;
  std::vector<Point> point;
};

Result<KeptConstraints> kept_constraints(const Context& context, const TriangleMesh& mesh,
                                         std::span<const std::uint8_t> keep, const Lattice& lattice,
                                         TableMemory& memory) {
  const auto count = static_cast<std::size_t>(std::ranges::count(keep, 1));
  KeptConstraints kept;
  SFUMATO_TRY(memory.reserve(context, kept.constraint, count));
  SFUMATO_TRY(memory.reserve(context, kept.point, 2 * count));
  for (std::uint32_t c = 0; c < mesh.constraint.size(); ++c) {
    if (!keep[c]) continue;
    kept.constraint.push_back(c);
    kept.point.push_back(lattice.nearest(mesh.vertex_position[mesh.constraint[c].from]));
    kept.point.push_back(lattice.nearest(mesh.vertex_position[mesh.constraint[c].to]));
  }
  return kept;
}

/// Replaces each stand-in by the pieces of its constraint.
Status restore_pieces(const Context& context, const TriangleMesh& original,
                      std::span<const std::uint32_t> constraint, TableMemory& memory,
                      TriangleMesh& mesh) {
  std::vector<SegmentPiece> stand_in = std::exchange(mesh.piece, {});
  const auto original_of = [&](const Constraint& c) -> const Constraint& {
    return original.constraint[constraint[stand_in[c.piece_begin].segment / 2]];
  };
  std::size_t count = 0;
  for (const Constraint& c : mesh.constraint) {
    count += original_of(c).piece_end - original_of(c).piece_begin;
  }
  SFUMATO_TRY(memory.reserve(context, mesh.piece, count));
  for (Constraint& c : mesh.constraint) {
    const SegmentPiece& whole = stand_in[c.piece_begin];
    const Constraint& before = original_of(c);
    const bool reversed = whole.u_from > whole.u_to;
    c.piece_begin = static_cast<std::uint32_t>(mesh.piece.size());
    for (SegmentPiece piece : original.pieces(before)) {
      if (reversed) std::swap(piece.u_from, piece.u_to);
      mesh.piece.push_back(piece);
    }
    c.piece_end = static_cast<std::uint32_t>(mesh.piece.size());
  }
  memory.free(stand_in);
  return ok_status();
}

}  // namespace

Mesher::Mesher(std::unique_ptr<State> state) : state_(std::move(state)) {}
Mesher::Mesher(Mesher&&) noexcept = default;
Mesher& Mesher::operator=(Mesher&&) noexcept = default;
Mesher::~Mesher() = default;

Result<Mesher> Mesher::build(Context& context, const curves::FlatCurves& flat,
                             const MeshOptions& options) {
  SFUMATO_TRY(check_sizes(context.limits, flat));
  SFUMATO_TRY_ASSIGN(auto&& lattice, choose_lattice(flat, options));
  auto state = std::make_unique<State>(context.budget);
  state->options = options;
  state->lattice = lattice;
  SFUMATO_TRY(state->mesh.grow(context, flat.vertex.size() * 5 / 4 + 64));
  state->mesh.start(lattice.width, lattice.height);
  Arrangement arrangement(context, state->mesh, state->chords, lattice.weld_squared);
  SFUMATO_TRY(arrange(arrangement, flat, lattice));
  SFUMATO_TRY(state->chords.seal(context));
  SFUMATO_TRY(flood_inside(context, state->mesh, state->chords));
  SFUMATO_TRY(state->refiner.start(context));
  state->set_quality();
  return Mesher(std::move(state));
}

Result<TriangleMesh> Mesher::visibility_mesh(const Context& context) {
  Numbering numbering{{}, {}, 0, 0, {State::kPurpose, state_->budget}};
  SFUMATO_TRY(number_everything(context, state_->mesh, numbering));
  return state_->extract_anew(context, numbering);
}

Result<TriangleMesh> Mesher::thinned_mesh(const Context& context, const TriangleMesh& visibility,
                                          std::span<const std::uint8_t> keep,
                                          TableMemory& memory) const {
  const Lattice& lattice = state_->lattice;
  TableMemory scratch("mesh input");
  SFUMATO_TRY_ASSIGN(const KeptConstraints& found,
                     kept_constraints(context, visibility, keep, lattice, scratch));
  const KeptConstraints& kept = found;
  Triangulation mesh;
  ChordStore chords;
  SFUMATO_TRY(mesh.grow(context, kept.point.size() * 5 / 4 + 64));
  mesh.start(lattice.width, lattice.height);
  // The constraints cross nowhere and pass no vertex: there is nothing to weld.
  Arrangement arrangement(context, mesh, chords, 0);
  SFUMATO_TRY_ASSIGN(const std::vector<Vertex>& inserted,
                     insert_points(arrangement, kept.point, lattice, scratch));
  const std::vector<Vertex>& vertex_of = inserted;
  arrangement.set_segments(kept.point);
  for (std::uint32_t i = 0; i < kept.point.size(); i += 2) {
    arrangement.insert_segment(vertex_of[i], vertex_of[i + 1], i);
  }
  std::vector<VertexOrigin> origins;
  Numbering numbering;
  SFUMATO_TRY(arrangement.status());
  SFUMATO_TRY(chords.seal(context));
  SFUMATO_TRY(scratch.resize(context, origins, mesh.point.size()));
  SFUMATO_TRY(number_everything(context, mesh, numbering));
  Result<TriangleMesh> out = extract(context, {mesh, chords, origins, lattice, numbering}, memory);
  if (out) SFUMATO_TRY(restore_pieces(context, visibility, kept.constraint, memory, *out));
  return out;
}

Status Mesher::refine(const Context& context) {
  state_->has_cut_chords = true;
  ++state_->change_count;
  const Point low = state_->lattice.frame_min, high = state_->lattice.frame_max;
  return state_->refiner.refine_all(context, double(high.x - low.x) * double(high.y - low.y));
}

Status Mesher::refine_triangles(const Context& context, std::span<const std::uint32_t> triangles,
                                double smallest_edge) {
  State& s = *state_;
  TableMemory memory("the triangle mesh");
  std::vector<Refiner::Target> targets;
  SFUMATO_TRY(memory.reserve(context, targets, triangles.size()));
  for (const std::uint32_t t : triangles) {
    if (t < s.patched.size()) targets.push_back(s.patched[t]);
  }
  s.has_cut_chords = true;
  ++s.change_count;
  return s.refiner.refine_targets(context, targets, smallest_edge / s.lattice.step);
}

Result<TriangleMesh> Mesher::patch_mesh(const Context& context) {
  State& s = *state_;
  Status status = number_inside(context, s.mesh, s.numbering);
  s.mesh.take_changed([](std::int32_t) {});
  if (status) status = s.memory.resize(context, s.patched, s.numbering.triangle_count);
  if (!status) return status;
  RarePoll<65536> poll(context);
  for (std::size_t slot = 0; slot < s.mesh.triangle.size(); ++slot) {
    if (poll.cancelled()) return context.cancel_status();
    const std::int32_t t = s.numbering.triangle[slot];
    if (t != kNone) s.patched[t] = {static_cast<std::int32_t>(slot), s.mesh.triangle[slot].stamp};
  }
  return s.extract_anew(context, s.numbering);
}

TableMemory Mesher::release_extracted() {
  return std::exchange(state_->extracted, TableMemory(State::kPurpose, state_->budget));
}

Status Mesher::update_patch_mesh(const Context& context, TriangleMesh& mesh, TableMemory& memory,
                                 std::vector<std::uint32_t>& changed) {
  State& s = *state_;
  if (s.numbering.triangle_count == 0) {
    SFUMATO_TRY_ASSIGN(mesh, patch_mesh(context));
    SFUMATO_TRY(memory.resize(context, changed, mesh.triangle_count()));
    std::iota(changed.begin(), changed.end(), 0u);
    return ok_status();
  }
  SFUMATO_TRY(number_inside(context, s.mesh, s.numbering));
  SFUMATO_TRY(
      s.memory.grow(context, s.patched, s.numbering.triangle_count, s.mesh.triangle.capacity()));
  changed.clear();
  SFUMATO_TRY(memory.reserve(context, changed, s.mesh.changed.size()));
  Status status;
  RarePoll<65536> poll(context);
  s.mesh.take_changed([&](std::int32_t slot) {
    if (status && poll.cancelled()) status = context.cancel_status();
    if (!status) return;
    const std::int32_t t = s.numbering.triangle[slot];
    s.patched[t] = {slot, s.mesh.triangle[slot].stamp};
    changed.push_back(static_cast<std::uint32_t>(t));
  });
  SFUMATO_TRY(status);
  SFUMATO_TRY(TableMemory::sort(context, changed, std::less<>()));
  TableMemory scratch("the triangle mesh");
  std::vector<std::int32_t> slots;
  SFUMATO_TRY(scratch.resize(context, slots, changed.size()));
  for (std::size_t i = 0; i < slots.size(); ++i) {
    if (poll.cancelled()) return context.cancel_status();
    slots[i] = s.patched[changed[i]].triangle;
  }
  const ExtractSource source{s.mesh, s.chords, s.refiner.origins(), s.lattice, s.numbering};
  return update_extract(context, source, slots, s.extracted, mesh);
}

void Mesher::take_back(const TriangleMesh& before, std::span<const std::uint32_t> changed,
                       TriangleMesh& mesh) {
  mesh::take_back(before, changed, mesh);
}

}  // namespace sfumato::mesh
