#pragma once

#include "base/half_edge.hpp"
#include "raster/kernels/tile.hpp"

namespace sfumato::raster {

/// Blurs finer than the pixels that a picture was made for extend farther only where the picture is
/// enlarged; no blur may make a tile test all triangles.
inline constexpr double kMostReachPx = 64;

/// The edge of a SoftEdge or a CurveBow in the image.
struct PaintedEdge {
  Vec2 end[2];  ///< in the direction of the edge of its front
  double
      turn;  ///< 1, or -1 if the layer is mirrored, so that areas on the front's side are positive
};

/// Maps a vector of the layer's frame into the image.
inline Vec2 vector_in_image(const LayerView& layer, Vec2 v) {
  const Affine& m = layer.image_from_layer;
  return {m.a * v.x + m.c * v.y, m.b * v.x + m.d * v.y};
}

/// Returns a corner of a triangle in the layer's frame.
inline Vec2 corner_in_layer(const LayerView& layer, std::uint32_t slot) {
  return layer.vertex_position[layer.triangle_vertex[slot]];
}

/// The slots of an edge's two ends, in the direction of the edge of its front.
struct EdgeSlots {
  std::uint32_t from, to;
};

template <class Edge>
EdgeSlots slots_of(const Edge& edge) {
  if (edge.front != SoftEdge::kNone) return {edge.front, next_half_edge(edge.front)};
  return {next_half_edge(edge.back), edge.back};
}

template <class Edge>
PaintedEdge painted_edge(const LayerView& layer, const Edge& edge) {
  const EdgeSlots slots = slots_of(edge);
  return {{layer.image_from_layer(corner_in_layer(layer, slots.from)),
           layer.image_from_layer(corner_in_layer(layer, slots.to))},
          layer.mirrored ? -1.0 : 1.0};
}

/// Returns the distance in pixels by which a picture's soft edges and bows may extend outside their
/// triangles.
double edge_margin_px(const Picture& picture, const Affine& image_from_artboard);

}  // namespace sfumato::raster
