#pragma once

#include "sfumato/base/vec2.hpp"

namespace sfumato::raster {

/// The integrals of dx dy, x dx dy and y dx dy.
struct Moments {
  double area = 0, x = 0, y = 0;

  void add(const Moments& other, double sign) {
    area += sign * other.area;
    x += sign * other.x;
    y += sign * other.y;
  }
};

/// Integrates over the area left of the line from a to b, inside the square [0, 1]²: points outside
/// are moved to the nearest of the square. Summed over a polygon's edges this is the integral over
/// the polygon's part of the square, by Green's theorem: x dy, x² / 2 dy and x y dy along it.
Moments edge_integral(Vec2 a, Vec2 b);

}  // namespace sfumato::raster
