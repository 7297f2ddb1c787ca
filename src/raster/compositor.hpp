#pragma once

#include <optional>
#include <vector>

#include "raster/coverage/coverage.hpp"
#include "raster/kernels/span_kernels.hpp"
#include "raster/layers/exact_painter.hpp"
#include "raster/layers/layer_painter.hpp"
#include "raster/paint_list.hpp"

namespace sfumato::raster {

/// Paints the stack of a picture into tiles, one after another. Opaque items are painted directly;
/// other layers and groups are painted separately, then blended where they painted.
class Compositor {
 public:
  /// Makes a compositor. All arguments must outlive it.
  Compositor(Context& context, const PaintList& list, const SpanKernels& kernels, bool antialias);

  /// Paints over the content of `root`, the whole tile. Errors: limit (exact pixels), cancelled;
  /// the tile is then partly painted.
  Status paint(std::size_t tile_index, const Tile& root);

  /// Returns the memory of one object.
  static std::size_t bytes(const PaintList& list);

 private:
  /// A target of painting: the tile itself, or an open group.
  struct Level {
    Tile tile;
    PixelRect painted;  ///< a group's pixels outside are undefined
  };

  Status paint_item(const ListedItem& listed, std::size_t tile_index);
  PixelRect pixels_of(const PaintItem& item, const TriangleList& triangles) const;
  Status paint_straight(const PaintItem& item, const TriangleList& triangles);
  Status paint_shaded(const PaintItem& item, const TriangleList& triangles);
  Status paint_stroke(const StrokePainter& stroke);
  void close_group(const PaintItem& item);
  /// Returns the pixels in `rect` of the uppermost level, for painting; transparent where nothing
  /// was painted.
  Tile target(const PixelRect& rect);

  Context& context_;
  const PaintList& list_;
  const SpanKernels& kernels_;
  bool antialias_;
  MixedPixels mixed_;
  ExactPainter exact_;
  std::optional<LayerPainter> layer_painter_;
  std::vector<TilePlanes> groups_;
  std::vector<Level> levels_;
  std::vector<float> opaque_;  ///< the alpha of a tile without alpha
  std::vector<std::uint32_t> triangles_;
};

}  // namespace sfumato::raster
