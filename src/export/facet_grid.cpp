#include "export/facet_grid.hpp"

#include <algorithm>
#include <cstddef>

namespace sfumato::outputs {
namespace {

using Facet = std::array<int, 3>;
using Chain = std::vector<int>;

/// Facets of a triangle with points on its sides: from corner A down the chains A…B and A…C at
/// once, and the last of these facets fanned over the chain B…C.
void visit_strip(const Chain& ab, const Chain& bc, const Chain& ac,
                 FunctionRef<void(const Facet&)> visit) {
  std::size_t i = 1, j = 1;
  Facet last{ab[0], ab[1], ac[1]};
  while (i + 1 < ab.size() || j + 1 < ac.size()) {
    visit(last);
    // The chain that is behind, as a share of its length, takes the step.
    const bool along_ab =
        j + 1 == ac.size() || (i + 1 < ab.size() && i * (ac.size() - 1) <= j * (ab.size() - 1));
    if (along_ab) {
      last = {ab[i], ab[i + 1], ac[j]};
      ++i;
    } else {
      last = {ac[j], ab[i], ac[j + 1]};
      ++j;
    }
  }
  for (std::size_t k = 0; k + 1 < bc.size(); ++k) visit({last[0], bc[k], bc[k + 1]});
}

Chain reversed(Chain chain) {
  std::reverse(chain.begin(), chain.end());
  return chain;
}

}  // namespace

FacetGrid::FacetGrid(const PatchCut& cut) : cut_(cut) {
  int next = 3;
  for (int k = 0; k < 3; ++k) {
    first_on_edge_[k] = next;
    next += cut.edge[k] - 1;
  }
  first_inside_ = next;
}

/// Point `part` of edge[k] parts of an edge.
int FacetGrid::edge_point(int edge, int part) const {
  if (part == 0) return edge;
  if (part == cut_.edge[edge]) return (edge + 1) % 3;
  return first_on_edge_[edge] + part - 1;
}

/// The cut of an edge that is nearest to a step of the grid.
int FacetGrid::snapped(int edge, int step) const {
  return (2 * step * cut_.edge[edge] + cut_.grid) / (2 * cut_.grid);
}

/// Rows run along edge 0, `row` is the weight of corner 2 and `column` that of corner 1.
int FacetGrid::grid_point(int row, int column) const {
  const int n = cut_.grid;
  if (row == 0) return edge_point(0, snapped(0, column));
  if (row + column == n) return edge_point(1, snapped(1, row));
  if (column == 0) return edge_point(2, snapped(2, n - row));
  return first_inside_ + (row - 1) * (n - 1) - row * (row - 1) / 2 + column - 1;
}

std::vector<Barycentric> FacetGrid::points() const {
  std::vector<Barycentric> points{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  points.reserve(static_cast<std::size_t>(point_count()));
  for (int k = 0; k < 3; ++k) {
    for (int part = 1; part < cut_.edge[k]; ++part) {
      Barycentric at{};
      at[(k + 1) % 3] = 1.0 * part / cut_.edge[k];
      at[k] = 1.0 * (cut_.edge[k] - part) / cut_.edge[k];
      points.push_back(at);
    }
  }
  const int n = cut_.grid;
  for (int row = 1; row < n; ++row)
    for (int column = 1; row + column < n; ++column)
      points.push_back({1.0 * (n - row - column) / n, 1.0 * column / n, 1.0 * row / n});
  return points;
}

/// The cuts of an edge from a step of the grid to the next.
std::vector<int> FacetGrid::cuts_of_step(int edge, int step) const {
  Chain points;
  const int last = snapped(edge, step + 1);
  for (int part = snapped(edge, step); part <= last; ++part)
    points.push_back(edge_point(edge, part));
  return points;
}

/// The facets of the grid's triangle at (row, column), (row, column + 1), (row + 1, column), whose
/// sides may lie on edges of the patch.
void FacetGrid::visit_corner_facet(int row, int column,
                                   FunctionRef<void(const Facet&)> visit) const {
  const int n = cut_.grid;
  const bool on_edge[3] = {row == 0, row + column + 1 == n, column == 0};
  const int step[3] = {column, row, n - row - 1};
  const int corner[3] = {grid_point(row, column), grid_point(row, column + 1),
                         grid_point(row + 1, column)};
  Chain side[3];
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3;
    if (corner[k] == corner[next]) return;  // both moved to one cut: nothing is left of it
    side[k] = on_edge[k] ? cuts_of_step(k, step[k]) : Chain{corner[k], corner[next]};
  }
  // A lies where two cut sides meet, or opposite the only one.
  int a = 0;
  for (int k = 0; k < 3; ++k) {
    const bool has_first = side[k].size() > 2, has_last = side[(k + 2) % 3].size() > 2;
    const bool has_opposite = side[(k + 1) % 3].size() > 2;
    if ((has_first && has_last) || (has_opposite && !has_first && !has_last)) a = k;
  }
  visit_strip(side[a], side[(a + 1) % 3], reversed(side[(a + 2) % 3]), visit);
}

void FacetGrid::for_each_facet(FunctionRef<void(const Facet&)> visit) const {
  const int n = cut_.grid;
  for (int row = 0; row < n; ++row) {
    for (int column = 0; row + column < n; ++column) {
      visit_corner_facet(row, column, visit);
      if (row + column + 1 == n) continue;
      visit({grid_point(row, column + 1), grid_point(row + 1, column + 1),
             grid_point(row + 1, column)});
    }
  }
}

}  // namespace sfumato::outputs
