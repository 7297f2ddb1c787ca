#include "base/spatial_order.hpp"

#include <algorithm>
#include <bit>

#include "base/boxes.hpp"
#include "base/try.hpp"
#include "sfumato/base/box.hpp"

namespace sfumato {
namespace {

/// Puts a 0 between the bits of x < 2^16.
std::uint32_t spread(std::uint32_t x) {
  x = (x | x << 8) & 0x00ff00ffu;
  x = (x | x << 4) & 0x0f0f0f0fu;
  x = (x | x << 2) & 0x33333333u;
  return (x | x << 1) & 0x55555555u;
}

}  // namespace

Status spatial_order(const Context& context, std::span<const Vec2> points, TableMemory& memory,
                     std::vector<std::uint32_t>& order) {
  // A power of two of cells on each side, about one cell for each point, at most 2^20 in all.
  const int side_bits = std::min(10, static_cast<int>(std::bit_width(points.size()) + 1) / 2);
  TableMemory working("sorting");
  std::vector<std::uint32_t> cell, next;
  SFUMATO_TRY(working.resize(context, cell, points.size()));
  SFUMATO_TRY(working.resize(context, next, (std::size_t{1} << (2 * side_bits)) + 1));
  SFUMATO_TRY(memory.resize(context, order, points.size()));
  const Box box = box_of_points(points);
  const double side = static_cast<double>(1u << side_bits);
  const double size = std::max({box.width(), box.height(), 1e-300});
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 at = (points[i] - box.min) / size * side;
    const auto column = static_cast<std::uint32_t>(std::min(at.x, side - 1));
    const auto row = static_cast<std::uint32_t>(std::min(at.y, side - 1));
    cell[i] = spread(column) | spread(row) << 1;
    ++next[cell[i] + 1];
  }
  for (std::size_t c = 1; c < next.size(); ++c) next[c] += next[c - 1];
  for (std::size_t i = 0; i < points.size(); ++i) {
    order[next[cell[i]]++] = static_cast<std::uint32_t>(i);
  }
  return ok_status();
}

}  // namespace sfumato
