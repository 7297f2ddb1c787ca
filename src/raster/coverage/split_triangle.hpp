#pragma once

namespace sfumato::raster {

/// The part of a triangle on one side of a line.
struct SplitPart {
  double share = 0;  ///< of the triangle's area, 0 to 1
  double u = 0;      ///< weight of corner 1 at the part's centroid; meaningless where share is 0
  double v = 0;      ///< weight of corner 2
};

struct SplitTriangle {
  SplitPart below;  ///< where the distance is negative
  SplitPart above;
};

/// Splits a triangle by a line, in closed form.
///
/// distance   signed, of the corners to the line; some above 0, the others below it or 0
SplitTriangle split_triangle(const double (&distance)[3]);

}  // namespace sfumato::raster
