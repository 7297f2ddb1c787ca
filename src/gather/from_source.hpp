#pragma once

#include "gather/exact.hpp"
#include "gather/point_source.hpp"

namespace sfumato::gather {

/// gather_exact() by a source of sums. What the source cannot gather, the packets do. Errors: limit
/// (memory), cancelled.
Status gather_from(Context& context, PointSource& source, const Scene& scene, const FreeEnds& ends,
                   const PointList& points, const LocatedPoints& located, const Packing& packing,
                   const GatherOutput& output);

}  // namespace sfumato::gather
