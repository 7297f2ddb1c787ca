#pragma once

#include <vector>

#include "base/table_memory.hpp"
#include "curves/attributes.hpp"
#include "sfumato/base/affine.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/base/color_space.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/curve.hpp"

namespace sfumato::curves {

/// Nodes of the midpoint rule in one segment, at most.
inline constexpr int kStrokeNodes = 16;

/// A short stretch of a local curve, for integrals over its length by the midpoint rule in u: node
/// k stands at u = (k + 1/2) / node_count. Attributes are linear in u.
///
/// Frame: the stroke's own, scaled by StrokeOptions::scale.
struct StrokeSegment {
  Vec2 start;
  float coefficient[3][2];  ///< x, y of start + u (c[0] + u (c[1] + u c[2]))
  /// Length that a node represents, divided by the speed |d position / du| there; chosen so that
  /// the nodes' lengths add up to the segment's length.
  float length_per_speed = 0;
  int node_count = 1;
  SegmentValues<float> influence_radius;
  SegmentValues<float> blur_radius;
  SegmentValues<Rgb> left;  ///< in the interpolation space
  SegmentValues<Rgb> right;
};

struct StrokeOptions {
  double scale = 1;          ///< of the segments' frame, per user unit
  Affine image_from_stroke;  ///< user units → pixels
  Box image;                 ///< pixels; segments that cannot reach it are left out
  InterpolationSpace interpolation = InterpolationSpace::srgb;
  double smallest_radius = 1;   ///< smaller influence radii are raised to it; scaled frame
  double nodes_per_radius = 8;  ///< nodes are at most (local radius / this) apart
};

/// The segments of a stroke in the order along it, and the box that each can reach, pixels.
struct StrokeSegments {
  std::vector<StrokeSegment> segment;
  std::vector<Box> reach;
  TableMemory memory{"a local curve"};
};

/// Returns whether the sides of a local curve differ. A side without colours takes the other
/// side's.
bool is_two_sided(const LocalCurve& curve);

/// Cuts a local curve into segments: at every stop, and until nodes are close enough and the curve
/// turns little from one to the next. A side without colours takes the other side's.
///
/// Precondition: the curve was validated; one side has colours.
/// Errors: limit (segments, memory), cancelled. Cost: O(pieces + segments).
Result<StrokeSegments> stroke_segments(Context& context, const LocalCurve& curve,
                                       const StrokeOptions& options);

}  // namespace sfumato::curves
