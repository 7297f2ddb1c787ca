#pragma once

#include "gather/exact.hpp"
#include "gather/point_source.hpp"

namespace sfumato::gather {

/// Does gather_exact() by a source of sums. The packets gather the points that the source cannot.
/// Errors: limit (memory), cancelled.
Status gather_from(Context& context, PointSource& source, const Scene& scene, const FreeEnds& ends,
                   const PointList& points, const LocatedPoints& located, const Packing& packing,
                   const GatherOutput& output);

}  // namespace sfumato::gather
