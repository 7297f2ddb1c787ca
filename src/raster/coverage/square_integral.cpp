#include "raster/coverage/square_integral.hpp"

#include <algorithm>

namespace sfumato::raster {
namespace {

/// Integrates over the area left of the line from a to b, by Green's theorem: x dy, x² / 2 dy and x
/// y dy along it.
Moments line_integral(Vec2 a, Vec2 b) {
  const double dy = b.y - a.y;
  return {0.5 * dy * (a.x + b.x), dy * (a.x * (a.x + b.x) + b.x * b.x) / 6,
          dy * (a.x * (2 * a.y + b.y) + b.x * (a.y + 2 * b.y)) / 6};
}

/// Finds the range on the line from p, which grows by `change`, inside the square [0, 1].
void square_range(double p, double change, double (&range)[2]) {
  range[0] = 0;
  range[1] = 1;
  if (change == 0) return;
  const double low = std::clamp(-p / change, 0.0, 1.0);
  const double high = std::clamp((1 - p) / change, 0.0, 1.0);
  range[0] = std::min(low, high);
  range[1] = std::max(low, high);
}

Vec2 in_square(Vec2 p) {
  return {std::clamp(p.x, 0.0, 1.0), std::clamp(p.y, 0.0, 1.0)};
}

}  // namespace

Moments edge_integral(Vec2 a, Vec2 b) {
  Moments sum;
  const bool is_beside = (a.y <= 0 && b.y <= 0) || (a.y >= 1 && b.y >= 1);
  if (is_beside || a.y == b.y || (a.x <= 0 && b.x <= 0)) return sum;
  const Vec2 from = in_square(a), to = in_square(b);
  if ((from == a && to == b) || (a.x >= 1 && b.x >= 1)) return line_integral(from, to);
  double rows[2], columns[2];
  square_range(a.y, b.y - a.y, rows);
  const Vec2 p = lerp(a, b, rows[0]), q = lerp(a, b, rows[1]);
  square_range(p.x, q.x - p.x, columns);
  const Vec2 m = in_square(lerp(p, q, columns[0])), n = in_square(lerp(p, q, columns[1]));
  sum.add(line_integral(in_square(p), m), 1);
  sum.add(line_integral(m, n), 1);
  sum.add(line_integral(n, in_square(q)), 1);
  return sum;
}

}  // namespace sfumato::raster
