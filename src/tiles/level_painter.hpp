#pragma once

#include <optional>

#include "base/pixel_rect.hpp"
#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/raster/rasterize.hpp"
#include "tiles/pyramid.hpp"

namespace sfumato::tiles {

/// Paints parts of the levels of a pyramid. Each level is the picture as it is at that size, byte
/// for byte what rasterize() makes of it, and no reduction of a larger one.
class LevelPainter {
 public:
  /// raster  the size is that of the last level; no window
  LevelPainter(Context& context, const Picture& picture, const RasterOptions& raster)
      : context_(context), picture_(picture), raster_(raster) {}
  LevelPainter(const LevelPainter&) = delete;
  LevelPainter& operator=(const LevelPainter&) = delete;

  /// The pixels of a rectangle of a level. They are good until the next call. Levels one after
  /// another are prepared once each. Errors: those of rasterize().
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

/// A part of an image, whose corner is at (x, y) in it. `tile` has the size and is as large
/// already.
void copy_part(const Image& image, int x, int y, Image& tile);

}  // namespace sfumato::tiles
