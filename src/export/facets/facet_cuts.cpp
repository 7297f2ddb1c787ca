#include "export/facets/facet_cuts.hpp"

#include <algorithm>
#include <array>
#include <tuple>

#include "base/half_edge.hpp"
#include "base/parallel.hpp"
#include "base/poll.hpp"
#include "base/try.hpp"
#include "export/poll_interval.hpp"
#include "picture/patch.hpp"

namespace sfumato::outputs {
namespace {

constexpr std::size_t kCutsPerTask = 256;

/// A side of a triangle by its end vertices, the lower index first.
struct Side {
  std::uint32_t low, high, half_edge;
};

using EdgeNodes = std::array<std::uint32_t, 4>;

/// Returns the nodes on a side, from its lower vertex to the higher one.
EdgeNodes nodes_on(const PatchLayer& layer, const PatchField& field, std::uint32_t half_edge) {
  const std::size_t first = node_slot(half_edge / 3, 0);
  const std::uint32_t k = half_edge % 3, next = (k + 1) % 3;
  const std::uint32_t* node = field.triangle_node.data() + first;
  EdgeNodes nodes{node[k], node[near_node(k)], node[far_node(k)], node[next]};
  const std::uint32_t* corner = layer.triangle_vertex.data() + (half_edge - k);
  if (corner[k] > corner[next]) std::reverse(nodes.begin(), nodes.end());
  return nodes;
}

Result<std::vector<Side>> sorted_sides(Context& context, const PatchLayer& layer,
                                       const PatchField& field, TableMemory& memory) {
  std::vector<Side> sides;
  SFUMATO_TRY(memory.resize(context, sides, layer.triangle_vertex.size()));
  RarePoll<kTurnsPerPoll> poll(context);
  for (std::uint32_t h = 0; h < sides.size(); ++h) {
    if (poll.cancelled()) return context.cancel_status();
    const std::uint32_t from = layer.triangle_vertex[h];
    const std::uint32_t to = layer.triangle_vertex[next_half_edge(h)];
    sides[h] = {std::min(from, to), std::max(from, to), h};
  }
  SFUMATO_TRY(TableMemory::sort(context, sides, [&](const Side& a, const Side& b) {
    if (a.low != b.low || a.high != b.high)
      return std::tie(a.low, a.high) < std::tie(b.low, b.high);
    const EdgeNodes on_a = nodes_on(layer, field, a.half_edge);
    const EdgeNodes on_b = nodes_on(layer, field, b.half_edge);
    return on_a != on_b ? on_a < on_b : a.half_edge < b.half_edge;
  }));
  return sides;
}

/// Cuts an edge by halving, where one of the curves of values along it asks for it.
std::uint64_t steps_of(const std::vector<FacetPatch>& along, double length, double smallest_side) {
  std::uint64_t steps = 0;
  const auto halve = [&](const auto& self, int from, int to) -> void {
    const double size = 1.0 * (to - from) / kEdgeSteps;
    if (to - from < 2 || size * length < 2 * smallest_side) return;
    const auto at = [](int step) {
      return Barycentric{1.0 * (kEdgeSteps - step) / kEdgeSteps, 1.0 * step / kEdgeSteps, 0};
    };
    const bool is_straight = std::all_of(along.begin(), along.end(), [&](const FacetPatch& edge) {
      return size * edge.most_cuts() < 2 || edge.is_straight_edge(at(from), at(to));
    });
    if (is_straight) return;
    const int middle = (from + to) / 2;
    steps |= std::uint64_t{1} << middle;
    self(self, from, middle);
    self(self, middle, to);
  };
  halve(halve, 0, kEdgeSteps);
  return steps;
}

/// Numbers the edges; cuts->edge lies in the order of `sides`, and edges between the same vertices
/// follow one another. Returns the first edge between each two vertices, and how many there are, in
/// a table of `memory`.
Result<std::vector<std::uint32_t>> number_edges(Context& context, const PatchLayer& layer,
                                                const PatchField& field, FacetCuts* cuts,
                                                TableMemory& memory) {
  TableMemory side_memory("cuts of patches");
  SFUMATO_TRY_ASSIGN(const std::vector<Side>& sorted,
                     sorted_sides(context, layer, field, side_memory));
  const std::vector<Side>& sides = sorted;
  std::vector<std::uint32_t> first;
  SFUMATO_TRY(cuts->memory.resize(context, cuts->edge_of, sides.size()));
  RarePoll<kTurnsPerPoll> poll(context);
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (poll.cancelled()) return context.cancel_status();
    const bool is_same_place =
        i > 0 && sides[i].low == sides[i - 1].low && sides[i].high == sides[i - 1].high;
    const bool is_same_edge = is_same_place && nodes_on(layer, field, sides[i].half_edge) ==
                                                   nodes_on(layer, field, sides[i - 1].half_edge);
    const auto index = static_cast<std::uint32_t>(cuts->edge.size());
    if (!is_same_place) SFUMATO_TRY(memory.push_back(context, first, index));
    if (!is_same_edge)
      SFUMATO_TRY(cuts->memory.push_back(context, cuts->edge, {0, sides[i].half_edge}));

    cuts->edge_of[sides[i].half_edge] = static_cast<std::uint32_t>(cuts->edge.size() - 1);
  }
  SFUMATO_TRY(memory.push_back(context, first, static_cast<std::uint32_t>(cuts->edge.size())));
  return first;
}

Vec2 corner_position(const PatchLayer& layer, std::uint32_t half_edge) {
  return layer.vertex_position[layer.triangle_vertex[half_edge]];
}

double length_of(const PatchLayer& layer, std::uint32_t half_edge) {
  return length(corner_position(layer, next_half_edge(half_edge)) -
                corner_position(layer, half_edge));
}

}  // namespace

