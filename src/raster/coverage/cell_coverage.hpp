#pragma once

#include "raster/coverage/clip.hpp"
#include "sfumato/base/box.hpp"

namespace sfumato::raster {

/// Computes the parts of a small triangle in all unit squares of a grid at once, while
/// pixel_coverage() would cut it again for each: integrals along the edges (Green's theorem),
/// summed along each row from the left. Areas and first moments equal the results of
/// pixel_coverage() within 1e-13.
class CellCoverage {
 public:
  /// Cuts a triangle, given its corners clockwise on the screen, and their bounding box. Returns
  /// false where the triangle is not small: the box meets more than 64 cells, or coordinates are
  /// beyond 2^20 or NaN.
  bool cut(const Vec2 (&corner)[3], const Box& box);

  /// Returns the part in the cell whose upper left corner is (x, y); parts below 1e-13 count as
  /// empty.
  Coverage in(int x, int y) const {
    const int column = x - x0_, row = y - y0_;
    if (column < 0 || column >= columns_ || row < 0 || row >= rows_) return {};
    const Cell& cell = cell_[row * columns_ + column];
    if (!(cell.area > kLeastArea)) return {};
    return {cell.area, Vec2{cell.moment_x, cell.moment_y} / cell.area};
  }

 private:
  static constexpr int kMostCells = 64;
  static constexpr double kLeastArea = 1e-13;  ///< smaller areas are rounding errors of the sums

  /// Integrals over the part of a cell to the right of the edges that pass through it: first over
  /// the part inside the cell, then `height` and `y` of the edges, which count for cells on the
  /// right.
  struct Cell {
    double area = 0, moment_x = 0, moment_y = 0;
    double height = 0;  ///< integral of dy
    double y_dy = 0;    ///< integral of y dy
  };

  void add_edge(const Vec2 (&end)[2]);
  void add_across(int row, Vec2 from, Vec2 to, double sign);
  void add_in_row(int row, Vec2 from, Vec2 to, double sign);
  void add_in_cell(int row, int column, Vec2 from, Vec2 to, double sign);
  void sum_rows();

  int x0_ = 0, y0_ = 0;
  int columns_ = 0, rows_ = 0;
  Cell cell_[kMostCells];
};

}  // namespace sfumato::raster
