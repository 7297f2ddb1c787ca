#pragma once

#include "base/lane_register.hpp"
#include "raster/kernels/tile.hpp"

/// A triangle in the image and the coordinates for evaluating its patch. Compiled for every
/// instruction set: uses only operators, and no function whose copies the linker could merge.
///
/// Corners are sorted by y: top, middle, bottom; the long edge joins top and bottom. A point is (u,
/// q): u is the barycentric weight of the middle corner, which is 0 on the long edge, q runs from 0
/// at the top's y to 1 at the bottom's. Along a row of pixels q is constant and u affine in x, and
/// both stay in [0, 1] for triangles of any shape, so that single precision suffices.
namespace sfumato::raster::inline SFUMATO_ISA {

struct TriangleFrame {
  double top_x, top_y, middle_x, middle_y, bottom_x, bottom_y;
  double long_slope, upper_slope, lower_slope;  ///< dx/dy of top-bottom, top-middle, middle-bottom
  double inverse_height;                        ///< q per pixel of y
  double inverse_width;                         ///< u per pixel of x
  double middle_q;
  int corner_order;      ///< 3 top + middle, each one of the triangle's corners 0, 1, 2
  bool middle_on_right;  ///< of the long edge; from the winding, not from rounded numbers

  SFUMATO_INLINE double long_edge_x(double y) const { return top_x + (y - top_y) * long_slope; }
  /// Returns x on the other side of the triangle, from top over middle to bottom.
  SFUMATO_INLINE double short_edges_x(double y) const {
    return y < middle_y ? top_x + (y - top_y) * upper_slope
                        : middle_x + (y - middle_y) * lower_slope;
  }
};

/// A frame for barycentric coordinates: a point of any triangle is given by weights of corners, u
/// of corner 1, q of corner 2.
inline constexpr TriangleFrame kBarycentricFrame{0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0, 1, true};

/// Returns dx/dy of an edge from its upper to its lower end: both triangles at an edge get the same
/// bits. 0 for a horizontal edge, which no row of pixel centres crosses.
SFUMATO_INLINE double slope(double dx, double dy) {
  return dy > 0 ? dx / dy : 0;
}

struct PixelPoint {
  double x, y;
};

SFUMATO_INLINE PixelPoint corner_position(const LayerView& layer, std::uint32_t triangle,
                                          int corner) {
  const Vec2& p = layer.vertex_position[layer.triangle_vertex[3 * triangle + corner]];
  const Affine& m = layer.image_from_layer;
  return {m.a * p.x + m.c * p.y + m.e, m.b * p.x + m.d * p.y + m.f};
}

SFUMATO_INLINE TriangleFrame triangle_frame(const PixelPoint (&corner)[3], bool mirrored) {
  const int rank0 = (corner[1].y < corner[0].y) + (corner[2].y < corner[0].y);
  const int rank1 = (corner[0].y <= corner[1].y) + (corner[2].y < corner[1].y);
  int at[3];
  at[rank0] = 0;
  at[rank1] = 1;
  at[3 - rank0 - rank1] = 2;
  const PixelPoint &top = corner[at[0]], &middle = corner[at[1]], &bottom = corner[at[2]];

  TriangleFrame f{top.x, top.y, middle.x, middle.y, bottom.x, bottom.y, 0, 0, 0, 0, 0, 0, 0, false};
  const double height = bottom.y - top.y;
  f.long_slope = slope(bottom.x - top.x, height);
  f.upper_slope = slope(middle.x - top.x, middle.y - top.y);
  f.lower_slope = slope(bottom.x - middle.x, bottom.y - middle.y);
  f.inverse_height = slope(1, height);
  f.middle_q = (middle.y - top.y) * f.inverse_height;
  f.corner_order = 3 * at[0] + at[1];
  f.middle_on_right = (at[1] == (at[0] == 2 ? 0 : at[0] + 1)) != mirrored;
  // The bound for triangles too thin to be distinguished from a line: u stays 0, which gives the
  // colour of the long edge.
  constexpr double kThinnest = 1e-12;
  const double width = middle.x - f.long_edge_x(middle.y);
  const double outward = f.middle_on_right ? width : -width;
  f.inverse_width = outward > kThinnest ? 1 / width : 0;
  return f;
}

SFUMATO_INLINE double clamp_unit(double x) {
  const double low = x > 0 ? x : 0;
  return low < 1 ? low : 1;
}

}  // namespace sfumato::raster::inline SFUMATO_ISA
