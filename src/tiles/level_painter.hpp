#pragma once

#include <optional>

#include "base/pixel_rect.hpp"
#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/raster/rasterize.hpp"
#include "tiles/pyramid.hpp"

namespace sfumato::tiles {

/// Paints parts of the levels of a pyramid. Each level is the picture at that size, byte for byte
/// as rasterize() makes it, not a reduction of a larger level.
class LevelPainter {
 public:
  /// raster: the size of the last level; no window
  LevelPainter(Context& context, const Picture& picture, const RasterOptions& raster)
      : context_(context), picture_(picture), raster_(raster) {}
  LevelPainter(const LevelPainter&) = delete;
  LevelPainter& operator=(const LevelPainter&) = delete;

  /// Paints the pixels of a rectangle of a level. They are valid until the next call. Each level is
  /// prepared once if levels are painted one after another. Errors: as rasterize().
  Result<const Image*> paint(const Pyramid& pyramid, int level, const PixelRect& rect);

 private:
  Status prepare(const Pyramid& pyramid, int level);

  Context& context_;
  const Picture& picture_;
  RasterOptions raster_;
  int level_ = -1;
  std::optional<PreparedRaster> prepared_;
  Image image_;
  TableMemory memory_{"a block of tiles"};
};

/// Copies a part of an image, whose corner is at (x, y) in it. `tile` already has the size.
void copy_part(const Image& image, int x, int y, Image& tile);

}  // namespace sfumato::tiles
