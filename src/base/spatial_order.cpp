#include "base/spatial_order.hpp"

#include <algorithm>
#include <bit>

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

/// A power of two of cells on each side, about one cell for each point, at most 2^20 in all.
int side_bits_for(std::size_t points) {
  return std::min(10, static_cast<int>(std::bit_width(points) + 1) / 2);
}

/// Entries of `next`, which are 0 at first.
std::size_t next_count(std::size_t points) {
  return (std::size_t{1} << (2 * side_bits_for(points))) + 1;
}

/// The tables have room for what is to be in them: `cell` and `order` for an entry a point.
void sort_by_cell(std::span<const Vec2> points, std::vector<std::uint32_t>& cell,
                  std::vector<std::uint32_t>& next, std::vector<std::uint32_t>& order) {
  Box box;
  for (Vec2 p : points) box.extend(p);
  const double side = static_cast<double>(1u << side_bits_for(points.size()));
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
}

}  // namespace

std::vector<std::uint32_t> spatial_order(std::span<const Vec2> points) {
  std::vector<std::uint32_t> cell(points.size()), next(next_count(points.size()));
  std::vector<std::uint32_t> order(points.size());
  sort_by_cell(points, cell, next, order);
  return order;
}

Status spatial_order(Context& context, std::span<const Vec2> points, TableMemory& memory,
                     std::vector<std::uint32_t>& order) {
  TableMemory working("sorting");
  std::vector<std::uint32_t> cell, next;
  Status status = working.resize(context, cell, points.size());
  if (status) status = working.resize(context, next, next_count(points.size()));
  if (status) status = memory.resize(context, order, points.size());
  if (status) sort_by_cell(points, cell, next, order);
  return status;
}

}  // namespace sfumato
