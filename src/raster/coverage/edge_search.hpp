#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "base/largest_scale.hpp"
#include "raster/coverage/bow_shape.hpp"
#include "raster/coverage/soft_strip.hpp"
#include "raster/kernels/tile.hpp"

namespace sfumato::raster {

/// Finds the SoftEdges or CurveBows of triangles, which are queried in increasing order.
template <class Edge>
class EdgeSearch {
 public:
  EdgeSearch(const LayerView& layer, std::span<const Edge> edges)
      : is_curve_(layer.edge_is_curve), rest_(edges) {}

  std::span<const Edge> of(std::uint32_t triangle) {
    const std::uint8_t* is_curve = is_curve_ + std::size_t{3} * triangle;
    if (rest_.empty() || !(is_curve[0] | is_curve[1] | is_curve[2])) return {};
    skip_before(triangle);
    std::size_t count = 0;
    while (count < rest_.size() && painting_triangle(rest_[count]) == triangle) ++count;
    return rest_.first(count);
  }

 private:
  /// Skips in steps that double: the next one is near, or far where a tile shows little of a layer.
  void skip_before(std::uint32_t triangle) {
    std::size_t reach = 1;
    while (reach < rest_.size() && painting_triangle(rest_[reach - 1]) < triangle) reach *= 2;
    const auto near = rest_.first(std::min(reach, rest_.size()));
    const auto found = std::ranges::lower_bound(near, triangle, {}, painting_triangle<Edge>);
    rest_ = rest_.subspan(static_cast<std::size_t>(found - near.begin()));
  }

  const std::uint8_t* is_curve_;
  std::span<const Edge> rest_;
};

inline EdgeSearch<SoftEdge> soft_edges_of(const LayerView& layer) {
  return {layer, {layer.soft_edge, layer.soft_edge_count}};
}

inline EdgeSearch<CurveBow> bows_of(const LayerView& layer) {
  return {layer, {layer.bow, layer.bow_count}};
}

/// Finds the bows that show where the layer is placed in the image.
class BowSight {
 public:
  explicit BowSight(const LayerView& layer)
      : least_height_(kLeastBowPx / largest_scale(layer.image_from_layer)) {}

  bool operator()(const CurveBow& bow) const { return largest_height(bow) > least_height_; }

 private:
  double least_height_;  ///< in the layer's frame
};

/// Returns the outline of all strips of a soft edge.
inline std::array<Vec2, 4> outline(const SoftStrip& strip) {
  constexpr double kReach = kStripReach[kStrips - 1];
  const auto& end = strip.edge.end;
  return {end[0], end[1], end[1] + strip.reach[1] * kReach, end[0] + strip.reach[0] * kReach};
}

}  // namespace sfumato::raster
