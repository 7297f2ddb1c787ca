#pragma once

#include <memory>
#include <vector>

#include "picture/field_source.hpp"
#include "raster/coverage/coverage.hpp"
#include "raster/kernels/span_kernels.hpp"
#include "raster/kernels/tile.hpp"
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
  /// source   null: values come from the patches. Else they come from the source at every pixel,
  ///          and nothing is antialiased.
  LayerPainter(const SpanKernels& kernels, bool antialias, const picture::FieldSource* source)
      : kernels_(kernels), antialias_(antialias), source_(source), mixed_(kernels) {}

  /// Paints code values and alpha, premultiplied, in the pixels of `rect`, which lie in one tile
  /// and contain everything that the triangles paint in that tile. The result is valid until the
  /// next call. Errors: the source's.
  Result<Tile> paint(const LayerView& layer, const ShadingInput& input,
                     const TriangleList& triangles, const PixelRect& rect);

  static constexpr std::size_t kBytes = 2 * TilePlanes::kBytes + MixedPixels::kMostBytes;

 private:
  void draw_patches(const LayerView& layer, const ShadingInput& input,
                    const TriangleList& triangles, const Tile& tile);
  Status read_source(const LayerView& layer, const ShadingInput& input, const Tile& tile);
  void add_read_shaders(const FieldView& field, const std::vector<float>& value,
                        const ShadingInput& input, const Tile& tile);
  void add_shaders(const LayerView& layer, const FieldView& field, const ShadingInput& input,
                   const TriangleList& triangles, const Tile& tile);
  void add_shader(const FieldView& field, int channel, const ShadingInput& input,
                  const Tile& weights, const Tile& tile);
  void add_run(const FieldView& field, int channel, const ShadingInput& input, int x, int y,
               const float* weight, int count, const Tile& tile);

  const SpanKernels& kernels_;
  bool antialias_;
  const picture::FieldSource* source_;
  picture::FieldPixels pixels_;
  TilePlanes shaded_, weights_;
  std::vector<std::uint32_t> weighted_;
  MixedPixels mixed_;
};

}  // namespace sfumato::raster
