#pragma once

#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "trace/curves/traced_curve.hpp"

namespace sfumato::tracing {

struct SnapOptions {
  float leak = 0;  ///< an end whose sides differ less, in every channel, leaks nothing that shows
  /// An end lands where the curve, going straight on, meets the other one; else at that one's
  /// nearest place, which is off the edge by as much as the end was away. Beside clear ground that
  /// shows.
  bool lands_ahead = false;
};

/// Moves ends of open curves that almost touch another curve, or the curve itself, onto it: colours
/// would leak through the gap. Cuts off ends that stick out a little beyond a curve, and closes
/// curves that are nearly closed. If the sides of the end differ, the side of the other curve gets
/// a step there: two stops at one place. Curves that become very short are removed.
///
/// Errors          limit (memory), cancelled
/// width, height   of the picture, pixels
Status snap_to_curves(const Context& context, int width, int height, const SnapOptions& options,
                      std::vector<TracedCurve>& curves);

}  // namespace sfumato::tracing
