#include "gather/locate.hpp"

#include <algorithm>
#include <cmath>

#include "base/box.hpp"

namespace sfumato::gather {
namespace {

constexpr std::size_t kChunk = 512;
constexpr std::uint32_t kUnset = 0xffffffffu;

/// Differences of floats are exact in double, and nearly so their products.
double side_of_edge(const SceneTriangle& t, int k, float x, float y) {
  const int n = (k + 1) % 3;
  const double ex = double{t.x[n]} - t.x[k], ey = double{t.y[n]} - t.y[k];
  return ex * (double{y} - t.y[k]) - ey * (double{x} - t.x[k]);
}

bool contains(const SceneTriangle& t, float x, float y) {
  for (int k = 0; k < 3; ++k) {
    if (side_of_edge(t, k, x, y) < 0) return false;
  }
  return true;
}

/// The answer where a walk does not end: rounding may have turned thin triangles over.
std::uint32_t search_all(std::span<const SceneTriangle> triangles, float x, float y) {
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (contains(triangles[t], x, y)) return static_cast<std::uint32_t>(t);
  }
  return 0;
}

/// Crosses any edge that has the point on its other side. The edge that is asked first changes
/// from step to step, so that the walk cannot go round for ever.
std::uint32_t walk(std::span<const SceneTriangle> triangles, std::uint32_t start, float x,
                   float y) {
  std::uint32_t t = start;
  std::int32_t entry = -1;
  const std::size_t step_limit = triangles.size() + 64;
  for (std::size_t step = 0; step < step_limit; ++step) {
    const SceneTriangle& triangle = triangles[t];
    std::int32_t exit = -1;
    for (int i = 0; i < 3 && exit < 0; ++i) {
      const int k = static_cast<int>((step + static_cast<std::size_t>(i)) % 3);
      if (triangle.twin[k] < 0 || static_cast<std::int32_t>(3 * t) + k == entry) continue;
      if (side_of_edge(triangle, k, x, y) < 0) exit = triangle.twin[k];
    }
    if (exit < 0) return t;
    entry = exit;
    t = static_cast<std::uint32_t>(exit) / 3;
  }
  return search_all(triangles, x, y);
}

// A point on a corner sees two edges under no angle at all, and which triangles it sees depends on
// rounding: it is moved a thousandth of the triangle inwards.
void leave_corner(const SceneTriangle& t, float& x, float& y) {
  for (int k = 0; k < 3; ++k) {
    if (t.x[k] != x || t.y[k] != y) continue;
    x += ((t.x[0] + t.x[1] + t.x[2]) * (1.0f / 3) - x) * 1e-3f;
    y += ((t.y[0] + t.y[1] + t.y[2]) * (1.0f / 3) - y) * 1e-3f;
    return;
  }
}

std::uint32_t cell_of(float offset, float cells_per_unit, int side) {
  const float cell = offset * cells_per_unit;
  return static_cast<std::uint32_t>(std::clamp(cell, 0.0f, static_cast<float>(side - 1)));
}

}  // namespace

Result<Locator> Locator::create(Context& context, const Scene& scene) {
  Locator locator;
  locator.scene_ = &scene;
  Box box;
  for (const SceneTriangle& t : scene.triangle) {
    for (int k = 0; k < 3; ++k) box.extend({t.x[k], t.y[k]});
  }
  // About four triangles to a cell.
  const double cells = std::sqrt(static_cast<double>(scene.triangle.size())) / 2;
  locator.side_ = static_cast<int>(std::clamp(cells, 1.0, 1024.0));
  const auto side = static_cast<std::size_t>(locator.side_);
  if (Status status = locator.charge_.add(context, side * side * 4, "point location"); !status) {
    return status;
  }
  locator.min_x_ = static_cast<float>(box.min.x);
  locator.min_y_ = static_cast<float>(box.min.y);
  const auto per_unit = [&](double length) {
    return length > 0 ? static_cast<float>(locator.side_ / length) : 0.0f;
  };
  locator.cells_per_unit_x_ = per_unit(box.width());
  locator.cells_per_unit_y_ = per_unit(box.height());
  auto& cell_triangle = locator.cell_triangle_;
  cell_triangle.assign(side * side, kUnset);
  for (std::size_t t = 0; t < scene.triangle.size(); ++t) {
    const SceneTriangle& triangle = scene.triangle[t];
    const float x = (triangle.x[0] + triangle.x[1] + triangle.x[2]) / 3 - locator.min_x_;
    const float y = (triangle.y[0] + triangle.y[1] + triangle.y[2]) / 3 - locator.min_y_;
    cell_triangle[cell_of(y, locator.cells_per_unit_y_, locator.side_) * side +
                  cell_of(x, locator.cells_per_unit_x_, locator.side_)] =
        static_cast<std::uint32_t>(t);
  }
  // Empty cells take the triangle of the cell before them.
  std::uint32_t last = 0;
  for (std::uint32_t& triangle : cell_triangle) {
    if (triangle == kUnset) triangle = last;
    last = triangle;
  }
  return locator;
}

std::uint32_t Locator::start_triangle(float x, float y) const {
  const auto side = static_cast<std::size_t>(side_);
  return cell_triangle_[cell_of(y - min_y_, cells_per_unit_y_, side_) * side +
                        cell_of(x - min_x_, cells_per_unit_x_, side_)];
}

Result<LocatedPoints> Locator::locate(Context& context, std::span<const Vec2> points) const {
  LocatedPoints located;
  const std::size_t bytes = points.size() * (2 * sizeof(float) + sizeof(std::uint32_t));
  if (Status status = located.charge.add(context, bytes, "the points to gather at"); !status) {
    return status;
  }
  located.x.resize(points.size());
  located.y.resize(points.size());
  located.triangle.resize(points.size());
  Status status =
      parallel_for(context, points.size(), kChunk, [&](std::size_t begin, std::size_t end) {
        std::uint32_t t = kUnset;
        for (std::size_t i = begin; i < end; ++i) {
          auto x = static_cast<float>(points[i].x - scene_->origin.x);
          auto y = static_cast<float>(points[i].y - scene_->origin.y);
          t = walk(scene_->triangle, t == kUnset ? start_triangle(x, y) : t, x, y);
          leave_corner(scene_->triangle[t], x, y);
          located.x[i] = x;
          located.y[i] = y;
          located.triangle[i] = t;
        }
      });
  if (!status) return status;
  return located;
}

}  // namespace sfumato::gather
