#pragma once

#include "base/simd_level.hpp"
#include "raster/kernels/pixel_mask.hpp"
#include "raster/kernels/placed_triangles.hpp"
#include "raster/kernels/tile.hpp"
#include "sfumato/base/image.hpp"

namespace sfumato::raster {

/// The place and the format in the image where the pixels of a tile are written.
struct ImageTarget {
  std::uint8_t* bytes = nullptr;
  std::size_t row_bytes = 0;
  PixelFormat format = PixelFormat::rgb8;
  bool dither = false;  ///< 8-bit formats only; even areas are not dithered
  /// The pixels of the image that are written, the first of them to `bytes`.
  PixelRect window{0, 0, 1 << 30, 1 << 30};
};

/// The inner loops, compiled for one instruction set. All sets give the same bits.
struct SpanKernels {
  /// Places triangles of a layer, from 1 to PlacedTriangles::kMost of them.
  void (*place_triangles)(const LayerView& layer, const std::uint32_t* triangle, std::size_t count,
                          const Tile& tile, PlacedTriangles* placed);

  /// Returns the box of a list's triangles in the image; empty where there are none.
  Box (*box_of_triangles)(const LayerView& layer, const TriangleList& triangles);

  /// Paints each pixel whose centre lies in a triangle with the patch's value there. Triangles that
  /// share an edge use the same crossings with the rows, so that no pixel centre between them is
  /// left out. Pixels in `skipped`, unless that is null, may be left out: they are repainted later.
  void (*draw_triangles)(const LayerView& layer, const TriangleList& triangles, const Tile& tile,
                         const PixelMask* skipped);

  /// Does the same for a layer's colour and opacity: color and alpha, not premultiplied.
  void (*draw_color_opacity)(const LayerView& layer, const TriangleList& triangles,
                             const Tile& tile, const PixelMask* skipped);

  /// Does the same for channels [first_channel, first_channel + 4) of one of the layer's fields,
  /// into color and alpha; 0 beyond the field's last.
  void (*draw_weights)(const LayerView& layer, const FieldView& field, int first_channel,
                       const TriangleList& triangles, const Tile& tile);

  /// Sets, in an empty mask, each pixel that draw_triangles() paints.
  void (*cover_triangles)(const LayerView& layer, const TriangleList& triangles, const Tile& tile,
                          PixelMask* covered);

  /// Converts the results of these, a colour of `space` and an opacity, to the input of `blend`:
  /// code values and alpha, clamped to [0, 1] and premultiplied.
  void (*finish_shading)(InterpolationSpace space, const Tile& tile);

  /// Composites `source`, its alpha times `opacity`, onto `target`: the same pixels.
  void (*blend)(const Tile& source, float opacity, BlendMode mode, const Tile& target);

  /// Divides the colours of a tile with alpha by it; 0 where it is 0.
  void (*unpremultiply)(const Tile& tile);

  /// Clamps to [0, 1], dithers or rounds to nearest, and writes the tile's pixels to the image:
  /// those in its window.
  void (*write_pixels)(const Tile& tile, const ImageTarget& target);
};

/// Returns the kernels of one instruction set (span_isa.cpp).
const SpanKernels& span_kernels(LaneCount<4>);
const SpanKernels& span_kernels(LaneCount<8>);
const SpanKernels& span_kernels(LaneCount<16>);

/// Returns the kernels of a level, which must not be above detected_simd_level().
inline const SpanKernels& span_kernels(SimdLevel level) {
  return *pick_by_level(level, [](auto lanes) { return &span_kernels(lanes); });
}

}  // namespace sfumato::raster
