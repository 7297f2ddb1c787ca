#include "export/facet_cuts.hpp"

#include <algorithm>
#include <array>
#include <tuple>

namespace sfumato::outputs {
namespace {

constexpr std::size_t kGrain = 256;

/// A side of a triangle by its end vertices, the lower index first.
struct Side {
  std::uint32_t low, high, half_edge;
};

using EdgeNodes = std::array<std::uint32_t, 4>;

/// The nodes on a side, from its lower vertex to the higher one.
EdgeNodes nodes_on(const PatchLayer& layer, const PatchField& field, std::uint32_t half_edge) {
  const std::size_t first = std::size_t{10} * (half_edge / 3);
  const std::uint32_t k = half_edge % 3, next = (k + 1) % 3;
  const std::uint32_t* node = field.triangle_node.data() + first;
  EdgeNodes nodes{node[k], node[3 + 2 * k], node[4 + 2 * k], node[next]};
  const std::uint32_t* corner = layer.triangle_vertex.data() + (half_edge - k);
  if (corner[k] > corner[next]) std::reverse(nodes.begin(), nodes.end());
  return nodes;
}

std::vector<Side> sorted_sides(const PatchLayer& layer, const PatchField& field) {
  std::vector<Side> sides(layer.triangle_vertex.size());
  for (std::uint32_t h = 0; h < sides.size(); ++h) {
    const std::uint32_t from = layer.triangle_vertex[h];
    const std::uint32_t to = layer.triangle_vertex[h % 3 == 2 ? h - 2 : h + 1];
    sides[h] = {std::min(from, to), std::max(from, to), h};
  }
  std::sort(sides.begin(), sides.end(), [&](const Side& a, const Side& b) {
    if (a.low != b.low || a.high != b.high)
      return std::tie(a.low, a.high) < std::tie(b.low, b.high);
    const EdgeNodes on_a = nodes_on(layer, field, a.half_edge);
    const EdgeNodes on_b = nodes_on(layer, field, b.half_edge);
    return on_a != on_b ? on_a < on_b : a.half_edge < b.half_edge;
  });
  return sides;
}

/// Numbers the edges and gives each the finest cut at its vertices.
void join_edges(const PatchLayer& layer, const PatchField& field, FacetCuts* cuts) {
  const std::vector<Side> sides = sorted_sides(layer, field);
  cuts->edge_of.resize(sides.size());
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    std::uint8_t finest = 1;
    for (; end < sides.size() && sides[end].low == sides[begin].low &&
           sides[end].high == sides[begin].high;
         ++end)
      finest = std::max(finest, cuts->grid[sides[end].half_edge / 3]);
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t half_edge = sides[i].half_edge;
      const bool is_same = i > begin && nodes_on(layer, field, half_edge) ==
                                            nodes_on(layer, field, sides[i - 1].half_edge);
      if (!is_same) cuts->edge.push_back({half_edge, finest});
      cuts->edge_of[half_edge] = static_cast<std::uint32_t>(cuts->edge.size() - 1);
    }
  }
}

/// Into how many parts sides may be cut that are not to become shorter than `smallest_side`.
int most_cuts(const PatchLayer& layer, std::uint32_t triangle, double smallest_side) {
  double longest = 0;
  for (std::uint32_t k = 0; k < 3; ++k) {
    const auto corner = [&](std::uint32_t i) {
      return layer.vertex_position[layer.triangle_vertex[std::size_t{3} * triangle + i % 3]];
    };
    longest = std::max(longest, length(corner(k + 1) - corner(k)));
  }
  if (!(longest < kMostCuts * smallest_side)) return kMostCuts;
  return std::max(1, static_cast<int>(longest / smallest_side));
}

/// The grid of a patch with edges finer than it: as coarse as the error allows.
int stitched_grid(const FacetPatch& patch, PatchCut cut) {
  const int own = cut.grid;
  for (; cut.grid < 2 * own - 1; ++cut.grid)
    if (patch.is_met_by(FacetGrid(cut))) break;
  return cut.grid;
}

}  // namespace

PatchCut FacetCuts::of(std::uint32_t triangle) const {
  PatchCut cut;
  cut.grid = grid[triangle];
  for (std::size_t k = 0; k < 3; ++k)
    cut.edge[k] = edge[edge_of[std::size_t{3} * triangle + k]].cuts;
  return cut;
}

Result<FacetCuts> find_cuts(Context& context, const PatchLayer& layer, InterpolationSpace space,
                            const FacetSource& source, double max_error, double smallest_side) {
  FacetCuts cuts;
  const std::size_t count = layer.triangle_count();
  // A grid and at most three edges to a triangle, and the sides while they are sorted.
  const std::size_t bytes = count * (1 + 3 * (4 + sizeof(FacetEdge) + sizeof(Side)));
  Status status = cuts.charge.add(context, bytes, "cuts of patches");
  if (!status) return status;
  cuts.grid.resize(count);
  const auto for_each_patch = [&](auto body) {
    return parallel_for(context, count, kGrain, [&](std::size_t begin, std::size_t end) {
      for (auto t = static_cast<std::uint32_t>(begin); t < end; ++t)
        body(t, FacetPatch(layer, space, source, t, max_error));
    });
  };
  status = for_each_patch([&](std::uint32_t t, const FacetPatch& patch) {
    cuts.grid[t] = static_cast<std::uint8_t>(patch.cuts(most_cuts(layer, t, smallest_side)));
  });
  if (!status) return status;
  join_edges(layer, field_of(layer, source), &cuts);
  status = for_each_patch([&](std::uint32_t t, const FacetPatch& patch) {
    const PatchCut cut = cuts.of(t);
    const auto [least, most] = std::minmax_element(cut.edge.begin(), cut.edge.end());
    if ((*least != cut.grid || *most != cut.grid) && cut.grid < most_cuts(layer, t, smallest_side))
      cuts.grid[t] = static_cast<std::uint8_t>(stitched_grid(patch, cut));
  });
  if (!status) return status;
  return cuts;
}

}  // namespace sfumato::outputs
