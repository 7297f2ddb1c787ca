#include "mesh/mesher.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <utility>

#include "base/charge.hpp"
#include "base/large_vector.hpp"
#include "base/limit_error.hpp"
#include "base/poll.hpp"
#include "mesh/arrangement.hpp"
#include "mesh/chords.hpp"
#include "mesh/extract.hpp"
#include "mesh/insertion_order.hpp"
#include "mesh/lattice.hpp"
#include "mesh/refiner.hpp"
#include "mesh/triangulation.hpp"

namespace sfumato::mesh {

struct Mesher::State {
  ScopedCharge charge;
  Lattice lattice;
  Triangulation mesh;
  ChordStore chords;
  Refiner refiner{mesh, chords, charge};
  Numbering numbering;                   ///< of the patch mesh, as it was made or updated last
  std::vector<Refiner::Target> patched;  ///< per triangle of it: slot and stamp

  ExtractSource source() const { return {mesh, chords, refiner.origins(), lattice, numbering}; }
};

namespace {

/// Points, their order, its scratch and the vertex of each.
constexpr std::size_t kInputBytesPerPoint = 40;

Status check_sizes(const Limits& limits, const curves::FlatCurves& flat) {
  if (flat.curve_begin.empty() || flat.segment_count() <= limits.segments) return ok_status();
  return limit_error(limits, &Limits::segments, "segments in one layer");
}

/// Inserts all curve vertices; per vertex the vertex that it became.
Result<std::vector<Vertex>> insert_points(Arrangement& arrangement, std::span<const Point> points,
                                          const Lattice& lattice) {
  const std::int32_t extent = std::max(lattice.width, lattice.height);
  const Result<std::vector<std::uint32_t>> order =
      insertion_order(arrangement.context(), points, extent);
  if (!order) return order.status();
  std::vector<Vertex> vertex_of(points.size());
  for (const std::uint32_t i : *order) vertex_of[i] = arrangement.insert_point(points[i]);
  if (!arrangement.status()) return arrangement.status();
  return vertex_of;
}

Status arrange(Arrangement& arrangement, const curves::FlatCurves& flat, const Lattice& lattice) {
  const Point low = lattice.frame_min, high = lattice.frame_max;
  const Vertex corner[4] = {
      arrangement.insert_point(low), arrangement.insert_point({high.x, low.y}),
      arrangement.insert_point(high), arrangement.insert_point({low.x, high.y})};
  std::vector<Point> points(flat.vertex.size());
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = lattice.nearest(flat.vertex[i]);
  const Result<std::vector<Vertex>> inserted = insert_points(arrangement, points, lattice);
  if (!inserted) return inserted.status();
  const std::vector<Vertex>& vertex_of = *inserted;
  for (int k = 0; k < 4; ++k) arrangement.insert_frame_side(corner[k], corner[(k + 1) % 4]);
  arrangement.set_segments(points);
  for (std::uint32_t s = 0; s < flat.vertex.size(); ++s) {
    if (flat.begins_segment(s)) arrangement.insert_segment(vertex_of[s], vertex_of[s + 1], s);
  }
  return arrangement.status();
}

Status seal(Context& context, ChordStore& chords) {
  ScopedCharge charge;
  Status status = charge.add(context, chords.live_owner_count() * sizeof(Owner), "curve pieces");
  if (status) chords.seal();
  return status;
}

/// Marks the triangles inside the frame: those that an odd number of frame chords separates from
/// the hull.
Status flood_inside(const Context& context, Triangulation& mesh, const ChordStore& chords) {
  constexpr std::int16_t kUnknown = -1;
  for (Triangle& t : mesh.triangle) t.inside = kUnknown;
  std::vector<std::int32_t> stack{triangle_of(mesh.spoke[0])};
  mesh.triangle[stack[0]].inside = 0;
  RarePoll<4096> poll(context);
  while (!stack.empty()) {
    if (poll.cancelled()) return context.cancel_status();
    const std::int32_t t = stack.back();
    stack.pop_back();
    for (HalfEdge e = 4 * t; e < 4 * t + 3; ++e) {
      if (mesh.across(e) == kHull) continue;
      const bool frame = mesh.is_wall(e) && chords[mesh.chord[e]].load.frame;
      const auto inside = static_cast<std::int16_t>(mesh.triangle[t].inside ^ int{frame});
      Triangle& other = mesh.triangle[triangle_of(mesh.twin(e))];
      if (other.inside == kUnknown) {
        other.inside = inside;
        stack.push_back(triangle_of(mesh.twin(e)));
      } else if (other.inside != inside) {
        return make_error(StatusCode::internal, "mesh: the frame is not closed");
      }
    }
  }
  return ok_status();
}

std::size_t bytes_of_pieces(const TriangleMesh& mesh) {
  return mesh.piece.size() * sizeof(SegmentPiece);
}

/// Constraints that are meshed again: constraint[i] runs from point 2 i to point 2 i + 1.
struct KeptConstraints {
  std::vector<std::uint32_t> constraint;
  std::vector<Point> point;
};

KeptConstraints kept_constraints(const TriangleMesh& mesh, std::span<const std::uint8_t> keep,
                                 std::size_t count, const Lattice& lattice) {
  KeptConstraints kept;
  kept.constraint.reserve(count);
  kept.point.reserve(2 * count);
  for (std::uint32_t c = 0; c < mesh.constraint.size(); ++c) {
    if (!keep[c]) continue;
    kept.constraint.push_back(c);
    kept.point.push_back(lattice.nearest(mesh.vertex_position[mesh.constraint[c].from]));
    kept.point.push_back(lattice.nearest(mesh.vertex_position[mesh.constraint[c].to]));
  }
  return kept;
}

/// Puts the pieces of the constraints that they stand for in the place of the stand-ins.
void restore_pieces(const TriangleMesh& original, std::span<const std::uint32_t> constraint,
                    TriangleMesh& mesh) {
  const std::vector<SegmentPiece> stand_in = std::move(mesh.piece);
  const auto original_of = [&](const Constraint& c) -> const Constraint& {
    return original.constraint[constraint[stand_in[c.piece_begin].segment / 2]];
  };
  std::size_t count = 0;
  for (const Constraint& c : mesh.constraint) {
    count += original_of(c).piece_end - original_of(c).piece_begin;
  }
  mesh.piece.clear();
  mesh.piece.reserve(count);
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
}

}  // namespace

Mesher::Mesher(std::unique_ptr<State> state) : state_(std::move(state)) {}
Mesher::Mesher(Mesher&&) noexcept = default;
Mesher& Mesher::operator=(Mesher&&) noexcept = default;
Mesher::~Mesher() = default;

Result<Mesher> Mesher::build(Context& context, const curves::FlatCurves& flat,
                             const MeshOptions& options) {
  if (Status status = check_sizes(context.limits, flat); !status) return status;
  Result<Lattice> lattice = choose_lattice(flat, options);
  if (!lattice) return lattice.status();
  auto state = std::make_unique<State>();
  state->lattice = *lattice;
  const std::size_t points = flat.vertex.size();
  ScopedCharge scratch;
  if (Status status = scratch.add(context, points * kInputBytesPerPoint, "mesh input"); !status) {
    return status;
  }
  Status status = state->mesh.grow(context, state->charge, points * 5 / 4 + 64);
  if (!status) return status;
  state->mesh.start(lattice->width, lattice->height);
  Arrangement arrangement(context, state->mesh, state->chords, state->charge,
                          lattice->weld_squared);
  status = arrange(arrangement, flat, *lattice);
  if (status) status = seal(context, state->chords);
  if (!status) return status;
  status = flood_inside(context, state->mesh, state->chords);
  if (!status) return status;
  state->refiner.start();
  const double step = lattice->step;
  state->refiner.set_quality(options.min_angle_deg,
                             options.max_area > 0 ? 2 * options.max_area / (step * step)
                                                  : std::numeric_limits<double>::infinity(),
                             std::sqrt(static_cast<double>(lattice->weld_squared)),
                             options.small_edge / step);
  return Mesher(std::move(state));
}

Result<TriangleMesh> Mesher::visibility_mesh(const Context& context) const {
  const State& s = *state_;
  const Numbering numbering = number_everything(s.mesh);
  return extract(context, {s.mesh, s.chords, s.refiner.origins(), s.lattice, numbering});
}

Result<TriangleMesh> Mesher::thinned_mesh(Context& context, const TriangleMesh& visibility,
                                          std::span<const std::uint8_t> keep) const {
  const Lattice& lattice = state_->lattice;
  const auto count = static_cast<std::size_t>(std::ranges::count(keep, 1));
  ScopedCharge charge;
  // The constraints and their points, and of the pieces those that stand in for them.
  Status status = charge.add(
      context, count * (4 + 2 * kInputBytesPerPoint) + bytes_of_pieces(visibility), "mesh input");
  if (!status) return status;
  const KeptConstraints kept = kept_constraints(visibility, keep, count, lattice);
  Triangulation mesh;
  ChordStore chords;
  status = mesh.grow(context, charge, kept.point.size() * 5 / 4 + 64);
  if (!status) return status;
  mesh.start(lattice.width, lattice.height);
  // They cross nowhere and pass no vertex: nothing is left to weld.
  Arrangement arrangement(context, mesh, chords, charge, 0);
  const Result<std::vector<Vertex>> inserted = insert_points(arrangement, kept.point, lattice);
  if (!inserted) return inserted.status();
  const std::vector<Vertex>& vertex_of = *inserted;
  arrangement.set_segments(kept.point);
  for (std::uint32_t i = 0; i < kept.point.size(); i += 2) {
    arrangement.insert_segment(vertex_of[i], vertex_of[i + 1], i);
  }
  status = arrangement.status();
  if (status) status = seal(context, chords);
  if (!status) return status;
  const std::vector<VertexOrigin> origins(mesh.point.size());
  const Numbering numbering = number_everything(mesh);
  Result<TriangleMesh> out = extract(context, {mesh, chords, origins, lattice, numbering});
  if (out) restore_pieces(visibility, kept.constraint, *out);
  return out;
}

Status Mesher::refine(Context& context) {
  const Point low = state_->lattice.frame_min, high = state_->lattice.frame_max;
  return state_->refiner.refine_all(context, double(high.x - low.x) * double(high.y - low.y));
}

Status Mesher::refine_triangles(Context& context, std::span<const std::uint32_t> triangles,
                                double smallest_edge) {
  State& s = *state_;
  std::vector<Refiner::Target> targets;
  targets.reserve(triangles.size());
  for (const std::uint32_t t : triangles) {
    if (t < s.patched.size()) targets.push_back(s.patched[t]);
  }
  return s.refiner.refine_targets(context, targets, smallest_edge / s.lattice.step);
}

Result<TriangleMesh> Mesher::patch_mesh(const Context& context) {
  State& s = *state_;
  s.mesh.take_changed([](std::int32_t) {});
  Status status = number_inside(context, s.mesh, s.numbering);
  if (status) status = resize_large(context, s.patched, s.numbering.triangle_count);
  if (!status) return status;
  RarePoll<65536> poll(context);
  for (std::size_t slot = 0; slot < s.mesh.triangle.size(); ++slot) {
    if (poll.cancelled()) return context.cancel_status();
    const std::int32_t t = s.numbering.triangle[slot];
    if (t != kNone) s.patched[t] = {static_cast<std::int32_t>(slot), s.mesh.triangle[slot].stamp};
  }
  return extract(context, s.source());
}

Status Mesher::update_patch_mesh(Context& context, TriangleMesh& mesh,
                                 std::vector<std::uint32_t>& changed) {
  State& s = *state_;
  Status status = number_inside(context, s.mesh, s.numbering);
  if (status) {
    status = grow_large(context, s.patched, s.numbering.triangle_count, s.mesh.triangle.capacity());
  }
  changed.clear();
  if (status) status = reserve_large(context, changed, s.mesh.changed.size());
  if (!status) return status;
  RarePoll<65536> poll(context);
  s.mesh.take_changed([&](std::int32_t slot) {
    if (status && poll.cancelled()) status = context.cancel_status();
    if (!status) return;
    const std::int32_t t = s.numbering.triangle[slot];
    s.patched[t] = {slot, s.mesh.triangle[slot].stamp};
    changed.push_back(static_cast<std::uint32_t>(t));
  });
  if (status) status = sort_large(context, changed, std::less<>());
  std::vector<std::int32_t> slots;
  if (status) status = resize_large(context, slots, changed.size());
  if (!status) return status;
  for (std::size_t i = 0; i < slots.size(); ++i) {
    if (poll.cancelled()) return context.cancel_status();
    slots[i] = s.patched[changed[i]].triangle;
  }
  return update_extract(context, s.source(), slots, mesh);
}

}  // namespace sfumato::mesh
