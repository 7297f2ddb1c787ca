#include "tiles/big_tiff.hpp"

#include <tiffio.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <optional>
#include <vector>

#include "base/charge.hpp"
#include "base/native/atomic_file.hpp"
#include "base/native/posix.hpp"
#include "base/owned.hpp"
#include "base/public_verb.hpp"
#include "base/try.hpp"
#include "sfumato/base/native/file.hpp"
#include "tiles/level_painter.hpp"

namespace sfumato::tiles {
namespace {

constexpr int kDeflateLevel = 6;
constexpr int kHorizontalDifferences = 2;

/// Keeps the first complaint of libtiff, instead of printing it.
int keep_complaint(TIFF*, void* kept, const char*, const char* format, va_list arguments) {
  auto& text = *static_cast<std::string*>(kept);
  if (!text.empty()) return 1;
  std::array<char, 500> buffer{};
  std::vsnprintf(buffer.data(), buffer.size(), format, arguments);
  text = buffer.data();
  return 1;
}

class BigTiffWriter {
 public:
  BigTiffWriter(Context& context, const Picture& picture, const BigTiffOptions& options,
                BigTiffStats& stats)
      : context_(context),
        options_(options),
        stats_(stats),
        painter_(context, picture, options.raster) {}

  Status write();

 private:
  Status charge_tables();
  Status write_levels();
  Status open(int number);
  Status complaint() const;
  bool describe_level(int level);
  Status write_level(int level);
  Status write_block(const TileBlock& block);
  void fill_tile(const Image& image, const PixelRect& pixels, const PixelRect& tile);

