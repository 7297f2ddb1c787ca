#pragma once

#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "trace/edges.hpp"

namespace sfumato::tracing {

struct PixelPlace {
  int x = 0;
  int y = 0;
  friend bool operator==(const PixelPlace&, const PixelPlace&) = default;
};

using PixelChain = std::vector<PixelPlace>;

/// Every edge pixel in one chain, neighbours in a chain being neighbours in the picture. Chains of
/// fewer than four pixels are left out. Errors: limit (memory), cancelled.
Result<std::vector<PixelChain>> pixel_chains(Context& context, const EdgeMap& edges);

/// Joins chains whose ends face each other, the nearest first.
/// gap      the largest distance of such ends, pixels
/// Errors   limit (memory), cancelled
Status join_gaps(const Context& context, std::vector<PixelChain>& chains, const EdgeMap& edges,
                 double gap);

/// Lets open ends run on to a pixel of a chain ahead, within base + rise √scale pixels, and closes
/// chains whose ends are as near to each other.
/// scales   per chain
/// Errors   limit (memory), cancelled
Status snap_ends(const Context& context, const EdgeMap& edges, const std::vector<double>& scales,
                 double base, double rise, std::vector<PixelChain>& chains);

}  // namespace sfumato::tracing
