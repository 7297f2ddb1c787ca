#pragma once

#include <vector>

#include "sfumato/base/vec2.hpp"

namespace sfumato::curves {

/// A vertex of a polyline that is being made.
struct Knot {
  double parameter = 0;  ///< of the curve
  Vec2 point;
  bool pinned = false;       ///< it lies on another passage of a curve
  bool is_junction = false;  ///< it exists only because another passage has a vertex in its place
};

/// Removes knots beside sharp tips that come within `reach` of the tip's other side, as long as the
/// chord to the tip passes them within a quarter of the tip's width. The mesh would merge both
/// sides there into one line, and one of the curve's sides would lie outside of both. Returns
/// whether any knot was removed. Use it for outlines of one paint on each side. Cost: O(knots).
bool clear_tips(std::vector<Knot>& knots, double reach);

}  // namespace sfumato::curves
