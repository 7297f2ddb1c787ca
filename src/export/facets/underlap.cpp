#include "export/facets/underlap.hpp"

#include <algorithm>
#include <cmath>

#include "base/poll.hpp"
#include "base/try.hpp"
#include "export/facets/end_loops.hpp"
#include "export/poll_interval.hpp"

namespace sfumato::outputs {
namespace {

/// Points of an outline for each facet, at most on average: 3 corners, 2 points for an edge that
/// has a later neighbour (half of them), and 6 spokes for a corner (one for 2 facets).
constexpr std::size_t kPointsPerFacet = 10;
/// A corner of a grown facet moves by at most this many margins; sharp corners would move far.
constexpr double kFarthestCorner = 3;

Vec2 direction(Vec2 from, Vec2 to) {
  const double size = length(to - from);
  return size > 0 ? (to - from) * (1 / size) : Vec2{};
}

class Outliner {
 public:
  Outliner(const FacetMesh& mesh, const FacetLinks& links, const UnderlapReach& reach,
           std::vector<Vec2>* out)
      : mesh_(mesh), links_(links), reach_(reach), out_(*out) {}

  void add(std::uint32_t facet) {
    for (std::uint32_t edge = 3 * facet; edge < 3 * facet + 3; ++edge) {
      if (is_first_around(edge)) {
        add_cap(edge);
      } else {
        out_.push_back(start(edge));
      }
      add_edge(edge);
    }
  }

 private:
  Vec2 start(std::uint32_t edge) const { return mesh_.vertex_position[mesh_.facet_vertex[edge]]; }
  std::uint32_t twin(std::uint32_t edge) const { return links_.twin[edge]; }

  /// Returns whether the facet is painted before all others around the start of one of its edges.
  bool is_first_around(std::uint32_t edge) const;
  void add_cap(std::uint32_t edge);
  void add_edge(std::uint32_t edge);
  /// Where the mesh ends between two edges of it that meet in `corner`.
  void add_gap(Vec2 corner, std::uint32_t last, std::uint32_t first);
  Vec2 outward(std::uint32_t edge) const {
    return left_of(direction(start(edge), start(next_half_edge(edge)))) * reach_.outside;
  }
  Vec2 spoke(Vec2 corner, Vec2 end) const {
    return corner + direction(corner, end) * std::min(reach_.inside, 0.5 * length(end - corner));
  }

