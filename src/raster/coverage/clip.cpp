#include "raster/coverage/clip.hpp"

#include <cmath>
#include <utility>

namespace sfumato::raster {
namespace {

constexpr Coverage kWholePixel{1, {0.5, 0.5}};

/// A square cut by three half-planes has at most seven corners. Where rounding of far-away numbers
/// makes signs inconsistent, each cut adds half: 4, 6, 9, 13.
constexpr int kMostCorners = 13;

struct Polygon {
  double x[kMostCorners], y[kMostCorners];  // only `count` of them are ever written
  int count = 0;

  Vec2 corner(int i) const { return {x[i], y[i]}; }
  void add(Vec2 p) {
    x[count] = p.x;
    y[count++] = p.y;
  }
};

/// Cuts off the polygon outside of the half-plane; `origin` is the frame of the polygon.
void cut(const HalfPlane& plane, Vec2 origin, const Polygon& in, Polygon* out) {
  const Vec2 base = origin - plane.point;
  double distance[kMostCorners];
  for (int i = 0; i < in.count; ++i) distance[i] = dot(plane.normal, in.corner(i) + base);
  out->count = 0;
  for (int i = 0; i < in.count; ++i) {
    const int next = i + 1 < in.count ? i + 1 : 0;
    if (distance[i] > 0) out->add(in.corner(i));
    if ((distance[i] > 0) == (distance[next] > 0)) continue;
    const double t = distance[i] / (distance[i] - distance[next]);
    out->add(lerp(in.corner(i), in.corner(next), t));
  }
}

/// Computes area and centroid by the fan of the first corner.
Coverage measure(const Polygon& polygon) {
  Coverage sum;
  for (int i = 2; i < polygon.count; ++i) {
    const Vec2 a = polygon.corner(i - 1) - polygon.corner(0);
    const Vec2 b = polygon.corner(i) - polygon.corner(0);
    const double area = 0.5 * cross(a, b);
    sum.area += area;
    sum.centroid = sum.centroid + (a + b) * area;
  }
  if (!(sum.area > 0)) return {};
  sum.centroid = polygon.corner(0) + sum.centroid / (3 * sum.area);
  return sum;
}

/// Cuts the pixel by one half-plane, in closed form. `distance` is that of the pixel's centre. The
/// normal (a, b) is turned until a >= b >= 0. Then the corners (0, 0), (0, 1), (1, 0), (1, 1) are
/// in the order of their distances, and the part contains the last one, two or three of them.
Coverage cut_pixel(Vec2 normal, double distance) {
  double a = std::fabs(normal.x);
  double b = std::fabs(normal.y);
  const bool swapped = a < b;
  if (swapped) std::swap(a, b);
  const double at10 = distance + 0.5 * (a - b);
  const double at01 = distance - 0.5 * (a - b);
  Coverage part;
  if (at10 <= 0) {  // a triangle at (1, 1)
    const double x = (distance + 0.5 * (a + b)) / a;
    const double y = (distance + 0.5 * (a + b)) / b;
    part = {0.5 * x * y, {1 - x / 3, 1 - y / 3}};
  } else if (at01 <= 0) {  // a trapezoid at x = 1
    const double top = at10 / a;
    const double bottom = (at10 + b) / a;
    const double both = top + bottom;
    part = {0.5 * both,
            {1 - (top * top + top * bottom + bottom * bottom) / (3 * both),
             (top + 2 * bottom) / (3 * both)}};
  } else {  // all except a triangle at (0, 0)
    const double x = (0.5 * (a + b) - distance) / a;
    const double y = (0.5 * (a + b) - distance) / b;
    const double missing = 0.5 * x * y;
    part.area = 1 - missing;
    part.centroid = Vec2{0.5 - missing * x / 3, 0.5 - missing * y / 3} / part.area;
  }
  if (swapped) std::swap(part.centroid.x, part.centroid.y);
  if (normal.x < 0) part.centroid.x = 1 - part.centroid.x;
  if (normal.y < 0) part.centroid.y = 1 - part.centroid.y;
  return part;
}

bool inside_pixel(const ClipTriangle& triangle, Vec2 origin) {
  for (const Vec2& p : triangle.corner) {
    if (p.x < origin.x || p.y < origin.y || p.x > origin.x + 1 || p.y > origin.y + 1) return false;
  }
  return true;
}

}  // namespace

ClipTriangle clip_triangle(Vec2 corner0, Vec2 corner1, Vec2 corner2) {
  ClipTriangle triangle{{corner0, corner1, corner2}, {}};
  for (int k = 0; k < 3; ++k) {
    const Vec2 along = triangle.corner[(k + 1) % 3] - triangle.corner[k];
    const Vec2 normal{-along.y, along.x};
    triangle.edge[k] = {normal, triangle.corner[k],
                        0.5 * (std::fabs(normal.x) + std::fabs(normal.y))};
  }
  return triangle;
}

Coverage whole_coverage(Vec2 corner0, Vec2 corner1, Vec2 corner2, int x, int y) {
  const Vec2 a = corner1 - corner0, b = corner2 - corner0;
  const double area = 0.5 * cross(a, b);
  if (!(area > 0)) return {};
  const Vec2 origin{static_cast<double>(x), static_cast<double>(y)};
  return {area, corner0 - origin + (a + b) / 3};
}

Coverage pixel_coverage(const ClipTriangle& triangle, int x, int y) {
  const Vec2 origin{static_cast<double>(x), static_cast<double>(y)};
  const HalfPlane* cutting[3];
  double cutting_distance = 0;
  int cutting_count = 0;
  for (const HalfPlane& plane : triangle.edge) {
    const double distance = dot(plane.normal, origin + Vec2{0.5, 0.5} - plane.point);
    if (distance <= -plane.reach) return {};
    if (distance >= plane.reach) continue;
    cutting[cutting_count++] = &plane;
    cutting_distance = distance;
  }
  if (cutting_count == 0) return kWholePixel;
  if (cutting_count == 1) return cut_pixel(cutting[0]->normal, cutting_distance);
  if (cutting_count == 3 && inside_pixel(triangle, origin)) {
    const auto& corner = triangle.corner;
    return whole_coverage(corner[0], corner[1], corner[2], x, y);
  }
  Polygon polygon[2];
  for (const Vec2& p : {Vec2{0, 0}, Vec2{1, 0}, Vec2{1, 1}, Vec2{0, 1}}) polygon[0].add(p);
  for (int i = 0; i < cutting_count; ++i)
    cut(*cutting[i], origin, polygon[i & 1], &polygon[(i + 1) & 1]);
  return measure(polygon[cutting_count & 1]);
}

}  // namespace sfumato::raster
