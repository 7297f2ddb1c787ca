#pragma once

#include <array>
#include <vector>

#include "base/function_ref.hpp"

namespace sfumato::outputs {

/// Barycentric weights of a patch's corners 0, 1, 2.
using Barycentric = std::array<double, 3>;

/// How one patch is cut: its own regular grid, and its edges, which neighbours have a say in.
///
/// Edge k runs from corner k to corner k + 1 and is cut into edge[k] equal parts, whatever the
/// grid. Precondition: grid is 1, or below 2 edge[k] for every k.
struct PatchCut {
  int grid = 1;
  std::array<int, 3> edge{1, 1, 1};
};

/// The points and facets of a cut patch. Points: corners 0, 1, 2, then the inner points of edges
/// 0, 1, 2 in their direction, then those inside. Grid points on an edge move to its nearest cut,
/// and facets that meet cuts between theirs are fans and strips: no T-junction remains.
class FacetGrid {
 public:
  explicit FacetGrid(const PatchCut& cut);

  int point_count() const { return first_inside_ + (cut_.grid - 1) * (cut_.grid - 2) / 2; }
  /// First point of an edge without its corners, or of those inside (edge 3).
  int first_point(int edge) const { return edge < 3 ? first_on_edge_[edge] : first_inside_; }
  std::vector<Barycentric> points() const;

  /// Visits the facets, points in the sense of the patch's corners, always in the same order.
  void for_each_facet(FunctionRef<void(const std::array<int, 3>& point)> visit) const;

 private:
  int edge_point(int edge, int part) const;
  int snapped(int edge, int step) const;
  int grid_point(int row, int column) const;
  std::vector<int> cuts_of_step(int edge, int step) const;
  void visit_corner_facet(int row, int column,
                          FunctionRef<void(const std::array<int, 3>&)> visit) const;

  PatchCut cut_;
  std::array<int, 3> first_on_edge_;
  int first_inside_;
};

}  // namespace sfumato::outputs
