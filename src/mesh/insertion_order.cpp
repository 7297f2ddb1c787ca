#include "mesh/insertion_order.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include "base/try.hpp"

namespace sfumato::mesh {
namespace {

constexpr int kHilbertBits = 11;
constexpr int kRadixBits = 11;

/// Returns the distance along the Hilbert curve over 2^11 × 2^11 cells. `swapped` and `inverted`
/// describe the curve's orientation in the current quadrant.
std::uint32_t hilbert_key(std::uint32_t x, std::uint32_t y) {
  std::uint32_t key = 0, swapped = 0, inverted = 0;
  for (int bit = kHilbertBits - 1; bit >= 0; --bit) {
    const std::uint32_t bx = (x >> bit) & 1, by = (y >> bit) & 1;
    const std::uint32_t difference = (bx ^ by) & (0u - swapped);
    const std::uint32_t rx = bx ^ difference ^ inverted;
    const std::uint32_t ry = by ^ difference ^ inverted;
    key = key << 2 | ((3 * rx) ^ ry);
    inverted ^= rx & (ry ^ 1);
    swapped ^= ry ^ 1;
  }
  return key;
}

std::uint32_t hash(std::uint32_t i) {
  i = (i ^ (i >> 16)) * 0x7feb352du;
  i = (i ^ (i >> 15)) * 0x846ca68bu;
  return i ^ (i >> 16);
}

struct Item {
  std::uint32_t key;
  std::uint32_t index;
};

/// Does a stable counting sort by `digit` (below 2^kRadixBits).
template <class Digit>
void sort_by(std::vector<Item>& items, std::vector<Item>& scratch, Digit digit) {
  std::array<std::uint32_t, (1u << kRadixBits) + 1> start{};
  for (const Item& item : items) ++start[digit(item) + 1];
  for (std::size_t d = 1; d < start.size(); ++d) start[d] += start[d - 1];
  for (const Item& item : items) scratch[start[digit(item)]++] = item;
  items.swap(scratch);
}

}  // namespace

Result<std::vector<std::uint32_t>> insertion_order(const Context& context,
                                                   std::span<const Point> points,
                                                   std::int32_t extent, TableMemory& memory) {
  const int shift = std::max(
      0, static_cast<int>(std::bit_width(static_cast<std::uint32_t>(extent))) - kHilbertBits);
  const auto count = static_cast<std::uint32_t>(points.size());
  // The first round has about 32 points.
  const int last_round = std::max(0, static_cast<int>(std::bit_width(count)) - 6);
  TableMemory working("mesh input");
  std::vector<Item> items, scratch;
  std::vector<std::uint32_t> order;
  SFUMATO_TRY(working.resize_all(context, count, items, scratch));
  SFUMATO_TRY(memory.resize(context, order, count));
  for (std::uint32_t i = 0; i < count; ++i) {
    const Point p = points[i];
    items[i] = {hilbert_key(static_cast<std::uint32_t>(p.x) >> shift,
                            static_cast<std::uint32_t>(p.y) >> shift),
                i};
  }
  constexpr std::uint32_t mask = (1u << kRadixBits) - 1;
  if (context.cancelled()) return context.cancel_status();
  sort_by(items, scratch, [](const Item& item) { return item.key & mask; });
  if (context.cancelled()) return context.cancel_status();
  sort_by(items, scratch, [](const Item& item) { return item.key >> kRadixBits; });
  if (context.cancelled()) return context.cancel_status();
  sort_by(items, scratch, [&](const Item& item) {
    const int round_from_last = std::countr_zero(hash(item.index));
    return static_cast<std::uint32_t>(last_round - std::min(round_from_last, last_round));
  });
  if (context.cancelled()) return context.cancel_status();
  for (std::uint32_t i = 0; i < count; ++i) order[i] = items[i].index;
  return order;
}

}  // namespace sfumato::mesh