  Context& context_;
  const BigTiffOptions& options_;
  BigTiffStats& stats_;
  LevelPainter painter_;
  ScopedCharge charge_;
  std::string complaint_;
  Owned<TIFF, TIFFClose> file_;
  std::vector<std::uint8_t> tile_;
  std::uint64_t done_ = 0;
};

Status BigTiffWriter::complaint() const {
  return make_error(StatusCode::io, "cannot be written: " + complaint_, {options_.path});
}

/// libtiff closes its own copy of the descriptor.
Status BigTiffWriter::open(int number) {
  const int copy = ::dup(number);
  if (copy < 0) return io_error(options_.path, "cannot be written", errno);
  TIFFOpenOptions* options = TIFFOpenOptionsAlloc();
  if (!options) {
    ::close(copy);
    return make_error(StatusCode::out_of_memory, "out of memory");
  }
  TIFFOpenOptionsSetErrorHandlerExtR(options, keep_complaint, &complaint_);
  TIFFOpenOptionsSetWarningHandlerExtR(options, keep_complaint, &complaint_);
  file_.reset(TIFFFdOpenExt(copy, options_.path.c_str(), "w8", options));
  TIFFOpenOptionsFree(options);
  if (file_) return ok_status();
  ::close(copy);
  return complaint();
}

bool BigTiffWriter::describe_level(int level) {
  TIFF* const file = file_.get();
  const Pyramid& pyramid = options_.pyramid;
  const int channels = channel_count(options_.raster.format);
  const bool is_reduced = level + 1 < pyramid.level_count();
  const std::uint16_t alpha[] = {EXTRASAMPLE_UNASSALPHA};
  return TIFFSetField(file, TIFFTAG_SUBFILETYPE, is_reduced ? FILETYPE_REDUCEDIMAGE : 0) != 0 &&
         TIFFSetField(file, TIFFTAG_IMAGEWIDTH, pyramid.level_width(level)) != 0 &&
         TIFFSetField(file, TIFFTAG_IMAGELENGTH, pyramid.level_height(level)) != 0 &&
         TIFFSetField(file, TIFFTAG_TILEWIDTH, pyramid.tile_side) != 0 &&
         TIFFSetField(file, TIFFTAG_TILELENGTH, pyramid.tile_side) != 0 &&
         TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, 8) != 0 &&
         TIFFSetField(file, TIFFTAG_SAMPLESPERPIXEL, channels) != 0 &&
         (channels == 3 || TIFFSetField(file, TIFFTAG_EXTRASAMPLES, 1, alpha) != 0) &&
         TIFFSetField(file, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_RGB) != 0 &&
         TIFFSetField(file, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG) != 0 &&
         TIFFSetField(file, TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE) != 0 &&
         TIFFSetField(file, TIFFTAG_ZIPQUALITY, kDeflateLevel) != 0 &&
         TIFFSetField(file, TIFFTAG_PREDICTOR, kHorizontalDifferences) != 0 &&
         TIFFSetField(file, TIFFTAG_SOFTWARE, "Sfumato") != 0;
}

/// A tile that reaches beyond the image repeats its last pixels, which compress to almost nothing.
void BigTiffWriter::fill_tile(const Image& image, const PixelRect& pixels, const PixelRect& tile) {
  const auto side = static_cast<std::size_t>(options_.pyramid.tile_side);
  const std::size_t pixel = image.row_bytes() / static_cast<std::size_t>(image.width);
  const std::size_t row = side * pixel, shown = static_cast<std::size_t>(tile.x1 - tile.x0) * pixel;
  for (std::size_t y = 0; y < side; ++y) {
    std::uint8_t* const to = tile_.data() + y * row;
    const int from_row = std::min(tile.y0 + static_cast<int>(y), tile.y1 - 1) - pixels.y0;
    std::memcpy(to,
                image.bytes.data() + static_cast<std::size_t>(from_row) * image.row_bytes() +
                    static_cast<std::size_t>(tile.x0 - pixels.x0) * pixel,
                shown);
    for (std::size_t i = shown; i < row; ++i) to[i] = to[i - pixel];
  }
}

Status BigTiffWriter::write_block(const TileBlock& block) {
  const Pyramid& pyramid = options_.pyramid;
  const PixelRect pixels = block_pixels(pyramid, block);
  SFUMATO_TRY_ASSIGN(const Image* image, painter_.paint(pyramid, block.level, pixels));
  const auto columns = static_cast<std::uint32_t>(pyramid.columns(block.level));
  for (int row = block.row0; row < block.row0 + block.rows; ++row) {
    for (int column = block.column0; column < block.column0 + block.columns; ++column) {
      if (context_.cancelled()) return context_.cancel_status();
      fill_tile(*image, pixels, pyramid.tile(block.level, column, row));
      const std::uint32_t index =
          static_cast<std::uint32_t>(row) * columns + static_cast<std::uint32_t>(column);
      const auto bytes = static_cast<tmsize_t>(tile_.size());
      if (TIFFWriteEncodedTile(file_.get(), index, tile_.data(), bytes) != bytes) {
        return complaint();
      }
      ++stats_.tiles;
    }
  }
  return ok_status();
}

Status BigTiffWriter::write_level(int level) {
  if (!describe_level(level)) return complaint();
  const std::uint64_t all = block_count(options_.pyramid);
  for (std::uint64_t index = 0; index < all; ++index) {
    const TileBlock block = block_at(options_.pyramid, index);
    if (block.level < level) break;
    if (block.level > level) continue;
    SFUMATO_TRY(write_block(block));
    ++done_;
    if (context_.progress) {
      context_.progress->report("tiles", static_cast<double>(done_) / static_cast<double>(all));
    }
  }
  ++stats_.levels;
  return TIFFWriteDirectory(file_.get()) == 1 ? ok_status() : complaint();
}

/// The memory of libtiff: its table entry for each tile of a level, and one tile.
Status BigTiffWriter::charge_tables() {
  constexpr std::uint64_t kMostTiles = 0xffffffff, kBytesPerTile = 16;
  const Pyramid& pyramid = options_.pyramid;
  const int last = pyramid.level_count() - 1;
  const std::uint64_t tiles = std::uint64_t{1} * static_cast<unsigned>(pyramid.columns(last)) *
                              static_cast<unsigned>(pyramid.rows(last));
  if (tiles > kMostTiles) {
    return make_error(StatusCode::limit, "more tiles than a TIFF holds, 4,294,967,295");
  }
  const auto side = static_cast<std::size_t>(pyramid.tile_side);
  const std::size_t bytes =
      side * side * static_cast<std::size_t>(channel_count(options_.raster.format));
  SFUMATO_TRY(charge_.add(context_, kBytesPerTile * tiles + 2 * bytes, "the table of a TIFF"));
  tile_.resize(bytes);
  return ok_status();
}

Status BigTiffWriter::write_levels() {
  const Pyramid& pyramid = options_.pyramid;
  for (int level = pyramid.level_count() - 1; level >= 0; --level) {
    SFUMATO_TRY(write_level(level));
    if (pyramid.columns(level) == 1 && pyramid.rows(level) == 1) break;
  }
  return ok_status();
}

Status BigTiffWriter::write() {
  const WriteSignalGuard guard;
  SFUMATO_TRY(charge_tables());
  const std::string path = without_links(options_.path);
  SFUMATO_TRY_ASSIGN(const std::optional<unsigned>& mode, mode_of_replaced(path));
  AtomicFile target(path);
  Status status = target.open(mode);
  if (status) status = open(target.number());
  if (status) status = write_levels();
  file_.reset();  // which may write
  if (status && !complaint_.empty()) status = complaint();
  return status ? target.commit() : status;
}

}  // namespace

Status write_big_tiff(Context& context, const Picture& picture, const BigTiffOptions& options,
                      BigTiffStats* stats) {
  BigTiffStats own;
  return public_verb(context, [&] {
    return BigTiffWriter(context, picture, options, stats ? *stats : own).write();
  });
}

}  // namespace sfumato::tiles