  const FacetMesh& mesh_;
  const FacetLinks& links_;
  const UnderlapReach& reach_;
  std::vector<Vec2>& out_;
};

bool Outliner::is_first_around(std::uint32_t edge) const {
  const std::uint32_t facet = edge / 3;
  std::uint32_t leaving = twin(previous_half_edge(edge));
  while (leaving != kNoHalfEdge && leaving / 3 != facet) {
    if (leaving / 3 < facet) return false;
    leaving = twin(previous_half_edge(leaving));
  }
  if (leaving != kNoHalfEdge) return true;
  for (std::uint32_t arriving = twin(edge); arriving != kNoHalfEdge;
       arriving = twin(next_half_edge(arriving))) {
    if (arriving / 3 < facet) return false;
  }
  return true;
}

/// Around the start of `edge`: along the spokes between the other facets there.
void Outliner::add_cap(std::uint32_t edge) {
  const Vec2 corner = start(edge);
  const std::uint32_t facet = edge / 3;
  std::uint32_t arriving = previous_half_edge(edge);
  while (true) {
    const std::uint32_t leaving = twin(arriving);
    if (leaving == kNoHalfEdge) break;
    arriving = previous_half_edge(leaving);
    const std::uint32_t across = twin(arriving);
    if (across != kNoHalfEdge && across / 3 == facet) return;
    out_.push_back(spoke(corner, start(arriving)));
  }
  // The mesh ends here; the spokes between there and `edge` come in the other order.
  const std::size_t gap = out_.size();
  std::uint32_t leaving = edge;
  while (twin(leaving) != kNoHalfEdge) {
    leaving = next_half_edge(twin(leaving));
    out_.push_back(spoke(corner, start(next_half_edge(leaving))));
  }
  std::vector<Vec2> others(out_.begin() + static_cast<std::ptrdiff_t>(gap), out_.end());
  out_.resize(gap);
  add_gap(corner, arriving, leaving);
  out_.insert(out_.end(), others.rbegin(), others.rend());
}

void Outliner::add_gap(Vec2 corner, std::uint32_t last, std::uint32_t first) {
  if (reach_.outside == 0) {
    out_.push_back(corner);
    return;
  }
  const Vec2 a = outward(last), b = outward(first);
  out_.push_back(spoke(corner, start(last)) + a);
  out_.push_back(corner + direction({}, a + b) * (1.4 * reach_.outside));
  out_.push_back(spoke(corner, start(next_half_edge(first))) + b);
}

void Outliner::add_edge(std::uint32_t edge) {
  const Vec2 a = start(edge), b = start(next_half_edge(edge));
  const std::uint32_t other = twin(edge);
  if (other == kNoHalfEdge) {
    if (reach_.outside == 0) return;
    out_.push_back(a + outward(edge));
    out_.push_back(b + outward(edge));
    return;
  }
  if (other / 3 < edge / 3) return;
  // Inside the neighbour, as deep as its inscribed circle's centre at most, and there between the
  // bisectors of its angles: its other edges stay free.
  const Vec2 c = start(previous_half_edge(other));
  const double area = std::fabs(cross(b - a, c - a)), base = length(b - a);
  const double left = length(c - a), right = length(c - b);
  const double perimeter = base + left + right;
  const double radius = area / perimeter;
  if (!(radius > 0)) return;
  const double depth = std::min(reach_.inside, radius);
  const Vec2 along = direction(a, b), inward = left_of(along) * depth;
  // From a corner to where the inscribed circle touches, in proportion to the depth.
  const double from_a = (base + left - right) / 2 * depth / radius;
  const double from_b = (base + right - left) / 2 * depth / radius;
  out_.push_back(a + along * from_a + inward);
  if (depth < radius) out_.push_back(b - along * from_b + inward);
}

/// Calls visit(edge) for the edges that leave the first corner of `edge`, as far as neighbouring
/// facets follow each other.
template <class Visit>
void for_each_around(const FacetLinks& links, std::uint32_t edge, Visit visit) {
  std::uint32_t leaving = edge;
  do {
    visit(leaving);
    leaving = links.twin[previous_half_edge(leaving)];
  } while (leaving != kNoHalfEdge && leaving != edge);
}

/// Facets that have a corner at the end of the mesh, and their neighbours.
Status mark_near_end(Context& context, const FacetLinks& links,
                     std::vector<std::uint8_t>& near_end) {
  const std::size_t edges = links.twin.size();
  RarePoll<kWritesPerPoll> poll(context);
  TableMemory memory("the outlines of facets");
  std::vector<std::uint8_t> at_end;
  SFUMATO_TRY(memory.resize(context, at_end, edges / 3));
  for (std::uint32_t edge = 0; edge < edges; ++edge) {
    if (poll.cancelled()) return context.cancel_status();
    if (links.twin[edge] != kNoHalfEdge) continue;
    for_each_around(links, edge, [&](std::uint32_t around) { at_end[around / 3] = 1; });
  }
  for (std::uint32_t edge = 0; edge < edges; ++edge) {
    if (poll.cancelled()) return context.cancel_status();
    if (!at_end[edge / 3]) continue;
    near_end[edge / 3] = 1;
    for_each_around(links, edge, [&](std::uint32_t around) { near_end[around / 3] = 1; });
  }
  return ok_status();
}

}  // namespace

Result<FacetOutlines> underlapped(Context& context, const FacetMesh& mesh, const FacetLinks& links,
                                  const UnderlapReach& reach) {
  const std::size_t count = mesh.facet_vertex.size() / 3;
  FacetOutlines outlines;
  TableMemory& memory = outlines.memory;
  SFUMATO_TRY(memory.reserve(context, outlines.point, count * kPointsPerFacet));
  SFUMATO_TRY(memory.reserve(context, outlines.first, count + 1));
  std::vector<Vec2> outline;  // of one facet
  Outliner outliner(mesh, links, reach, &outline);
  RarePoll<kWritesPerPoll> poll(context);
  for (std::uint32_t facet = 0; facet < count; ++facet) {
    if (poll.cancelled()) return context.cancel_status();
    outlines.first.push_back(static_cast<std::uint32_t>(outlines.point.size()));
    outline.clear();
    outliner.add(facet);
    SFUMATO_TRY(memory.append(context, outline, outlines.point));
  }
  outlines.first.push_back(static_cast<std::uint32_t>(outlines.point.size()));
  return outlines;
}

Result<std::vector<SmallFacet>> small_facets(Context& context, const FacetMesh& mesh,
                                             const FacetLinks& links, double radius, double margin,
                                             bool keeps_outline, TableMemory& memory) {
  TableMemory mark_memory("the outlines of facets");
  std::vector<std::uint8_t> is_near_end;
  SFUMATO_TRY(mark_memory.resize(context, is_near_end, mesh.facet_vertex.size() / 3));
  if (keeps_outline) SFUMATO_TRY(mark_near_end(context, links, is_near_end));
  RarePoll<kWritesPerPoll> poll(context);
  std::vector<SmallFacet> result;
  for (std::uint32_t facet = 0; 3 * facet < mesh.facet_vertex.size(); ++facet) {
    if (poll.cancelled()) return context.cancel_status();
    const std::uint32_t* vertex = mesh.facet_vertex.data() + std::size_t{3} * facet;
    if (is_near_end[facet]) continue;
    const Vec2 p[3] = {mesh.vertex_position[vertex[0]], mesh.vertex_position[vertex[1]],
                       mesh.vertex_position[vertex[2]]};
    const double side[3] = {length(p[2] - p[1]), length(p[0] - p[2]), length(p[1] - p[0])};
    const double perimeter = side[0] + side[1] + side[2];
    const double inradius = cross(p[1] - p[0], p[2] - p[0]) / perimeter;
    if (!(inradius > 0) || inradius >= radius) continue;
    const Vec2 center = (p[0] * side[0] + p[1] * side[1] + p[2] * side[2]) / perimeter;
    SFUMATO_TRY(memory.make_room(context, result));
    SmallFacet& small = result.emplace_back();
    small.facet = facet;
    for (int k = 0; k < 3; ++k) {
      const double reach = length(p[k] - center) * margin / inradius;
      small.grown[k] = p[k] + direction(center, p[k]) * std::min(reach, kFarthestCorner * margin);
    }
  }
  return result;
}

Result<Silhouette> silhouette(Context& context, const FacetMesh& mesh, const FacetLinks& links,
                              const Box& frame) {
  Silhouette result;
  const auto start = [&](std::uint32_t edge) {
    return mesh.vertex_position[mesh.facet_vertex[edge]];
  };
  const auto add = [&](std::uint32_t edge, bool is_first) {
    Status room;
    if (is_first) room = result.memory.push_back(context, result.loops, {});
    if (room) room = result.memory.push_back(context, result.loops.back(), start(edge));
    result.is_frame &= is_on_frame(start(edge), start(next_half_edge(edge)), frame);
    return room;
  };
  SFUMATO_TRY(for_each_end_loop(context, links.twin, add));
  return result;
}

}  // namespace sfumato::outputs
