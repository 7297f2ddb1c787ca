#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "picture/patch.hpp"
#include "raster/coverage/bends.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/picture/picture.hpp"

/// A readable rasterizer: pixel by pixel, triangle by triangle, in double precision. It shares with
/// the fast path only the decision which triangles are bent.
namespace sfumato::test {

struct ReferencePixel {
  std::array<double, 3> color{};
  bool covered = false;
  bool mixed = false;       ///< a curve passes through the pixel
  bool small = false;       ///< may bend within a pixel
  double covered_area = 0;  ///< sum over all triangles in the pixel
  int centers = 0;          ///< triangles that hold the pixel's centre in their interior
};

struct ReferenceTriangle {
  bool small = false;          ///< may bend within a pixel
  std::array<Vec2, 3> corner;  ///< pixels, clockwise on the screen
  std::array<bool, 3> curve;   ///< edge k from corner k to corner k + 1
  std::array<std::array<double, 3>, kNodesPerTriangle> node;
  PatchOrder order = PatchOrder::cubic;

  /// Returns the patch at a point, through the basis of eq. 17–18.
  std::array<double, 3> color(Vec2 p) const {
    const double whole = cross(corner[1] - corner[0], corner[2] - corner[0]);
    const double u = cross(p - corner[0], corner[2] - corner[0]) / whole;
    const double v = cross(corner[1] - corner[0], p - corner[0]) / whole;
    const auto basis = patch_basis(order, 1 - u - v, u, v);
    std::array<double, 3> sum{};
    for (int i = 0; i < kNodesPerTriangle; ++i)
      for (int c = 0; c < 3; ++c) sum[c] += basis[i] * node[i][c];
    return sum;
  }

  bool holds(Vec2 p) const {
    for (int k = 0; k < 3; ++k)
      if (cross(corner[(k + 1) % 3] - corner[k], p - corner[k]) <= 0) return false;
    return true;
  }
};

/// Returns the triangles of a picture's only layer, under a similarity without mirroring.
inline std::vector<ReferenceTriangle> reference_triangles(const Picture& picture, Box viewport,
                                                          int width, int height) {
  const PatchLayer& layer = picture.layers[std::get<PatchInstance>(picture.stack[0]).layer];
  const Affine& artboard_from_layer = std::get<PatchInstance>(picture.stack[0]).artboard_from_layer;
  std::vector<ReferenceTriangle> triangles(layer.triangle_count());
  Context context;
  TableMemory memory("marks of triangles");
  const std::vector<std::uint8_t> is_bent = *raster::bent_triangles(context, layer, memory);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    triangles[t].order = layer.order;
    for (int k = 0; k < 3; ++k) {
      const Vec2 p = artboard_from_layer(layer.vertex_position[layer.triangle_vertex[3 * t + k]]);
      triangles[t].corner[k] = {(p.x - viewport.min.x) * (width / viewport.width()),
                                (p.y - viewport.min.y) * (height / viewport.height())};
      triangles[t].curve[k] = layer.edge_is_curve[3 * t + k] != 0;
    }
    triangles[t].small = is_bent[t] != 0;
    for (int k = 0; k < 3; ++k) {
      const Vec2 edge = triangles[t].corner[(k + 1) % 3] - triangles[t].corner[k];
      triangles[t].small &= length(edge) <= 3;
    }
    for (int i = 0; i < kNodesPerTriangle; ++i)
      for (int c = 0; c < 3; ++c)
        triangles[t].node[i][c] =
            layer.color.node_value[3 * layer.color.triangle_node[node_slot(t, i)] + c];
  }
  return triangles;
}

/// Returns the part of the polygon where dot(normal, p) < offset.
inline std::vector<Vec2> cut_polygon(const std::vector<Vec2>& polygon, Vec2 normal, double offset) {
  std::vector<Vec2> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    const double da = dot(normal, a) - offset, db = dot(normal, b) - offset;
    if (da < 0) kept.push_back(a);
    if ((da < 0) != (db < 0)) kept.push_back(a + (b - a) * (da / (da - db)));
  }
  return kept;
}

inline std::vector<Vec2> part_in_square(const ReferenceTriangle& triangle, double x, double y,
                                        double side) {
  std::vector<Vec2> polygon(triangle.corner.begin(), triangle.corner.end());
  polygon = cut_polygon(polygon, {-1, 0}, -x);
  polygon = cut_polygon(polygon, {1, 0}, x + side);
  polygon = cut_polygon(polygon, {0, -1}, -y);
  return cut_polygon(polygon, {0, 1}, y + side);
}

inline std::vector<Vec2> part_in_pixel(const ReferenceTriangle& triangle, int x, int y) {
  return part_in_square(triangle, x, y, 1);
}

inline bool segment_meets_pixel(Vec2 a, Vec2 b, int x, int y) {
  double t0 = 0, t1 = 1;
  const Vec2 d = b - a;
  const double entry[4][2] = {
      {-d.x, a.x - x}, {d.x, x + 1 - a.x}, {-d.y, a.y - y}, {d.y, y + 1 - a.y}};
  for (const auto& [rate, room] : entry) {
    if (rate == 0 && room < 0) return false;
    if (rate < 0) t0 = std::max(t0, room / rate);
    if (rate > 0) t1 = std::min(t1, room / rate);
  }
  return t0 <= t1;
}

inline ReferencePixel reference_pixel(const std::vector<ReferenceTriangle>& triangles, int x,
                                      int y) {
  ReferencePixel pixel;
  std::array<double, 3> mean{};
  for (const ReferenceTriangle& triangle : triangles) {
    for (int k = 0; k < 3; ++k) {
      pixel.mixed |= triangle.curve[k] &&
                     segment_meets_pixel(triangle.corner[k], triangle.corner[(k + 1) % 3], x, y);
    }
    // Small triangles are evaluated in each quarter of the pixel.
    const int squares = triangle.small ? 2 : 1;
    for (int square = 0; square < squares * squares; ++square) {
      const double side = 1.0 / squares;
      const std::vector<Vec2> part = part_in_square(triangle, x + side * (square % squares),
                                                    y + side * (square / squares), side);
      double area = 0;
      Vec2 moment;
      for (std::size_t i = 2; i < part.size(); ++i) {
        const double piece = cross(part[i - 1] - part[0], part[i] - part[0]) / 2;
        area += piece;
        moment = moment + (part[0] + part[i - 1] + part[i]) * (piece / 3);
      }
      if (!(area > 0)) continue;
      const auto color = triangle.color(moment / area);
      for (int c = 0; c < 3; ++c) mean[c] += area * color[c];
      pixel.covered_area += area;
      pixel.mixed |= triangle.small;
    }
    const Vec2 center{x + 0.5, y + 0.5};
    if (!triangle.holds(center)) continue;
    ++pixel.centers;
    pixel.covered = true;
    pixel.color = triangle.color(center);
  }
  if (pixel.mixed && pixel.covered_area > 0.5) {
    pixel.covered = true;
    for (int c = 0; c < 3; ++c) pixel.color[c] = mean[c] / pixel.covered_area;
  }
  for (double& c : pixel.color) c = std::clamp(c, 0.0, 1.0);
  return pixel;
}

}  // namespace sfumato::test