bool is_low_first(const PatchLayer& layer, std::uint32_t half_edge) {
  return layer.triangle_vertex[half_edge] < layer.triangle_vertex[next_half_edge(half_edge)];
}

std::array<EdgeCuts, 3> FacetCuts::of(const PatchLayer& layer, std::uint32_t triangle) const {
  std::array<EdgeCuts, 3> cuts;
  for (std::uint32_t k = 0; k < 3; ++k) {
    const std::uint32_t half_edge = 3 * triangle + k;
    cuts[k] = {edge[edge_of[half_edge]].steps, !is_low_first(layer, half_edge)};
  }
  return cuts;
}

Result<FacetCuts> find_cuts(Context& context, const PatchLayer& layer, InterpolationSpace space,
                            const FacetSource& source, double max_error, double smallest_side) {
  FacetCuts cuts;
  TableMemory memory("cuts of patches");
  SFUMATO_TRY_ASSIGN(const std::vector<std::uint32_t>& numbered,
                     number_edges(context, layer, field_of(layer, source), &cuts, memory));
  const std::vector<std::uint32_t>& first = numbered;
  const auto cut = [&](std::size_t place) {
    std::vector<FacetPatch> along;
    const std::uint32_t half_edge = cuts.edge[first[place]].half_edge;
    for (std::uint32_t e = first[place]; e < first[place + 1]; ++e) {
      const std::uint32_t side = cuts.edge[e].half_edge;
      along.push_back(FacetPatch(layer, space, source, side / 3, max_error)
                          .edge(side % 3, !is_low_first(layer, side)));
    }
    const std::uint64_t steps = steps_of(along, length_of(layer, half_edge), smallest_side);
    for (std::uint32_t e = first[place]; e < first[place + 1]; ++e) cuts.edge[e].steps = steps;
  };
  SFUMATO_TRY(parallel_for(context, first.size() - 1, kCutsPerTask,
                           [&](std::size_t begin, std::size_t end) {
                             for (std::size_t place = begin; place < end; ++place) cut(place);
                           }));
  return cuts;
}

}  // namespace sfumato::outputs
