#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/function_ref.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"
#include "sfumato/raster/rasterize.hpp"
#include "tiles/pyramid.hpp"

namespace sfumato::tiles {

/// Part `index` of `count` equal ones of a piece of work.
struct Shard {
  int index = 0;
  int count = 1;
};

/// What a folder of tiles is made of.
struct DeepZoomOptions {
  Pyramid pyramid;
  RasterOptions raster;        ///< the size is that of the pyramid; no window
  std::string path;            ///< of the description, "deep.dzi"; tiles go to "deep_files"
  std::string format = "png";  ///< the extension of tiles
  /// What besides the pyramid decides on the pixels; a folder keeps tiles of one such text.
  std::string fingerprint;
  Shard shard;
};

/// A tile, which it may change, as a file's bytes. Called from several threads at once, each with a
/// Context of its own.
using EncodeTile = FunctionRef<Result<std::vector<std::uint8_t>>(Context& context, Image& tile)>;

/// What was done.
struct DeepZoomStats {
  std::uint64_t tiles = 0;           ///< written
  std::uint64_t blocks = 0;          ///< of this shard
  std::uint64_t skipped_blocks = 0;  ///< of these, that were there already
  std::uint64_t bytes = 0;           ///< of the tiles written
};

/// Writes a picture as tiles for Deep Zoom viewers (OpenSeadragon and others), or one shard of
/// them. Every file appears whole or not at all; blocks of tiles that are there are skipped, so
/// that a call that was cut off is simply made again. Shards know nothing of each other: several
/// may run at once, also the same one twice.
///
/// Errors: io (also where the folder has tiles of another picture or size), those of rasterize()
/// and of `encode`. Memory: a block of about 2048 × 2048 pixels, and a tile for each thread.
Status write_deep_zoom(Context& context, const Picture& picture, const DeepZoomOptions& options,
                       EncodeTile encode, DeepZoomStats* stats);

}  // namespace sfumato::tiles
