#pragma once

#include <vector>

#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/base/vec2.hpp"
#include "trace/image/edges.hpp"

namespace sfumato::tracing {

/// Pixels of an edge in their order along it.
struct Chain {
  std::vector<Vec2> point;      ///< on the edge, smoothed, pixels; a closed chain repeats its first
  std::vector<float> strength;  ///< per point
  double scale = 1;             ///< median of the scales at which its pixels were found
  bool is_closed = false;
};

struct ChainOptions {
  double gap = 4;           ///< ends that face each other are joined over this distance, pixels
  double snap_base = 1.5;   ///< an end runs on to another chain ahead within snap_base +
  double snap_rise = 2.5;   ///< snap_rise √scale pixels
  double least_length = 7;  ///< shorter chains, in pixels times √scale, are dropped
  double smoothing = 1;     ///< along the chain, standard deviation in points times √scale
};

/// Follows the lines of an edge map, which is thin. At junctions a chain goes straight on.
/// memory   of the chains
/// Errors   limit (memory), cancelled
Result<std::vector<Chain>> link_chains(Context& context, const EdgeMap& edges, TableMemory& memory,
                                       const ChainOptions& options = {});

}  // namespace sfumato::tracing
