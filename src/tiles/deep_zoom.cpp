#include "tiles/deep_zoom.hpp"

#include <atomic>
#include <filesystem>
#include <system_error>

#include "base/native/atomic_file.hpp"
#include "base/native/folder.hpp"
#include "base/parallel.hpp"
#include "base/public_verb.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "sfumato/base/native/file.hpp"
#include "tiles/level_painter.hpp"

namespace sfumato::tiles {
namespace {

constexpr std::size_t kDescriptionBytes = std::size_t{1} << 16;

std::string description_text(const DeepZoomOptions& options) {
  const Pyramid& pyramid = options.pyramid;
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<Image xmlns=\"http://schemas.microsoft.com/deepzoom/2008\" Format=\"" +
         options.format + "\" Overlap=\"" + std::to_string(pyramid.overlap) + "\" TileSize=\"" +
         std::to_string(pyramid.tile_side) + "\">\n  <Size Width=\"" +
         std::to_string(pyramid.width) + "\" Height=\"" + std::to_string(pyramid.height) +
         "\"/>\n  <!-- " + options.fingerprint + " -->\n</Image>\n";
}

/// Returns whether the file exists. Errors: io if that cannot be determined.
Result<bool> is_there(const std::string& path) {
  std::error_code error;
  const auto type = std::filesystem::status(path, error).type();
  if (type == std::filesystem::file_type::not_found) return false;
  if (!error) return true;
  return make_error(StatusCode::io, "cannot be looked for: " + error.message(), {path});
}

class DeepZoomWriter {
 public:
  DeepZoomWriter(Context& context, const Picture& picture, const DeepZoomOptions& options,
                 EncodeTile encode, DeepZoomStats& stats)
      : context_(context),
        options_(options),
        encode_(encode),
        stats_(stats),
        painter_(context, picture, options.raster),
        folder_(options.path.substr(0, options.path.size() - 4) + "_files") {}

  Status write();

 private:
  Status prepare();
  Status claim_description();
  std::string tile_path(const TileBlock& block, std::size_t tile) const;
  Status write_block(const TileBlock& block);
  Status write_tile(const TileBlock& block, std::size_t tile, const PixelRect& pixels,
                    const Image& image);
  void report(std::uint64_t done) const;

