#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "curves/flatten.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::curves {

/// A vertex of one passage of a curve that lies on another passage, which must pass through it too.
struct Junction {
  std::uint32_t curve = 0;  ///< the curve that must pass through it…
  double parameter = 0;     ///< …at this parameter
  Vec2 point;
};

struct Junctions {
  std::vector<Junction> junction;    ///< by curve, then parameter
  std::vector<std::uint8_t> pinned;  ///< per vertex of `flat`: 1 where it lies on another passage
  TableMemory memory{"flattening"};
};

/// Finds the vertices of `flat` (which lie on their curves) that are within `reach` of another
/// curve or of another passage of their own. If both passages have every such vertex, curves that
/// overlap have the same chords, however they are cut into pieces, and an end that touches a curve
/// touches its chords. A vertex that is near hundreds of others may be missed. Errors: limit,
/// cancelled. Cost: O(vertices log vertices).
Result<Junctions> find_junctions(Context& context, std::span<const Curve> curves,
                                 const FlatCurves& flat, double reach);

}  // namespace sfumato::curves
