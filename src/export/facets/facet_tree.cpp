#include "export/facets/facet_tree.hpp"

#include <algorithm>
#include <utility>

namespace sfumato::outputs {
namespace {

/// Divisions within each other, more than sides allow.
constexpr int kMostDepth = 20;

Barycentric middle_of(const Barycentric& a, const Barycentric& b) {
  return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
}

}  // namespace

FacetTree::FacetTree(const FacetPatch& patch, const std::array<EdgeCuts, 3>& cuts,
                     const std::array<Vec2, 3>& corner, double smallest_side)
    : patch_(patch), cuts_(cuts), corner_(corner), smallest_side_(smallest_side) {
  point_ = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  edge_step_.assign(3, 0);
  add_edge_points();
  divide({0, 1, 2}, {0, 1, 2}, 0);
}

void FacetTree::add_edge_points() {
  for (std::size_t k = 0; k < 3; ++k) {
    first_on_edge_[k] = point_.size();
    for (int step = 1; step < kEdgeSteps; ++step) {
      const int counted = cuts_[k].is_reversed ? kEdgeSteps - step : step;
      if ((cuts_[k].steps >> counted & 1) == 0) continue;
      Barycentric at{};
      at[(k + 1) % 3] = 1.0 * step / kEdgeSteps;
      at[k] = 1.0 * (kEdgeSteps - step) / kEdgeSteps;
      point_.push_back(at);
      edge_step_.push_back(step);
    }
  }
  first_on_edge_[3] = point_.size();
}

int FacetTree::step_on_edge(std::uint32_t point, int edge) const {
  if (point >= 3) return edge_step_[point];
  return static_cast<int>(point) == edge ? 0 : kEdgeSteps;
}

std::uint32_t FacetTree::midpoint_on_edge(std::uint32_t a, std::uint32_t b, int edge) const {
  const int sum = step_on_edge(a, edge) + step_on_edge(b, edge);
  if (sum % 2 != 0) return kNone;
  const auto begin = edge_step_.begin() + static_cast<std::ptrdiff_t>(first_on_edge_[edge]);
  const auto end = edge_step_.begin() + static_cast<std::ptrdiff_t>(first_on_edge_[edge + 1]);
  const auto found = std::lower_bound(begin, end, sum / 2);
  if (found == end || *found != sum / 2) return kNone;
  return static_cast<std::uint32_t>(found - edge_step_.begin());
}

/// Returns whether a side is long enough. The bound is a little shorter than the parts of cut
/// edges, to allow centroids.
bool FacetTree::may_halve(std::uint32_t a, std::uint32_t b) const {
  if (side_length(point_[a], point_[b]) * patch_.most_cuts() < 1.8) return false;
  Vec2 side;
  for (std::size_t k = 0; k < 3; ++k) side = side + corner_[k] * (point_[b][k] - point_[a][k]);
  return !(length(side) < 2 * smallest_side_);
}

/// Returns the point that halves a side; kNone where the side stays as it is.
std::uint32_t FacetTree::midpoint(std::uint32_t a, std::uint32_t b, int edge) {
  if (edge != kInner) return midpoint_on_edge(a, b, edge);
  if (a > b) std::swap(a, b);
  const auto [place, is_new] = middle_.try_emplace(std::uint64_t{a} << 32 | b, kNone);
  if (!is_new) return place->second;
  if (!may_halve(a, b) || patch_.is_straight(point_[a], point_[b])) return kNone;
  place->second = static_cast<std::uint32_t>(point_.size());
  point_.push_back(middle_of(point_[a], point_[b]));
  return place->second;
}

/// Straight sides. A patch may still rise between them; then three around the centroid.
void FacetTree::divide_inside(const Facet& facet, const Sides& side, int depth) {
  const auto [a, b, c] = facet;
  const bool may_divide = may_halve(a, b) && may_halve(b, c) && may_halve(c, a);
  if (!may_divide || depth >= kMostDepth || patch_.is_flat({point_[a], point_[b], point_[c]}))
    return facet_.push_back(facet);
  const auto inside = static_cast<std::uint32_t>(point_.size());
  point_.push_back(centroid(point_[a], point_[b], point_[c]));
  for (std::size_t k = 0; k < 3; ++k)
    divide({facet[k], facet[(k + 1) % 3], inside}, {side[k], kInner, kInner}, depth + 1);
}

/// All sides but the first are halved: the triangle that the two share, and a quadrangle along the
/// diagonal that bends less.
void FacetTree::divide_two(const Facet& facet, const Sides& side, const Facet& middle, int depth) {
  const auto [a, b, c] = facet;
  const std::uint32_t bc = middle[1], ca = middle[2];
  divide({bc, c, ca}, {side[1], side[2], kInner}, depth);
  if (patch_.bend(point_[a], point_[bc]) <= patch_.bend(point_[b], point_[ca])) {
    divide({a, bc, ca}, {kInner, kInner, side[2]}, depth);
    divide({a, b, bc}, {side[0], side[1], kInner}, depth);
  } else {
    divide({b, bc, ca}, {side[1], kInner, kInner}, depth);
    divide({a, b, ca}, {side[0], kInner, side[2]}, depth);
  }
}

void FacetTree::divide(const Facet& facet, const Sides& side, int depth) {
  Facet middle;
  int halved = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    middle[k] = midpoint(facet[k], facet[(k + 1) % 3], side[k]);
    halved += middle[k] != kNone;
  }
  if (halved == 0 || depth >= kMostDepth) return divide_inside(facet, side, depth);
  ++depth;
  if (halved == 3) {
    const auto [a, b, c] = facet;
    const auto [ab, bc, ca] = middle;
    divide({a, ab, ca}, {side[0], kInner, side[2]}, depth);
    divide({ab, bc, ca}, {kInner, kInner, kInner}, depth);
    divide({ab, b, bc}, {side[0], side[1], kInner}, depth);
    divide({ca, bc, c}, {kInner, side[1], side[2]}, depth);
    return;
  }
  // Turned so that the side that is alone, halved or not, comes first.
  std::size_t k = 0;
  while ((middle[k] != kNone) != (halved == 1)) ++k;
  const std::size_t next = (k + 1) % 3, last = (k + 2) % 3;
  const Facet turned{facet[k], facet[next], facet[last]};
  const Sides sides{side[k], side[next], side[last]};
  if (halved == 2) return divide_two(turned, sides, {kNone, middle[next], middle[last]}, depth);
  divide({turned[0], middle[k], turned[2]}, {sides[0], kInner, sides[2]}, depth);
  divide({middle[k], turned[1], turned[2]}, {sides[0], sides[1], kInner}, depth);
}

}  // namespace sfumato::outputs
