#pragma once

#include "raster/coverage/painted_edge.hpp"

namespace sfumato::raster {

/// Strips that lie on each other represent the blur of one side of an edge. Strip i, which reaches
/// kStripReach[i] radii from the edge, is the mean of the points whose share of the other side, 1 -
/// β (curves/front_share.hpp), is between (4 - i)/8 and (3 - i)/8. At the end of strip i the share
/// falls by 1/8. The areas of shifted edges are averaged; the error of the mean over a pixel is at
/// most 0.007 R, R in pixels.
inline constexpr int kStrips = 4;
inline constexpr double kStripReach[kStrips] = {0.08373, 0.25630, 0.44840, 0.71157};

/// The strips of a soft edge in the image.
struct SoftStrip {
  PaintedEdge edge;
  Vec2 reach[2];  ///< one blur radius, from that end
};

SoftStrip soft_strip(const LayerView& layer, const SoftEdge& edge);

/// The part of the strips in a pixel: their areas, and the position along the edge.
struct StripPart {
  float area[kStrips] = {};
  float moment[2] = {};  ///< of a bow: area times centroid, from the pixel's upper left corner
  float along = 0;       ///< of the last strip's centroid, 0 to 1

  bool empty() const { return area[kStrips - 1] == 0; }
};

StripPart strip_part(const SoftStrip& strip, int x, int y);

}  // namespace sfumato::raster
