#pragma once

#include <cstdint>
#include <span>

#include "gather/ends/free_ends.hpp"
#include "gather/scene/locate.hpp"
#include "gather/scene/packing.hpp"
#include "gather/scene/scene.hpp"

namespace sfumato::gather {

/// The destination of results: as in Gatherer::gather.
struct GatherOutput {
  std::span<float> out;
  std::span<std::uint8_t> hit;
  bool weighs = false;
};

/// Computes Z of eq. 2 at every point of a packing, in closed form over the exact visible set.
/// Errors: limit (memory), cancelled.
Status gather_exact(Context& context, const Scene& scene, const FreeEnds& ends,
                    const PointList& points, const LocatedPoints& located, const Packing& packing,
                    const GatherOutput& output);

}  // namespace sfumato::gather
