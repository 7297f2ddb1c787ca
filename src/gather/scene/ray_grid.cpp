#include "gather/scene/ray_grid.hpp"

#include <algorithm>
#include <cmath>

#include "base/try.hpp"
#include "sfumato/base/box.hpp"

namespace sfumato::gather {
namespace {

/// Cells are grown by this share of their size when edges are entered, so that no hit is lost to
/// rounding at joints and borders.
constexpr float kFatten = 1e-3f;
constexpr float kNeverCrossed = std::numeric_limits<float>::infinity();

/// One axis of a walk from cell to cell.
struct AxisWalk {
  int cell;
  int step;
  float next;   ///< distance along the ray to the next cell border
  float delta;  ///< distance from border to border
};

/// Returns the walk from `position` after `distance` along the ray. Positions count from the grid's
/// corner.
AxisWalk start_axis(float position, float direction, float distance, float cell_size, int side) {
  const float here = (position + distance * direction) / cell_size;
  const int cell = static_cast<int>(std::clamp(here, 0.0f, static_cast<float>(side - 1)));
  if (direction == 0) return {cell, 0, kNeverCrossed, kNeverCrossed};
  const int step = direction > 0 ? 1 : -1;
  const float border = static_cast<float>(direction > 0 ? cell + 1 : cell) * cell_size;
  return {cell, step, (border - position) / direction, std::fabs(cell_size / direction)};
}

/// Narrows [enter, leave] to the range where position + t direction lies in [0, size].
void clip_axis(float position, float direction, float size, float& enter, float& leave) {
  if (direction == 0) {
    if (position < 0 || position > size) leave = -1;
    return;
  }
  const float t0 = -position / direction, t1 = (size - position) / direction;
  enter = std::max(enter, std::min(t0, t1));
  leave = std::min(leave, std::max(t0, t1));
}

}  // namespace

Result<std::vector<RayGrid::Wall>> RayGrid::walls_of(Context& context, const Scene& scene,
                                                     TableMemory& memory) {
  std::vector<Wall> walls;
  for (std::size_t t = 0; t < scene.triangle.size(); ++t) {
    const SceneTriangle& triangle = scene.triangle[t];
    SFUMATO_TRY(memory.make_room(context, walls, 3));
    for (int k = 0; k < 3; ++k) {
      const std::int32_t twin = triangle.twin[k];
      const auto half_edge = static_cast<std::int32_t>(3 * t) + k;
      if (twin >= 0 && twin < half_edge) continue;
      const EdgeCode front = triangle.edge[k];
      const EdgeCode back =
          twin < 0 ? kBorder : scene.triangle[static_cast<std::size_t>(twin / 3)].edge[twin % 3];
      // Nothing stops rays at a passage; behind the hull there is nothing to hide.
      if ((front >= 0 && back >= 0) || (twin < 0 && front == kBorder)) continue;
      const int next = (k + 1) % 3;
      walls.push_back(
          {triangle.x[k], triangle.y[k], triangle.x[next], triangle.y[next], front, back});
    }
  }
  return walls;
}

/// Calls body(cell) for every cell that the wall touches when the cell is a little grown.
template <class Body>
void RayGrid::for_each_cell(const Wall& wall, Body body) const {
  const auto clamp_cell = [](float c) {
    return static_cast<int>(std::clamp(c, 0.0f, static_cast<float>(kSide - 1)));
  };
  // Coordinates in cells, from the lower end to the upper.
  float x0 = (wall.ax - min_x_) / cell_width_, y0 = (wall.ay - min_y_) / cell_height_;
  float x1 = (wall.bx - min_x_) / cell_width_, y1 = (wall.by - min_y_) / cell_height_;
  if (y0 > y1) std::swap(x0, x1), std::swap(y0, y1);
  const bool flat = !(y1 - y0 > kFatten);
  const float slope = flat ? 0.0f : (x1 - x0) / (y1 - y0);
  for (int row = clamp_cell(y0 - kFatten); row <= clamp_cell(y1 + kFatten); ++row) {
    const float low = std::max(y0, static_cast<float>(row) - kFatten);
    const float high = std::min(y1, static_cast<float>(row + 1) + kFatten);
    const float xa = flat ? x0 : x0 + (low - y0) * slope;
    const float xb = flat ? x1 : x0 + (high - y0) * slope;
    const int last = clamp_cell(std::max(xa, xb) + kFatten);
    for (int column = clamp_cell(std::min(xa, xb) - kFatten); column <= last; ++column) {
      body(static_cast<std::size_t>(row * kSide + column));
    }
  }
}

Result<RayGrid> RayGrid::create(Context& context, const Scene& scene) {
  RayGrid grid;
  grid.scene_ = &scene;
  TableMemory scratch("the grid of rays");
  SFUMATO_TRY_ASSIGN(const std::vector<Wall>& found, walls_of(context, scene, scratch));
  const std::vector<Wall>& walls = found;
  Box box;
  for (const Wall& wall : walls) {
    box.extend({wall.ax, wall.ay});
    box.extend({wall.bx, wall.by});
  }
  if (walls.empty()) box = {{0, 0}, {1, 1}};
  const double least = std::max({box.width(), box.height(), 1e-6}) * 1e-6;
  grid.min_x_ = static_cast<float>(box.min.x);
  grid.min_y_ = static_cast<float>(box.min.y);
  grid.cell_width_ = static_cast<float>(std::max(box.width(), least) / kSide);
  grid.cell_height_ = static_cast<float>(std::max(box.height(), least) / kSide);

  std::vector<std::size_t> next(kSide * kSide + 1, 0);
  for (const Wall& wall : walls) {
    grid.for_each_cell(wall, [&](std::size_t cell) { ++next[cell + 1]; });
  }
  for (std::size_t c = 1; c < next.size(); ++c) next[c] += next[c - 1];
  if (next.back() > std::numeric_limits<std::uint32_t>::max()) {
    return make_error(StatusCode::limit, "too many edges for the grid of rays");
  }
  SFUMATO_TRY(grid.memory_.resize(context, grid.cell_wall_, next.back()));
  grid.cell_begin_.assign(next.begin(), next.end());
  for (const Wall& wall : walls) {
    grid.for_each_cell(wall, [&](std::size_t cell) { grid.cell_wall_[next[cell]++] = wall; });
  }
  return grid;
}

SFUMATO_INLINE void RayGrid::test_cell(std::size_t cell, float x, float y, float dx, float dy,
                                       RayHit& best) const {
  const Wall* end = cell_wall_.data() + cell_begin_[cell + 1];
  for (const Wall* next = cell_wall_.data() + cell_begin_[cell]; next != end; ++next) {
    const Wall& wall = *next;
    const float ax = wall.ax - x, ay = wall.ay - y;
    const float bx = wall.bx - x, by = wall.by - y;
    // The side of the ray on which an end lies depends only on that end, so that no ray slips
    // through a joint.
    const float side_a = dx * ay - dy * ax;
    const float side_b = dx * by - dy * bx;
    if ((side_a >= 0) == (side_b >= 0)) continue;
    const float width = side_b - side_a;
    const float distance = (ax * by - ay * bx) / width;
    if (!(distance > 0 && distance < best.distance)) continue;
    const EdgeCode code = width > 0 ? wall.front : wall.back;
    if (code >= 0) continue;
    best.distance = distance;
    best.edge = is_hit(code) ? &scene_->hit_edge[hit_index(code)] : nullptr;
    // The back's own half-edge runs the other way.
    best.fraction = width > 0 ? -side_a / width : 1 + side_a / width;
  }
}

RayHit RayGrid::first_hit(float x, float y, float dx, float dy) const {
  const float gx = x - min_x_, gy = y - min_y_;
  float enter = 0, leave = kNeverCrossed;
  clip_axis(gx, dx, cell_width_ * kSide, enter, leave);
  clip_axis(gy, dy, cell_height_ * kSide, enter, leave);
  RayHit best;
  if (!(enter <= leave)) return best;
  AxisWalk across = start_axis(gx, dx, enter, cell_width_, kSide);
  AxisWalk down = start_axis(gy, dy, enter, cell_height_, kSide);
  for (;;) {
    test_cell(static_cast<std::size_t>(down.cell * kSide + across.cell), x, y, dx, dy, best);
    // The next axis cannot be predicted: both are moved, one of them by nothing.
    const bool is_across = across.next < down.next;
    const float border = is_across ? across.next : down.next;
    if (best.distance <= border) return best;
    across.cell += is_across ? across.step : 0;
    down.cell += is_across ? 0 : down.step;
    across.next += is_across ? across.delta : 0;
    down.next += is_across ? 0 : down.delta;
    const auto left = static_cast<unsigned>(across.cell), top = static_cast<unsigned>(down.cell);
    if (!(border <= leave) || left >= kSide || top >= kSide) return best;
  }
}

}  // namespace sfumato::gather
