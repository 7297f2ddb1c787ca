#pragma once

#include "raster/coverage/coverage.hpp"

/// The templates of MixedPixels that layers of patches share with layers of exact fields.
namespace sfumato::raster {

inline Color4 without_alpha(const Color4& color) {
  return color * color4(1, 1, 1, 0);
}

/// Calls visit(triangle, place in placed_) for the triangles of a list, one after another.
template <class Visit>
void MixedPixels::for_each_placed(const LayerView& layer, const TriangleList& triangles,
                                  const Tile& tile, const Visit& visit) {
  for (std::size_t first = 0; first < triangles.count; first += PlacedTriangles::kMost) {
    const std::size_t count = std::min(triangles.count - first, PlacedTriangles::kMost);
    kernels_.place_triangles(layer, triangles.triangle + first, count, tile, &placed_);
    for (std::size_t i = 0; i < count; ++i) visit(triangles.triangle[first + i], i);
  }
}

/// Calls visit(x, row, index of its sum) for every marked pixel.
template <class Visit>
void MixedPixels::for_each_marked(const Tile& tile, const Visit& visit) const {
  for (int row = 0; row < tile.height; ++row) {
    marks_.for_each(row, 0, tile.width, [&](int x, std::uint32_t index) { visit(x, row, index); });
  }
}

/// Calls visit(pixel) for the marked pixels of a box in which an edge has a part.
///
/// part_in   part_in(x, y) returns the part of a pixel that changes
template <class PartIn, class Visit>
void MixedPixels::for_each_edge_pixel(const Box& box, const Tile& tile, const PartIn& part_in,
                                      const Visit& visit) const {
  const PixelRange range = pixels_in(box, tile);
  for (int row = range.first_row; row < range.end_row; ++row) {
    marks_.for_each(row, range.begin, range.end, [&](int column, std::uint32_t index) {
      const int x = tile.x0 + column, y = tile.y0 + row;
      const StripPart part = part_in(x, y);
      if (!part.empty()) visit(EdgePixel{index, x, y, part, {}});
    });
  }
}

template <class Shader>
void MixedPixels::change_by_blur(const Shader& shader, const SoftEdge& edge, const EdgePixel& pixel,
                                 Sum& changed) const {
  const Color4 across = Color4(edge.contrast) * (pixel.side[0] - pixel.side[1]);
  // The share of the colour across falls by an eighth from strip to strip.
  const auto shown = [&](int strips_left) {
    return shader.shown(pixel.side[1] + Color4(0.125f * strips_left) * across);
  };
  Color4 sum = Color4::load(changed.edges);
  Color4 inner = shown(kStrips);
  for (int i = 0; i < kStrips; ++i) {
    const Color4 outer = shown(kStrips - 1 - i);
    sum = sum + Color4(pixel.part.area[i]) * (inner - outer);
    inner = outer;
  }
  sum.store(changed.edges);
}

/// Gives the area between an edge and its curve to the side of the curve on which it lies.
template <class Shader>
void MixedPixels::change_by_bow(const Shader& shader, const CurveBow& bow, const EdgePixel& pixel,
                                Sum& sum) const {
  const bool has_front = bow.front != SoftEdge::kNone, has_back = bow.back != SoftEdge::kNone;
  const float area = pixel.part.area[0];
  const Color4 back = shader.shown(pixel.side[0]), front = shader.shown(pixel.side[1]);
  if (has_front && has_back) {
    (Color4::load(sum.edges) + Color4(area) * (back - front)).store(sum.edges);
  } else {
    const float sign = has_back ? 1.0f : -1.0f;
    const float moment[2] = {sign * pixel.part.moment[0], sign * pixel.part.moment[1]};
    sum.add(sign * area, moment, has_back ? back : front);
  }
}

}  // namespace sfumato::raster
