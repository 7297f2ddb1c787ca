#include "gather/ray_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/box.hpp"

namespace sfumato::gather {
namespace {

/// Cells are grown by this share of their size when edges are entered, so that no hit is lost to
/// rounding at joints and borders.
constexpr float kFatten = 1e-3f;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// One axis of a walk from cell to cell.
struct AxisWalk {
  int cell;
  int step;
  float next;   ///< distance along the ray to the next cell border
  float delta;  ///< distance from border to border
};

AxisWalk start_axis(float position, float direction, float cell_size, int side) {
  const int cell = static_cast<int>(
      std::clamp(std::floor(position / cell_size), 0.0f, static_cast<float>(side - 1)));
  if (direction > 0) {
    return {cell, 1, (static_cast<float>(cell + 1) * cell_size - position) / direction,
            cell_size / direction};
  }
  if (direction < 0) {
    return {cell, -1, (static_cast<float>(cell) * cell_size - position) / direction,
            -cell_size / direction};
  }
  return {cell, 0, kInfinity, kInfinity};
}

/// Narrows [enter, leave] to where position + t direction lies in [0, size].
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

/// Calls body(cell) for every cell that the edge touches when the cell is a little grown.
template <class Body>
void RayGrid::for_each_cell(const StopEdge& edge, Body body) const {
  const auto clamp_cell = [](float c) {
    return static_cast<int>(std::clamp(std::floor(c), 0.0f, static_cast<float>(kSide - 1)));
  };
  // Coordinates in cells, from the lower end to the upper.
  float x0 = (edge.ax - min_x_) / cell_width_, y0 = (edge.ay - min_y_) / cell_height_;
  float x1 = (edge.bx - min_x_) / cell_width_, y1 = (edge.by - min_y_) / cell_height_;
  if (y0 > y1) std::swap(x0, x1), std::swap(y0, y1);
  for (int row = clamp_cell(y0 - kFatten); row <= clamp_cell(y1 + kFatten); ++row) {
    const float low = std::max(y0, static_cast<float>(row) - kFatten);
    const float high = std::min(y1, static_cast<float>(row + 1) + kFatten);
    const float slope = y1 > y0 ? (x1 - x0) / (y1 - y0) : 0.0f;
    const bool flat = !(y1 - y0 > kFatten);
    const float xa = flat ? x0 : x0 + (low - y0) * slope;
    const float xb = flat ? x1 : x0 + (high - y0) * slope;
    const int first = clamp_cell(std::min(xa, xb) - kFatten);
    const int last = clamp_cell(std::max(xa, xb) + kFatten);
    for (int column = first; column <= last; ++column) {
      body(static_cast<std::size_t>(row * kSide + column));
    }
  }
}

Result<RayGrid> RayGrid::create(Context& context, const Scene& scene) {
  RayGrid grid;
  grid.scene_ = &scene;
  const auto edge_count = static_cast<std::uint32_t>(scene.stop.size() + scene.barrier.size());
  Box box;
  for (std::uint32_t i = 0; i < edge_count; ++i) {
    box.extend({grid.edge(i).ax, grid.edge(i).ay});
    box.extend({grid.edge(i).bx, grid.edge(i).by});
  }
  if (edge_count == 0) box = {{0, 0}, {1, 1}};
  const double least = std::max({box.width(), box.height(), 1e-6}) * 1e-6;
  grid.min_x_ = static_cast<float>(box.min.x);
  grid.min_y_ = static_cast<float>(box.min.y);
  grid.cell_width_ = static_cast<float>(std::max(box.width(), least) / kSide);
  grid.cell_height_ = static_cast<float>(std::max(box.height(), least) / kSide);

  grid.cell_begin_.assign(kSide * kSide + 1, 0);
  for (std::uint32_t i = 0; i < edge_count; ++i) {
    grid.for_each_cell(grid.edge(i), [&](std::size_t cell) { ++grid.cell_begin_[cell + 1]; });
  }
  for (std::size_t c = 1; c < grid.cell_begin_.size(); ++c) {
    grid.cell_begin_[c] += grid.cell_begin_[c - 1];
  }
  const std::size_t bytes = (grid.cell_begin_.size() + grid.cell_begin_.back()) * 4;
  if (Status status = grid.charge_.add(context, bytes, "the grid of rays"); !status) return status;
  grid.cell_edge_.resize(grid.cell_begin_.back());
  std::vector<std::uint32_t> next(grid.cell_begin_.begin(), grid.cell_begin_.end() - 1);
  for (std::uint32_t i = 0; i < edge_count; ++i) {
    grid.for_each_cell(grid.edge(i), [&](std::size_t cell) { grid.cell_edge_[next[cell]++] = i; });
  }
  return grid;
}

void RayGrid::test_cell(std::size_t cell, float x, float y, float dx, float dy,
                        RayHit& best) const {
  for (std::uint32_t i = cell_begin_[cell]; i < cell_begin_[cell + 1]; ++i) {
    const StopEdge& e = edge(cell_edge_[i]);
    const float ax = e.ax - x, ay = e.ay - y;
    const float bx = e.bx - x, by = e.by - y;
    // Both ends ask the same of their own vertex, so that no ray slips through a joint.
    const float past_a = ax * dy - ay * dx;
    const float before_b = dx * by - dy * bx;
    if (!(past_a >= 0 && before_b >= 0)) continue;
    const float area = ax * e.ey - ay * e.ex;
    const float width = past_a + before_b;
    if (!(area > 0 && width > 0)) continue;
    const float distance = area / width;
    if (best.edge && distance >= best.distance) continue;
    best = {&e, past_a / width, distance};
  }
}

RayHit RayGrid::first_hit(float x, float y, float dx, float dy) const {
  const float gx = x - min_x_, gy = y - min_y_;
  float enter = 0, leave = kInfinity;
  clip_axis(gx, dx, cell_width_ * kSide, enter, leave);
  clip_axis(gy, dy, cell_height_ * kSide, enter, leave);
  RayHit best;
  if (!(enter <= leave)) return best;
  AxisWalk across = start_axis(gx + enter * dx, dx, cell_width_, kSide);
  AxisWalk down = start_axis(gy + enter * dy, dy, cell_height_, kSide);
  across.next += enter;
  down.next += enter;
  for (;;) {
    test_cell(static_cast<std::size_t>(down.cell * kSide + across.cell), x, y, dx, dy, best);
    AxisWalk& axis = across.next < down.next ? across : down;
    if (best.edge && best.distance <= axis.next) return best;
    axis.cell += axis.step;
    if (axis.step == 0 || axis.cell < 0 || axis.cell >= kSide) return best;
    axis.next += axis.delta;
  }
}

}  // namespace sfumato::gather
