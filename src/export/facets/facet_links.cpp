#include "export/facets/facet_links.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "base/poll.hpp"
#include "base/try.hpp"
#include "export/poll_interval.hpp"

namespace sfumato::outputs {
namespace {

/// One number for all vertices at one position, in a table of `memory`.
Result<std::vector<std::uint32_t>> number_positions(Context& context, const FacetMesh& mesh,
                                                    TableMemory& memory) {
  const std::vector<Vec2>& position = mesh.vertex_position;
  TableMemory order_memory("the edges of facets");
  std::vector<std::uint32_t> order, number;
  SFUMATO_TRY(order_memory.resize(context, order, position.size()));
  SFUMATO_TRY(memory.resize(context, number, position.size()));
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](std::uint32_t v) { return std::tuple(position[v].x, position[v].y, v); };
  SFUMATO_TRY(TableMemory::sort(context, order,
                                [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); }));
  RarePoll<kTurnsPerPoll> poll(context);
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (poll.cancelled()) return context.cancel_status();
    const bool is_new = i == 0 || !(position[order[i]] == position[order[i - 1]]);
    number[order[i]] = is_new ? order[i] : number[order[i - 1]];
  }
  return number;
}

struct Edge {
  std::uint32_t low, high;  ///< numbers of the ends
  std::uint32_t index;
  bool rises;  ///< from low to high
};

/// Pairs the edges of [begin, end), which lie on each other.
void pair_up(const Edge* begin, const Edge* end, std::vector<std::uint32_t>* twin) {
  const Edge* falling = begin;
  for (const Edge* rising = begin; rising != end; ++rising) {
    if (!rising->rises) continue;
    falling = std::find_if(falling, end, [](const Edge& edge) { return !edge.rises; });
    if (falling == end) return;
    (*twin)[rising->index] = falling->index;
    (*twin)[falling->index] = rising->index;
    ++falling;
  }
}

}  // namespace

Result<FacetLinks> link_facets(Context& context, const FacetMesh& mesh) {
  const std::size_t count = mesh.facet_vertex.size();
  TableMemory memory("the edges of facets");
  SFUMATO_TRY_ASSIGN(const std::vector<std::uint32_t>& numbered,
                     number_positions(context, mesh, memory));
  const std::vector<std::uint32_t>& number = numbered;
  std::vector<Edge> edges;
  SFUMATO_TRY(memory.resize(context, edges, count));
  RarePoll<kTurnsPerPoll> poll(context);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (poll.cancelled()) return context.cancel_status();
    const std::uint32_t a = number[mesh.facet_vertex[i]],
                        b = number[mesh.facet_vertex[next_half_edge(i)]];
    edges[i] = {std::min(a, b), std::max(a, b), i, a < b};
  }
  SFUMATO_TRY(TableMemory::sort(context, edges, [](const Edge& a, const Edge& b) {
    return std::tie(a.low, a.high, a.index) < std::tie(b.low, b.high, b.index);
  }));
  FacetLinks links;
  SFUMATO_TRY(links.memory.resize(context, links.twin, count, kNoHalfEdge));
  for (std::size_t begin = 0, end; begin < count; begin = end) {
    if (poll.cancelled()) return context.cancel_status();
    const auto same = [&](std::size_t i) {
      return edges[i].low == edges[begin].low && edges[i].high == edges[begin].high;
    };
    for (end = begin + 1; end < count && same(end);) ++end;
    pair_up(edges.data() + begin, edges.data() + end, &links.twin);
  }
  return links;
}

}  // namespace sfumato::outputs
