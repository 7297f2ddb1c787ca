#pragma once

#include "raster/kernels/tile.hpp"

namespace sfumato::raster {

/// Strips that lie on each other stand for the blur of one side of an edge: strip i, which reaches
/// kStripReach[i] radii from it, is the mean of those points whose share of what lies across,
/// 1 - β (curves/front_share.hpp), is between (4 - i)/8 and (3 - i)/8. Where strip i ends, the
/// share falls by 1/8: areas of edges that are moved are averaged, and the mean over a pixel is
/// wrong by 0.007 R at most, R in pixels.
inline constexpr int kStrips = 4;
inline constexpr double kStripReach[kStrips] = {0.08373, 0.25630, 0.44840, 0.71157};

/// The strips of a soft edge in the image.
struct SoftStrip {
  Vec2 end[2];    ///< of the edge
  Vec2 reach[2];  ///< from there, one radius
  double turn;    ///< 1, or -1 where the layer is mirrored: areas are positive then
};

SoftStrip soft_strip(const LayerView& layer, const SoftEdge& edge);

/// What lies in a pixel: the strips' areas, and how far along the edge.
struct StripPart {
  float area[kStrips] = {};
  float along = 0;  ///< from 0 to 1; of the last strip's centroid

  bool empty() const { return area[kStrips - 1] == 0; }
};

StripPart strip_part(const SoftStrip& strip, int x, int y);

/// In pixels, how far strips of a picture's soft edges may lie outside their triangles.
double strip_margin_px(const Picture& picture, const Affine& image_from_artboard);

}  // namespace sfumato::raster
