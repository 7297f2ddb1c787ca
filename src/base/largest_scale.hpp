#pragma once

#include <algorithm>
#include <cmath>

#include "sfumato/base/affine.hpp"

namespace sfumato {

/// Returns the length of the longest image of a unit vector: the larger singular value of the
/// linear part.
inline double largest_scale(const Affine& m) {
  const double squares = m.a * m.a + m.b * m.b + m.c * m.c + m.d * m.d;
  const double area = m.determinant();
  const double rest = std::sqrt(std::max(0.0, squares * squares - 4 * area * area));
  return std::sqrt(0.5 * (squares + rest));
}

}  // namespace sfumato
