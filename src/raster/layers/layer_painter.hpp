#pragma once

#include <memory>
#include <vector>

#include "raster/coverage/coverage.hpp"
#include "raster/kernels/span_kernels.hpp"
#include "raster/kernels/tile.hpp"
#include "raster/layers/exact_painter.hpp"
#include "raster/shaders/point_shader.hpp"

namespace sfumato::raster {

/// Four planes of a tile, initially zero.
class TilePlanes {
 public:
  TilePlanes() : values_(std::make_unique<float[]>(4 * kTileFloats)) {}

  static constexpr std::size_t kBytes = 4 * kTileFloats * sizeof(float);

  /// Returns the pixels of `rect`, which is at most as large as a tile, with alpha.
  Tile tile(const PixelRect& rect) const;

 private:
  std::unique_ptr<float[]> values_;
};

/// Sets all four planes to 0.
void clear(const Tile& tile);

/// Shades the instances of layers, one after another and separately: colours and opacity from the
/// patches, image-domain shaders at every pixel, curves antialiased.
class LayerPainter {
 public:
  LayerPainter(const SpanKernels& kernels, bool antialias)
      : kernels_(kernels), antialias_(antialias), mixed_(kernels) {}

  /// Paints code values and alpha, premultiplied, in the pixels of `rect`, which lie in one tile
  /// and contain everything that the triangles paint in that tile. `exact` paints a layer with
  /// exact fields. The result is valid until the next call. Errors: limit (exact pixels),
  /// cancelled.
  Result<Tile> paint(Context& context, const LayerView& layer, const ShadingInput& input,
                     const TriangleList& triangles, const PixelRect& rect, ExactPainter* exact);

  static constexpr std::size_t kBytes = 2 * TilePlanes::kBytes + MixedPixels::kMostBytes;

 private:
  void draw_patches(const LayerView& layer, const ShadingInput& input,
                    const TriangleList& triangles, const Tile& tile);
  Status draw_exact(Context& context, const LayerView& layer, const ShadingInput& input,
                    const TriangleList& triangles, const Tile& tile, ExactPainter* exact);
  void add_exact_shaders(const FieldView& field, const ShadingInput& input, const Tile& tile,
                         const ExactPainter& exact);
  void add_shaders(const LayerView& layer, const FieldView& field, const ShadingInput& input,
                   const TriangleList& triangles, const Tile& tile);
  void add_shader(const FieldView& field, int channel, const ShadingInput& input,
                  const Tile& weights, const Tile& tile);
  void add_run(const FieldView& field, int channel, const ShadingInput& input, int x, int y,
               const float* weight, int count, const Tile& tile);

  const SpanKernels& kernels_;
  bool antialias_;
  TilePlanes shaded_, weights_;
  std::vector<std::uint32_t> weighted_;
  MixedPixels mixed_;
};

}  // namespace sfumato::raster
