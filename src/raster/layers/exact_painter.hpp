#pragma once

#include <span>
#include <vector>

#include "raster/coverage/coverage.hpp"
#include "raster/kernels/span_kernels.hpp"
#include "raster/layers/exact_blocks.hpp"
#include "raster/layers/exact_points.hpp"
#include "raster/layers/exact_shader.hpp"

namespace sfumato::raster {

/// Paints instances of layers with exact fields, one after another: reads the fields at the centre
/// of each pixel in a triangle and, if curves are antialiased, at the parts of the pixels that they
/// cut.
class ExactPainter {
 public:
  ExactPainter(const SpanKernels& kernels, bool antialias)
      : kernels_(kernels), antialias_(antialias) {}

  /// Paints an opaque layer onto the tile. Errors: limit, cancelled.
  Status paint_straight(Context& context, const LayerView& layer, const Affine& layer_from_image,
                        const TriangleList& triangles, const Tile& tile, MixedPixels* mixed);

  /// @name The steps for other layers
  /// @{

  /// Writes colours and opacities, without shaders, into the pixels that are not mixed, and reads
  /// the fields in the mixed ones. Errors: limit, cancelled.
  Status paint_fields(Context& context, const LayerView& layer, const Affine& layer_from_image,
                      const TriangleList& triangles, const Tile& tile, MixedPixels* mixed);

  /// Writes the channels [first, first + 4) of a field into those pixels; 0 beyond its last.
  void write_channels(const FieldView& field, int first, const Tile& tile) const;

  /// Makes the pixels clear that see no colour, after opacity shaders were added.
  void clear_unseen(const Tile& tile) const;

  /// Returns the shader of the mixed pixels. The arguments must outlive it.
  ExactShader shader(const LayerView& layer, const PointShader* shading) const {
    return {layer, points_, shading};
  }
  /// @}

 private:
  PixelMask usable_pixels(const LayerView& layer, const TriangleList& triangles, const Tile& tile,
                          const PixelMask* mixed) const;
  void list_all(const PixelMask& usable, const Tile& tile);
  void add_pixels(std::span<const std::uint32_t> pixels, const Tile& tile, ExactPoints* points);
  Status read(Context& context, ExactPoints* points);
  void write_colors(const LayerView& layer, const ExactPoints& points, const Tile& tile);
  bool is_in_rounds(const LayerView& layer) const;
  Status gather_later_rounds(Context& context, const LayerView& layer,
                             const Affine& layer_from_image, const Tile& tile);

  const SpanKernels& kernels_;
  bool antialias_;
  ExactPoints points_;
  ExactPoints more_points_;  ///< of the rounds after the first
  ExactBlocks blocks_;
  std::vector<std::uint32_t> pixel_;  ///< for the first points: their offsets in the tile's planes
  std::size_t charged_ = 0;
  TableMemory memory_{"exact pixels"};
};

}  // namespace sfumato::raster
