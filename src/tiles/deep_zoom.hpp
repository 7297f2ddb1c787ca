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

/// Part `index` of `count` equal parts of a piece of work.
struct Shard {
  int index = 0;
  int count = 1;
};

/// Holds the inputs of a folder of tiles.
struct DeepZoomOptions {
  Pyramid pyramid;
  RasterOptions raster;        ///< the size of the pyramid; no window
  std::string path;            ///< of the description, "deep.dzi"; tiles go to "deep_files"
  std::string format = "png";  ///< the extension of tiles
  /// Identifies everything besides the pyramid that affects the pixels. All tiles of a folder have
  /// the same text.
  std::string fingerprint;
  Shard shard;
};

/// Encodes a tile as the bytes of a file; may change the tile. Several threads call it at once,
/// each with its own Context.
using EncodeTile = FunctionRef<Result<std::vector<std::uint8_t>>(Context& context, Image& tile)>;

/// Holds counts of the work done.
struct DeepZoomStats {
  std::uint64_t tiles = 0;           ///< written
  std::uint64_t blocks = 0;          ///< of this shard
  std::uint64_t skipped_blocks = 0;  ///< of these, blocks that existed already
  std::uint64_t bytes = 0;           ///< of the tiles written
};

/// Writes a picture as tiles for Deep Zoom viewers (OpenSeadragon and others), or one shard of
/// them. Every file appears whole or not at all. Blocks of tiles that exist are skipped, so a call
/// that was cut off can simply be repeated. Shards are independent: several may run at once, even
/// the same shard twice.
///
/// Errors: io (also if the folder has tiles of another picture or size), and as rasterize() and
/// `encode`. Memory: a block of about 2048 × 2048 pixels, and a tile for each thread.
Status write_deep_zoom(Context& context, const Picture& picture, const DeepZoomOptions& options,
                       EncodeTile encode, DeepZoomStats* stats);

}  // namespace sfumato::tiles
