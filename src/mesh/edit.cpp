#include "mesh/edit.hpp"

#include <utility>

#include "base/poll.hpp"
#include "base/try.hpp"

namespace sfumato::mesh {
namespace {

/// Returns the chord of `baked` for edge e.
std::int32_t bake_edge(const Triangulation& mesh, HalfEdge e, const ChordStore& chords,
                       const std::vector<VertexOrigin>& origins, ChordStore& baked) {
  const std::int32_t index = mesh.chord[e];
  const Chord& chord = chords[index];
  Vertex from = mesh.origin(e), to = mesh.target(e);
  const Point a = mesh.point[chord.from], b = mesh.point[chord.to];
  if (dot_from(a, b, mesh.point[from]) > dot_from(a, b, mesh.point[to])) std::swap(from, to);
  return baked.add_part(chords, chord, from, to, fraction_at(chord, index, from, origins[from]),
                        fraction_at(chord, index, to, origins[to]));
}

}  // namespace

Status bake_chords(const Context& context, Budget& budget, Triangulation& mesh, ChordStore& chords,
                   std::vector<VertexOrigin>& origins) {
  constexpr std::int32_t kEdgesPerCharge = 4096;
  ChordStore baked(budget);
  std::int32_t edges = 0;
  for (std::size_t slot = 0; slot < mesh.triangle.size(); ++slot) {
    for (HalfEdge e = static_cast<HalfEdge>(4 * slot); corner_of(e) < 3; ++e) {
      if (!mesh.is_constrained(e) || mesh.twin(e) < e) continue;
      const std::int32_t chord = bake_edge(mesh, e, chords, origins, baked);
      mesh.chord[e] = mesh.chord[mesh.twin(e)] = chord;
      if (++edges % kEdgesPerCharge != 0) continue;
      if (context.cancelled()) return context.cancel_status();
      SFUMATO_TRY(baked.charge(context));
    }
  }
  SFUMATO_TRY(baked.charge(context));
  chords = std::move(baked);
  origins.assign(origins.size(), {});
  return context.check();
}

Status take_segments_off(const Context& context, std::span<const std::uint8_t> is_removed,
                         Triangulation& mesh, ChordStore& chords) {
  RarePoll<1024> poll(context);
  const auto count = static_cast<std::int32_t>(chords.size());
  for (std::int32_t c = 0; c < count; ++c) {
    if (poll.cancelled()) return context.cancel_status();
    if (!chords.take_off(c, is_removed)) continue;
    mesh.touch_around(chords[c].from);
    mesh.touch_around(chords[c].to);
    if (!chords[c].load.empty()) continue;
    const HalfEdge e = mesh.find_edge(chords[c].from, chords[c].to);
    if (e == kNone) return make_error(StatusCode::internal, "mesh: a chord that is no edge");
    chords.remove(c);
    mesh.unconstrain(e);
    mesh.pending.push_back(e);
    mesh.legalize();
  }
  return ok_status();
}

}  // namespace sfumato::mesh
