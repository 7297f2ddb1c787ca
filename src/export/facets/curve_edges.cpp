#include "export/facets/curve_edges.hpp"

#include <algorithm>
#include <tuple>

#include "base/poll.hpp"
#include "base/try.hpp"
#include "export/poll_interval.hpp"

namespace sfumato::outputs {
namespace {

struct EdgeSide {
  std::uint32_t low, high, half_edge;
};

std::uint32_t from_vertex(const PatchLayer& layer, std::uint32_t half_edge) {
  return layer.triangle_vertex[half_edge];
}
std::uint32_t to_vertex(const PatchLayer& layer, std::uint32_t half_edge) {
  return layer.triangle_vertex[next_half_edge(half_edge)];
}

/// Half-edges that run against each other between the same two vertices.
Status pair_sides(Context& context, const PatchLayer& layer, CurveEdges* edges) {
  TableMemory memory("edges on curves");
  std::vector<EdgeSide> sides;
  std::vector<std::uint32_t>& twin = edges->twin;
  SFUMATO_TRY(memory.resize(context, sides, layer.triangle_vertex.size()));
  SFUMATO_TRY(edges->memory.resize(context, twin, sides.size(), kNoHalfEdge));
  RarePoll<kTurnsPerPoll> poll(context);
  for (std::uint32_t h = 0; h < sides.size(); ++h) {
    if (poll.cancelled()) return context.cancel_status();
    const std::uint32_t from = from_vertex(layer, h), to = to_vertex(layer, h);
    sides[h] = {std::min(from, to), std::max(from, to), h};
  }
  SFUMATO_TRY(TableMemory::sort(context, sides, [](const EdgeSide& a, const EdgeSide& b) {
    return std::tie(a.low, a.high, a.half_edge) < std::tie(b.low, b.high, b.half_edge);
  }));
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    if (poll.cancelled()) return context.cancel_status();
    const EdgeSide &a = sides[i], &b = sides[i + 1];
    if (a.low != b.low || a.high != b.high) continue;
    if (from_vertex(layer, a.half_edge) != to_vertex(layer, b.half_edge)) continue;
    twin[a.half_edge] = b.half_edge;
    twin[b.half_edge] = a.half_edge;
    ++i;
  }
  return ok_status();
}

/// Follows curves through vertices where just two of their edges meet.
class CurveTracer {
 public:
  CurveTracer(const PatchLayer& layer, CurveEdges* edges) : layer_(layer), edges_(*edges) {}

  Status trace(Context& context) {
    const std::size_t count = layer_.edge_is_curve.size();
    std::vector<std::uint8_t> is_done;
    SFUMATO_TRY(memory_.resize(context, at_vertex_, layer_.vertex_position.size()));
    SFUMATO_TRY(edges_.memory.resize(context, edges_.onward, count, kNoHalfEdge));
    SFUMATO_TRY(memory_.resize(context, is_done, count));
    RarePoll<kTurnsPerPoll> poll(context);
    std::size_t edge_count = 0;
    for (std::uint32_t h = 0; h < count; ++h) {
      if (poll.cancelled()) return context.cancel_status();
      if (!is_first_side(h)) continue;
      add_ends(h);
      ++edge_count;
    }
    SFUMATO_TRY(edges_.memory.reserve(context, edges_.side, edge_count));
    for (std::uint32_t h = 0; h < count; ++h) {
      if (poll.cancelled()) return context.cancel_status();
      if (!is_first_side(h) || is_done[h]) continue;
      follow(h, &is_done);
      const std::uint32_t back = edges_.twin[h];
      if (back != kNoHalfEdge) follow_back(h, &is_done);
    }
    return ok_status();
  }

 private:
  /// Edges on curves that end at a vertex, and the first two.
  struct Ends {
    std::uint32_t count = 0, first = 0, second = 0;
  };

  bool is_curve(std::uint32_t h) const {
    const std::uint32_t twin = edges_.twin[h];
    return layer_.edge_is_curve[h] || (twin != kNoHalfEdge && layer_.edge_is_curve[twin]);
  }
  /// One half-edge of each edge: that with the lower number.
  bool is_first_side(std::uint32_t h) const { return is_curve(h) && h < edges_.twin[h]; }

  void add_ends(std::uint32_t h) {
    for (std::uint32_t vertex : {from_vertex(layer_, h), to_vertex(layer_, h)}) {
      Ends& ends = at_vertex_[vertex];
      if (ends.count == 0) ends.first = h;
      if (ends.count == 1) ends.second = h;
      ++ends.count;
    }
  }

  /// Returns the first side of the edge that continues from `vertex`, or none.
  std::uint32_t other_edge(std::uint32_t vertex, std::uint32_t first_side) const {
    const Ends& ends = at_vertex_[vertex];
    if (ends.count != 2) return kNoHalfEdge;
    return ends.first == first_side ? ends.second : ends.first;
  }
  std::uint32_t first_side(std::uint32_t h) const {
    const std::uint32_t twin = edges_.twin[h];
    return twin != kNoHalfEdge && twin < h ? twin : h;
  }
  /// Returns the side of an edge that leaves `vertex`; none where the edge has but the other.
  std::uint32_t leaving(std::uint32_t vertex, std::uint32_t first) const {
    return from_vertex(layer_, first) == vertex ? first : edges_.twin[first];
  }

  void add(std::uint32_t h, std::vector<std::uint8_t>* is_done) {
    (*is_done)[first_side(h)] = 1;
    edges_.side.push_back(h);
  }

  void link(std::uint32_t h, std::uint32_t next) {
    edges_.onward[h] = next;
    const std::uint32_t back = edges_.twin[next], end = edges_.twin[h];
    if (back != kNoHalfEdge && end != kNoHalfEdge) edges_.onward[back] = end;
  }

  void follow(std::uint32_t h, std::vector<std::uint8_t>* is_done) {
    add(h, is_done);
    while (true) {
      const std::uint32_t vertex = to_vertex(layer_, h);
      const std::uint32_t first = other_edge(vertex, first_side(h));
      if (first == kNoHalfEdge) return;
      const std::uint32_t next = leaving(vertex, first);
      if (next == kNoHalfEdge) return;
      link(h, next);
      if ((*is_done)[first]) return;
      add(next, is_done);
      h = next;
    }
  }

  /// The part of the curve before its first edge, on the same side.
  void follow_back(std::uint32_t h, std::vector<std::uint8_t>* is_done) {
    while (true) {
      const std::uint32_t vertex = from_vertex(layer_, h);
      const std::uint32_t first = other_edge(vertex, first_side(h));
      if (first == kNoHalfEdge) return;
      const std::uint32_t away = leaving(vertex, first);
      const std::uint32_t before = away == kNoHalfEdge ? first : edges_.twin[away];
      if (before == kNoHalfEdge || to_vertex(layer_, before) != vertex) return;
      link(before, h);
      if ((*is_done)[first]) return;
      add(before, is_done);
      h = before;
    }
  }

  const PatchLayer& layer_;
  CurveEdges& edges_;
  TableMemory memory_{"edges on curves"};
  std::vector<Ends> at_vertex_;
};

}  // namespace

Result<CurveEdges> find_curve_edges(Context& context, const PatchLayer& layer) {
  CurveEdges edges;
  SFUMATO_TRY(pair_sides(context, layer, &edges));
  SFUMATO_TRY(CurveTracer(layer, &edges).trace(context));
  return edges;
}

}  // namespace sfumato::outputs
