#pragma once

#include <array>

namespace sfumato::color {

/// Three coordinates of a colour; their meaning depends on the space.
struct Triple {
  double x = 0, y = 0, z = 0;
};

/// Three rows.
struct Matrix {
  std::array<Triple, 3> row;
};

constexpr double dot(const Triple& a, const Triple& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

constexpr Triple operator*(const Matrix& m, const Triple& v) {
  return {dot(m.row[0], v), dot(m.row[1], v), dot(m.row[2], v)};
}

constexpr Matrix transposed(const Matrix& m) {
  const auto& [a, b, c] = m.row;
  return {{{{a.x, b.x, c.x}, {a.y, b.y, c.y}, {a.z, b.z, c.z}}}};
}

constexpr Matrix operator*(const Matrix& a, const Matrix& b) {
  const Matrix columns = transposed(b);
  return {{{columns * a.row[0], columns * a.row[1], columns * a.row[2]}}};
}

constexpr Matrix diagonal(const Triple& d) {
  return {{{{d.x, 0, 0}, {0, d.y, 0}, {0, 0, d.z}}}};
}

constexpr Triple cross(const Triple& a, const Triple& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

constexpr Matrix inverse(const Matrix& m) {
  const auto& [a, b, c] = m.row;
  const double share = 1 / dot(a, cross(b, c));
  const Matrix columns{{{cross(b, c), cross(c, a), cross(a, b)}}};
  return transposed(diagonal({share, share, share}) * columns);
}

}  // namespace sfumato::color
