#include "raster/clip.hpp"

#include <algorithm>
#include <cmath>

namespace sfumato::raster {
namespace {

constexpr Coverage kWholePixel{1, {0.5, 0.5}};

/// A square cut by three half-planes has at most seven corners; where rounding of far-away numbers
/// makes signs flicker, each cut grows it by half: 4, 6, 9, 13.
constexpr int kMostCorners = 13;

struct Polygon {
  Vec2 corner[kMostCorners];
  int count = 0;

  void add(Vec2 p) { corner[count++] = p; }
};

/// Keeps what lies in the half-plane; `origin` is the frame of the polygon.
void cut(const HalfPlane& plane, Vec2 origin, const Polygon& in, Polygon* out) {
  const Vec2 base = origin - plane.point;
  double distance[kMostCorners];
  for (int i = 0; i < in.count; ++i) distance[i] = dot(plane.normal, in.corner[i] + base);
  out->count = 0;
  for (int i = 0; i < in.count; ++i) {
    const int next = i + 1 < in.count ? i + 1 : 0;
    if (distance[i] > 0) out->add(in.corner[i]);
    if ((distance[i] > 0) == (distance[next] > 0)) continue;
    const double t = distance[i] / (distance[i] - distance[next]);
    out->add(lerp(in.corner[i], in.corner[next], t));
  }
}

/// Area and centroid by the fan of the first corner.
Coverage measure(const Polygon& polygon) {
  Coverage sum;
  for (int i = 2; i < polygon.count; ++i) {
    const Vec2 a = polygon.corner[i - 1] - polygon.corner[0];
    const Vec2 b = polygon.corner[i] - polygon.corner[0];
    const double area = 0.5 * cross(a, b);
    sum.area += area;
    sum.centroid = sum.centroid + (a + b) * area;
  }
  if (!(sum.area > 0)) return {};
  sum.centroid = polygon.corner[0] + sum.centroid / (3 * sum.area);
  return sum;
}

bool inside_pixel(const ClipTriangle& triangle, Vec2 origin) {
  for (const Vec2& p : triangle.corner) {
    if (p.x < origin.x || p.y < origin.y || p.x > origin.x + 1 || p.y > origin.y + 1) return false;
  }
  return true;
}

Coverage whole_triangle(const ClipTriangle& triangle, Vec2 origin) {
  Polygon polygon;
  for (const Vec2& p : triangle.corner) polygon.add(p - origin);
  return measure(polygon);
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

Coverage pixel_coverage(const ClipTriangle& triangle, int x, int y) {
  const Vec2 origin{static_cast<double>(x), static_cast<double>(y)};
  const HalfPlane* cutting[3];
  int cutting_count = 0;
  for (const HalfPlane& plane : triangle.edge) {
    const double distance = dot(plane.normal, origin + Vec2{0.5, 0.5} - plane.point);
    if (distance <= -plane.reach) return {};
    if (distance < plane.reach) cutting[cutting_count++] = &plane;
  }
  if (cutting_count == 0) return kWholePixel;
  if (cutting_count == 3 && inside_pixel(triangle, origin)) return whole_triangle(triangle, origin);
  Polygon polygon[2];
  for (const Vec2& p : {Vec2{0, 0}, Vec2{1, 0}, Vec2{1, 1}, Vec2{0, 1}}) polygon[0].add(p);
  for (int i = 0; i < cutting_count; ++i)
    cut(*cutting[i], origin, polygon[i & 1], &polygon[(i + 1) & 1]);
  return measure(polygon[cutting_count & 1]);
}

}  // namespace sfumato::raster
