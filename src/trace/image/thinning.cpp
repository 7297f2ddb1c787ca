#include "trace/image/thinning.hpp"

#include <array>
#include <cstddef>

#include "base/poll.hpp"

namespace sfumato::tracing {
namespace {

/// Returns the eight neighbours of a pixel in a ring from above, clockwise, as bits.
std::uint8_t ring_of(const PixelSet& set, std::size_t at) {
  const std::size_t stride = set.stride();
  const std::array<std::size_t, 8> ring{at - stride, at - stride + 1, at + 1, at + stride + 1,
                                        at + stride, at + stride - 1, at - 1, at - stride - 1};
  unsigned bits = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) bits |= unsigned{set.is_set[ring[i]]} << i;
  return static_cast<std::uint8_t>(bits);
}

/// Returns whether a pixel with these neighbours goes in the first or the second half of a turn.
bool goes(std::uint8_t ring, bool is_first) {
  int count = 0, changes = 0;
  const auto is = [&](int i) { return (ring >> (i % 8) & 1) != 0; };
  for (int i = 0; i < 8; ++i) {
    count += is(i);
    changes += !is(i) && is(i + 1);
  }
  if (count < 2 || count > 6 || changes != 1) return false;
  const bool up = is(0), right = is(2), down = is(4), left = is(6);
  return is_first ? !(up && right && down) && !(right && down && left)
                  : !(up && right && left) && !(up && down && left);
}

std::array<std::uint8_t, 256> table_of() {
  std::array<std::uint8_t, 256> table{};
  for (unsigned ring = 0; ring < table.size(); ++ring) {
    const auto bits = static_cast<std::uint8_t>(ring);
    table[ring] = static_cast<std::uint8_t>(goes(bits, true) + 2 * goes(bits, false));
  }
  return table;
}

}  // namespace

Status thin(const Context& context, PixelSet& set) {
  const std::array<std::uint8_t, 256> table = table_of();
  RarePoll<4096> poll(context);
  std::vector<std::uint32_t> pixels, gone;
  for (std::size_t i = 0; i < set.is_set.size(); ++i) {
    if (set.is_set[i]) pixels.push_back(static_cast<std::uint32_t>(i));
  }
  for (bool changes = true; changes;) {
    changes = false;
    for (const unsigned half : {1u, 2u}) {
      gone.clear();
      for (const std::uint32_t at : pixels) {
        if (poll.cancelled()) return context.cancel_status();
        if (set.is_set[at] && (table[ring_of(set, at)] & half)) gone.push_back(at);
      }
      for (const std::uint32_t at : gone) set.is_set[at] = 0;
      changes = changes || !gone.empty();
    }
  }
  return ok_status();
}

}  // namespace sfumato::tracing
