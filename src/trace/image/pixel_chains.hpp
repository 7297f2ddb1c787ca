#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "trace/image/edges.hpp"

namespace sfumato::tracing {

struct PixelPlace {
  int x = 0;
  int y = 0;
  friend bool operator==(const PixelPlace&, const PixelPlace&) = default;
};

using PixelChain = std::span<const PixelPlace>;

/// Chains of pixels in one table, a chain behind another.
struct PixelChains {
  std::vector<PixelPlace> place;
  std::vector<std::uint32_t> end;  ///< per chain: the index behind its last place
  TableMemory memory{"the edges of a picture"};

  std::size_t size() const { return end.size(); }
  PixelChain operator[](std::size_t i) const {
    const std::size_t begin = i == 0 ? 0 : end[i - 1];
    return std::span(place).subspan(begin, end[i] - begin);
  }
  /// Makes a chain of the pixels that were added after the last chain.
  void end_chain() { end.push_back(static_cast<std::uint32_t>(place.size())); }
};

/// Every edge pixel in one chain, neighbours in a chain being neighbours in the picture. Chains of
/// fewer than four pixels are left out. Errors: limit (memory), cancelled.
Result<PixelChains> pixel_chains(Context& context, const EdgeMap& edges);

/// Joins chains whose ends face each other, the nearest first.
/// gap      the largest distance of such ends, pixels
/// Errors   limit (memory), cancelled
Status join_gaps(const Context& context, PixelChains& chains, const EdgeMap& edges, double gap);

/// Lets open ends run on to a pixel of a chain ahead, within base + rise √scale pixels, and closes
/// chains whose ends are as near to each other.
/// scales   per chain
/// Errors   limit (memory), cancelled
Status snap_ends(const Context& context, const EdgeMap& edges, const std::vector<double>& scales,
                 double base, double rise, PixelChains& chains);

}  // namespace sfumato::tracing
