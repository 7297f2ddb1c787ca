#include "raster/coverage/cell_coverage.hpp"

#include <algorithm>
#include <cmath>

#include "base/inline.hpp"

namespace sfumato::raster {
namespace {

/// Beyond this there are no digits for fractions of a cell; the test also fails for NaN.
constexpr double kFarthest = 1 << 20;

bool is_near(Vec2 p) {
  return std::fabs(p.x) < kFarthest && std::fabs(p.y) < kFarthest;
}

int floor_of(double x) {
  const int towards_zero = static_cast<int>(x);
  return towards_zero - (towards_zero > x);
}

}  // namespace

/// Adds integrals of 1 - x, (1 - x²) / 2 and y (1 - x) dy along the edge, in the cell's own frame.
SFUMATO_INLINE void CellCoverage::add_in_cell(int row, int column, Vec2 from, Vec2 to,
                                              double sign) {
  const double x0 = from.x - column, x1 = to.x - column;
  const double y0 = from.y - row, y1 = to.y - row;
  const double height = sign * (to.y - from.y);
  const double both_x = x0 + x1, mean_y = 0.5 * (y0 + y1);
  Cell& cell = cell_[row * columns_ + column];
  cell.area += height * (1 - 0.5 * both_x);
  cell.moment_x += height * (0.5 - (both_x * both_x - x0 * x1) * (1.0 / 6));
  cell.moment_y += height * (mean_y - (y0 * (x0 + both_x) + y1 * (x1 + both_x)) * (1.0 / 6));
  cell.height += height;
  cell.y_dy += height * mean_y;
}

SFUMATO_INLINE void CellCoverage::add_in_row(int row, Vec2 from, Vec2 to, double sign) {
  const int column = static_cast<int>(from.x), last = static_cast<int>(to.x);
  if (column == last) return add_in_cell(row, column, from, to, sign);
  if (column < last) return add_across(row, from, to, sign);
  add_across(row, to, from, -sign);
}

/// Adds a part from left to right, through several columns.
void CellCoverage::add_across(int row, Vec2 from, Vec2 to, double sign) {
  const double dy_dx = (to.y - from.y) / (to.x - from.x);
  const Vec2 first = from;
  int column = static_cast<int>(from.x);
  for (; column + 1 < to.x; ++column) {
    const double x = column + 1;
    const Vec2 next{x, first.y + (x - first.x) * dy_dx};
    add_in_cell(row, column, from, next, sign);
    from = next;
  }
  add_in_cell(row, column, from, to, sign);
}

/// Adds an edge. An upward edge is on the left of the triangle: the area to its right is added. The
/// area to the right of a downward edge is subtracted.
void CellCoverage::add_edge(const Vec2 (&end)[2]) {
  if (end[0].y == end[1].y) return;
  // Uses a table: half of these branches would be predicted wrongly.
  constexpr double kSign[2] = {-1, 1};
  const int goes_up = end[0].y > end[1].y;
  const Vec2 a = end[goes_up], b = end[1 - goes_up];
  const double dx_dy = (b.x - a.x) / (b.y - a.y);
  const double low = std::min(a.x, b.x), high = std::max(a.x, b.x);
  Vec2 from = a;
  for (int row = static_cast<int>(a.y); from.y < b.y; ++row) {
    const double y = row + 1;
    const Vec2 to = y < b.y ? Vec2{std::clamp(a.x + (y - a.y) * dx_dy, low, high), y} : b;
    add_in_row(row, from, to, kSign[goes_up]);
    from = to;
  }
}

void CellCoverage::sum_rows() {
  for (int row = 0; row < rows_; ++row) {
    double height = 0, y_dy = 0;
    for (int column = 0; column < columns_; ++column) {
      Cell& cell = cell_[row * columns_ + column];
      cell.area += height;
      cell.moment_x += 0.5 * height;
      cell.moment_y += y_dy;
      height += cell.height;
      y_dy += cell.y_dy;
    }
  }
}

bool CellCoverage::cut(const Vec2 (&corner)[3], const Box& box) {
  if (!(is_near(corner[0]) && is_near(corner[1]) && is_near(corner[2]))) return false;
  x0_ = floor_of(box.min.x);
  y0_ = floor_of(box.min.y);
  columns_ = floor_of(box.max.x) - x0_ + 1;
  rows_ = floor_of(box.max.y) - y0_ + 1;
  if (columns_ > kMostCells || rows_ > kMostCells || columns_ * rows_ > kMostCells) return false;
  std::fill_n(cell_, columns_ * rows_, Cell{});
  const Vec2 origin{static_cast<double>(x0_), static_cast<double>(y0_)};
  const Vec2 a = corner[0] - origin, b = corner[1] - origin, c = corner[2] - origin;
  add_edge({a, b});
  add_edge({b, c});
  add_edge({c, a});
  sum_rows();
  return true;
}

}  // namespace sfumato::raster