  Context& context_;
  const DeepZoomOptions& options_;
  EncodeTile encode_;
  DeepZoomStats& stats_;
  LevelPainter painter_;
  std::string folder_;
  std::atomic<std::uint64_t> bytes_ = 0;
};

/// Writes the description of the tiles, or checks that the existing description is the same. If
/// another call writes one at the same time, the first one counts.
Status DeepZoomWriter::claim_description() {
  const std::string text = description_text(options_);
  SFUMATO_TRY_ASSIGN(const bool exists, is_there(options_.path));
  if (!exists) {
    SFUMATO_TRY_ASSIGN(
        const bool created,
        create_file(without_links(options_.path),
                    {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}));
    if (created) return ok_status();
  }
  SFUMATO_TRY_ASSIGN(const std::string& there,
                     read_file(options_.path, kDescriptionBytes, &context_));
  if (there == text) return ok_status();
  return make_error(StatusCode::io,
                    "describes tiles of another picture, size or format; remove it and its "
                    "folder, or name another output",
                    {options_.path});
}

/// The description comes first: it identifies the picture of the tiles, so that tiles of another
/// picture are not mixed with them.
Status DeepZoomWriter::prepare() {
  SFUMATO_TRY(claim_description());
  SFUMATO_TRY(make_folder(folder_));
  for (int level = 0; level < options_.pyramid.level_count(); ++level) {
    SFUMATO_TRY(make_folder(folder_ + "/" + std::to_string(level)));
  }
  return ok_status();
}

std::string DeepZoomWriter::tile_path(const TileBlock& block, std::size_t tile) const {
  const auto columns = static_cast<std::size_t>(block.columns);
  return folder_ + "/" + std::to_string(block.level) + "/" +
         std::to_string(static_cast<std::size_t>(block.column0) + tile % columns) + "_" +
         std::to_string(static_cast<std::size_t>(block.row0) + tile / columns) + "." +
         options_.format;
}

Status DeepZoomWriter::write_tile(const TileBlock& block, std::size_t tile, const PixelRect& pixels,
                                  const Image& image) {
  const int columns = block.columns;
  const PixelRect rect =
      options_.pyramid.tile(block.level, block.column0 + static_cast<int>(tile) % columns,
                            block.row0 + static_cast<int>(tile) / columns);
  Image part{rect.x1 - rect.x0, rect.y1 - rect.y0, image.format, {}};
  const std::size_t bytes = part.row_bytes() * static_cast<std::size_t>(part.height);
  TableMemory memory("a tile");
  SFUMATO_TRY(memory.resize(context_, part.bytes, bytes));
  // Tiles are packed side by side, each with its share of the remaining memory.
  const Budget& budget = context_.budget;
  Context serial{.budget = Budget(budget.room() / static_cast<unsigned>(context_.thread_count())),
                 .limits = context_.limits,
                 .simd = context_.simd,
                 .outer = &context_};
  copy_part(image, rect.x0 - pixels.x0, rect.y0 - pixels.y0, part);
  SFUMATO_TRY_ASSIGN(const std::vector<std::uint8_t>& file, encode_(serial, part));
  bytes_ += file.size();
  // The last tile marks the block as complete, so it is written after the others are safe.
  const bool is_last = tile + 1 == block.tile_count();
  if (is_last) {
    SFUMATO_TRY(sync_file_system(folder_));
  }
  return replace_file(tile_path(block, tile), file,
                      is_last ? Durability::synced : Durability::fast);
}

Status DeepZoomWriter::write_block(const TileBlock& block) {
  const std::size_t last = block.tile_count() - 1;
  SFUMATO_TRY_ASSIGN(const bool is_done, is_there(tile_path(block, last)));
  if (is_done) {
    ++stats_.skipped_blocks;
    return ok_status();
  }
  const PixelRect pixels = block_pixels(options_.pyramid, block);
  SFUMATO_TRY_ASSIGN(const Image* image, painter_.paint(options_.pyramid, block.level, pixels));
  SFUMATO_TRY(try_parallel_for(context_, last, 1, [&](std::size_t begin, std::size_t) {
    return write_tile(block, begin, pixels, *image);
  }));
  SFUMATO_TRY(write_tile(block, last, pixels, *image));
  stats_.tiles += block.tile_count();
  return ok_status();
}

void DeepZoomWriter::report(std::uint64_t done) const {
  if (!context_.progress) return;
  context_.progress->report("tiles",
                            static_cast<double>(done) / static_cast<double>(stats_.blocks));
}

Status DeepZoomWriter::write() {
  const Shard& shard = options_.shard;
  const std::uint64_t all = block_count(options_.pyramid);
  const auto first = static_cast<std::uint64_t>(shard.index),
             step = static_cast<std::uint64_t>(shard.count);
  stats_.blocks = (all + step - 1 - first) / step;
  SFUMATO_TRY(prepare());
  std::uint64_t done = 0;
  for (std::uint64_t index = first; index < all; index += step) {
    if (context_.cancelled()) return context_.cancel_status();
    SFUMATO_TRY(write_block(block_at(options_.pyramid, index)));
    report(++done);
  }
  stats_.bytes = bytes_;
  return ok_status();
}

}  // namespace

Status write_deep_zoom(Context& context, const Picture& picture, const DeepZoomOptions& options,
                       EncodeTile encode, DeepZoomStats* stats) {
  DeepZoomStats own;
  return public_verb(context, [&] {
    return DeepZoomWriter(context, picture, options, encode, stats ? *stats : own).write();
  });
}

}  // namespace sfumato::tiles
