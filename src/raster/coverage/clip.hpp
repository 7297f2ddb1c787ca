#pragma once

#include "sfumato/base/vec2.hpp"

namespace sfumato::raster {

/// The part of a pixel that lies in a triangle.
struct Coverage {
  double area = 0;  ///< 0 to 1 pixel
  Vec2 centroid;    ///< from the pixel's upper left corner; meaningless where area is 0
};

/// The inside of a triangle's edge: the points where dot(normal, p - point) > 0.
struct HalfPlane {
  Vec2 normal;
  Vec2 point;
  double reach = 0;  ///< |dot(normal, p)| for p from a pixel's centre to its farthest corner
};

/// A triangle in pixels, prepared for cutting by pixels.
struct ClipTriangle {
  Vec2 corner[3];
  HalfPlane edge[3];
};

/// Prepares a triangle. Its corners become clockwise on the screen: cross(01, 02) >= 0.
ClipTriangle clip_triangle(Vec2 corner0, Vec2 corner1, Vec2 corner2);

/// Returns the coverage of a triangle that lies in pixel (x, y), its corners clockwise on the
/// screen.
Coverage whole_coverage(Vec2 corner0, Vec2 corner1, Vec2 corner2, int x, int y);

/// Returns the coverage of one pixel, exact up to rounding: the areas in one pixel of all triangles
/// of a triangulation sum to 1 within 1e-12.
Coverage pixel_coverage(const ClipTriangle& triangle, int x, int y);

}  // namespace sfumato::raster
