#include "gather/scene/locate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"
#include "base/try.hpp"
#include "sfumato/base/box.hpp"

namespace sfumato::gather {
namespace {

constexpr std::size_t kChunk = 512;

/// Differences of floats are exact in double, and their products nearly so.
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

/// Searches all triangles. Used where a walk does not end: rounding may have inverted thin
/// triangles.
std::uint32_t search_all(std::span<const SceneTriangle> triangles, float x, float y) {
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (contains(triangles[t], x, y)) return static_cast<std::uint32_t>(t);
  }
  return 0;
}

/// Crosses the edge that has the point farthest on its other side, where there is a triangle.
std::uint32_t walk(std::span<const SceneTriangle> triangles, std::uint32_t start, float x,
                   float y) {
  std::uint32_t t = start;
  const std::size_t step_limit = triangles.size() + 64;
  for (std::size_t step = 0; step < step_limit; ++step) {
    const SceneTriangle& triangle = triangles[t];
    double farthest = 0;
    std::int32_t exit = -1;
    for (int k = 0; k < 3; ++k) {
      const double side = side_of_edge(triangle, k, x, y);
      const bool leads_nearer = side < farthest && triangle.twin[k] >= 0;
      farthest = leads_nearer ? side : farthest;
      exit = leads_nearer ? triangle.twin[k] : exit;
    }
    if (exit < 0) return t;
    t = static_cast<std::uint32_t>(exit) / 3;
  }
  return search_all(triangles, x, y);
}

// Moves a point off a corner, a thousandth of the triangle inwards. On a corner it would see two
// edges under angle 0, and rounding would decide which triangles it sees.
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
  // About one triangle to a cell.
  const double side = std::sqrt(static_cast<double>(scene.triangle.size()));
  locator.side_ = static_cast<int>(std::clamp(side, 1.0, 2048.0));
  const auto row_cells = static_cast<std::size_t>(locator.side_);
  SFUMATO_TRY(locator.memory_.resize(context, locator.cell_triangle_, row_cells * row_cells));
  locator.min_x_ = static_cast<float>(box.min.x);
  locator.min_y_ = static_cast<float>(box.min.y);
  const auto per_unit = [&](double length) {
    return length > 0 ? static_cast<float>(locator.side_ / length) : 0.0f;
  };
  locator.cells_per_unit_x_ = per_unit(box.width());
  locator.cells_per_unit_y_ = per_unit(box.height());
  const double width = box.width() / locator.side_, height = box.height() / locator.side_;
  SFUMATO_TRY(parallel_for(context, row_cells, 8, [&](std::size_t begin, std::size_t end) {
    std::uint32_t t = 0;
    for (std::size_t i = begin * row_cells; i < end * row_cells; ++i) {
      const auto x =
          static_cast<float>(box.min.x + (static_cast<double>(i % row_cells) + 0.5) * width);
      const auto y =
          static_cast<float>(box.min.y + (static_cast<double>(i / row_cells) + 0.5) * height);
      t = walk(scene.triangle, t, x, y);
      locator.cell_triangle_[i] = t;
    }
  }));
  return locator;
}

Result<Locator> Locator::extend(Context& context, const Locator& before, const Scene& scene) {
  Locator locator;
  SFUMATO_TRY(locator.memory_.append(context, before.cell_triangle_, locator.cell_triangle_));
  locator.scene_ = &scene;
  locator.min_x_ = before.min_x_, locator.min_y_ = before.min_y_;
  locator.cells_per_unit_x_ = before.cells_per_unit_x_;
  locator.cells_per_unit_y_ = before.cells_per_unit_y_;
  locator.side_ = before.side_;
  return locator;
}

std::uint32_t Locator::start_triangle(float x, float y) const {
  const auto side = static_cast<std::size_t>(side_);
  return cell_triangle_[cell_of(y - min_y_, cells_per_unit_y_, side_) * side +
                        cell_of(x - min_x_, cells_per_unit_x_, side_)];
}

Result<LocatedPoints> Locator::locate(Context& context, const PointList& points) const {
  LocatedPoints located;
  SFUMATO_TRY(
      located.memory.resize_all(context, points.size(), located.x, located.y, located.triangle));
  SFUMATO_TRY(parallel_for(context, points.size(), kChunk, [&](std::size_t begin, std::size_t end) {
    float last_x = std::numeric_limits<float>::infinity(), last_y = 0;
    std::uint32_t t = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const Vec2 point = points[i] - scene_->origin;
      auto x = static_cast<float>(point.x), y = static_cast<float>(point.y);
      const float cells_away = std::max(std::fabs(x - last_x) * cells_per_unit_x_,
                                        std::fabs(y - last_y) * cells_per_unit_y_);
      if (!(cells_away < 1)) t = start_triangle(x, y);
      t = walk(scene_->triangle, t, x, y);
      last_x = x, last_y = y;
      leave_corner(scene_->triangle[t], x, y);
      located.x[i] = x;
      located.y[i] = y;
      located.triangle[i] = t;
    }
  }));
  return located;
}

}  // namespace sfumato::gather
