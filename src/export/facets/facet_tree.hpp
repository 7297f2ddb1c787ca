#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "export/facets/facet_patch.hpp"

namespace sfumato::outputs {

/// The number of steps on an edge, at which it may be cut.
inline constexpr int kEdgeSteps = kMostCuts;
static_assert(kEdgeSteps == 64, "a cut is a bit of 64");

/// The cuts of a patch's edge, by halving: bit i is a cut at i/64 of the edge. Bit 0 is never set.
struct EdgeCuts {
  std::uint64_t steps = 0;
  bool is_reversed = false;  ///< counted from the end of the patch's edge

  int count() const { return std::popcount(steps); }
};

/// The facets of one patch. Sides that bend too much are halved, the patch's own edges at their
/// cuts, until all facets are straight enough. Facets are long and thin where the patch bends in
/// one direction only. Points: corners 0, 1, 2, then the inner points of edges 0, 1, 2 in their
/// direction (edge k from corner k to the next), then points inside.
class FacetTree {
 public:
  /// corner         of the patch, layer frame
  /// smallest_side  layer frame; no side inside becomes shorter
  FacetTree(const FacetPatch& patch, const std::array<EdgeCuts, 3>& cuts,
            const std::array<Vec2, 3>& corner, double smallest_side);

  const std::vector<Barycentric>& points() const { return point_; }
  std::size_t first_inside() const { return first_on_edge_[3]; }
  /// Three points each, oriented like the patch's corners.
  const std::vector<std::array<std::uint32_t, 3>>& facets() const { return facet_; }

 private:
  using Facet = std::array<std::uint32_t, 3>;
  /// For each side of a triangle the patch's edge that it lies on, or kInner.
  using Sides = std::array<int, 3>;
  static constexpr int kInner = 3;
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  void add_edge_points();
  std::uint32_t midpoint(std::uint32_t a, std::uint32_t b, int edge);
  std::uint32_t midpoint_on_edge(std::uint32_t a, std::uint32_t b, int edge) const;
  bool may_halve(std::uint32_t a, std::uint32_t b) const;
  int step_on_edge(std::uint32_t point, int edge) const;
  void divide(const Facet& facet, const Sides& side, int depth);
  void divide_inside(const Facet& facet, const Sides& side, int depth);
  void divide_two(const Facet& facet, const Sides& side, const Facet& middle, int depth);

  const FacetPatch& patch_;
  std::array<EdgeCuts, 3> cuts_;
  std::array<Vec2, 3> corner_;
  double smallest_side_;
  std::vector<Barycentric> point_;
  std::vector<int> edge_step_;  ///< of points on edges; entries of corners are unused
  std::array<std::size_t, 4> first_on_edge_{};
  std::unordered_map<std::uint64_t, std::uint32_t> middle_;  ///< of inner sides
  std::vector<Facet> facet_;
};

}  // namespace sfumato::outputs
