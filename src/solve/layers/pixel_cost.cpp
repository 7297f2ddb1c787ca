#include "solve/layers/pixel_cost.hpp"

#include <algorithm>

#include "solve/fields/nodes.hpp"

namespace sfumato::solve {
namespace {

/// Points that are gathered, fitted to drawings at 512 to 2048 pixels (bench/instructions). A point
/// of a patch counts more than once, because it needs mesh, layout and raster, too.
struct PatchPoints {
  double per_segment = 50;
  double per_gap = 60;  ///< for each part of a curve that is as long as the mean gap beside it
  double per_end = 600;
};
struct PixelPoints {
  double per_length = 13;  ///< for each pixel of a curve, on both sides
  double per_area = 1.0 / 28;
  double per_end = 300;
  double most_per_area = 2.2;
};

/// The sizes that determine what a layer costs, of the part in its window.
struct LayerSize {
  double segments = 0;
  double length = 0;  ///< of the segments, pixels
  double ends = 0;    ///< of open curves
  double area = 0;    ///< of the window, pixels
};

LayerSize size_of_layer(const curves::FlatCurves& flat, const Box& window, double pixel) {
  LayerSize size;
  size.area = window.width() * window.height() / (pixel * pixel);
  for (std::uint32_t v = 0; v < flat.vertex.size(); ++v) {
    if (!flat.begins_segment(v)) continue;
    const Vec2 from = flat.vertex[v], to = flat.vertex[v + 1];
    if (!window.contains(lerp(from, to, 0.5))) continue;
    ++size.segments;
    size.length += length(to - from) / pixel;
  }
  for (std::uint32_t c = 0; c < flat.curve_count(); ++c) {
    const Vec2 from = flat.vertex[flat.curve_begin[c]];
    const Vec2 to = flat.vertex[flat.curve_begin[c + 1] - 1];
    if (from == to) continue;
    size.ends += window.contains(from) + window.contains(to);
  }
  return size;
}

}  // namespace

bool pixels_cost_less(const curves::FlatCurves& flat, const Box& window, double pixel) {
  const LayerSize size = size_of_layer(flat, window, pixel);
  constexpr PatchPoints kPatch;
  constexpr PixelPoints kPixel;
  const double patches = kPatch.per_segment * size.segments +
                         kPatch.per_gap * size.length * size.length / size.area +
                         kPatch.per_end * size.ends;
  const double pixels =
      kPixel.per_length * size.length + kPixel.per_area * size.area + kPixel.per_end * size.ends;
  return std::min(pixels, kPixel.most_per_area * size.area) < patches;
}

bool has_plain_colors(const SampledFields& fields) {
  const curves::SegmentAttributes& colors = fields.color.attributes;
  if (fields.opacity || colors.base_channels > kOpacityChannel || !has_code_values(colors))
    return false;
  bool has_curves = false;
  for (std::uint32_t s = 0; s + 1 < colors.vertex.size(); ++s) {
    if (colors.curve[s] != colors.curve[s + 1]) continue;
    if (colors.left[s].kind != ShaderKind::curve_domain ||
        colors.right[s].kind != ShaderKind::curve_domain) {
      return false;
    }
    has_curves = true;
  }
  return has_curves;
}

}  // namespace sfumato::solve
