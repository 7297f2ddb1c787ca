#include <algorithm>
#include <atomic>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/charge.hpp"
#include "base/parallel.hpp"
#include "base/public_verb.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "picture/check_picture.hpp"
#include "raster/compositor.hpp"
#include "raster/coverage/soft_strip.hpp"
#include "raster/kernels/span_kernels.hpp"
#include "raster/layers/layer_view.hpp"
#include "raster/layers/overlay.hpp"
#include "raster/options.hpp"
#include "raster/paint_list.hpp"
#include "raster/rasterize_into.hpp"

namespace sfumato {
namespace {

using raster::PaintList;
using raster::PaintPlan;
using raster::Tile;
using raster::TileGrid;

/// The input for painting a tile.
struct TileJob {
  Context* context = nullptr;
  const RasterOptions* options = nullptr;
  const raster::SpanKernels* kernels = nullptr;
  PaintList list;
  raster::Backdrop backdrop;
  raster::ImageTarget target;

  bool has_alpha() const { return channel_count(target.format) == 4; }
};

/// The workspace for painting a tile.
class TilePainter {
 public:
  explicit TilePainter(const TileJob& job)
      : job_(job),
        planes_(std::make_unique_for_overwrite<float[]>(raster::kTileFloats *
                                                        (job.has_alpha() ? 4 : 3))),
        compositor_(*job.context, job.list, *job.kernels, job.options->antialias) {}

  /// Returns the memory of one, with an overlay.
  static std::size_t bytes(const PaintList& list) {
    return 6 * raster::kTileFloats * sizeof(float) + raster::Compositor::bytes(list);
  }

  Status paint(std::size_t tile_index) {
    const Tile tile = begin(tile_index);
    SFUMATO_TRY(compositor_.paint(tile_index, tile));
    const bool is_mixed = job_.backdrop.alpha < 1 || !job_.list.is_plain();
    if (tile.alpha && is_mixed) job_.kernels->unpremultiply(tile);
    if (job_.options->mesh_overlay) paint_overlay(tile_index, tile);
    job_.kernels->write_pixels(tile, job_.target);
    return ok_status();
  }

 private:
  Tile begin(std::size_t tile_index);
  void paint_overlay(std::size_t tile_index, const Tile& tile);

  const TileJob& job_;
  std::unique_ptr<float[]> planes_;
  raster::Compositor compositor_;
  raster::Overlay overlay_;
  std::vector<std::uint32_t> triangles_;
};

/// Returns the tile with only the backdrop in it.
Tile TilePainter::begin(std::size_t tile_index) {
  const PixelRect rect = raster::tile_rect(job_.list.grid(), tile_index);
  Tile tile{rect.x0, rect.y0, rect.x1 - rect.x0, rect.y1 - rect.y0, {}, nullptr};
  float* plane = planes_.get();
  const Rgb& backdrop = job_.backdrop.color;
  const float color[3] = {backdrop.r, backdrop.g, backdrop.b};
  for (int c = 0; c < 3; ++c) {
    tile.color[c] = plane + c * raster::kTileFloats;
    std::fill_n(tile.color[c], raster::kTileFloats, color[c]);
  }
  if (job_.has_alpha()) {
    tile.alpha = plane + 3 * raster::kTileFloats;
    std::fill_n(tile.alpha, raster::kTileFloats, job_.backdrop.alpha);
  }
  return tile;
}

void TilePainter::paint_overlay(std::size_t tile_index, const Tile& tile) {
  const PaintList& list = job_.list;
  const int row = static_cast<int>(tile_index / static_cast<std::size_t>(list.grid().columns()));
  overlay_.clear();
  for (std::uint32_t index : list.row(row)) {
    const raster::ListedItem& listed = list.item(index);
    if (listed.item->is_instance())
      overlay_.add(listed.item->layer, list.triangles(listed, tile_index, &triangles_), tile);
  }
  overlay_.paint(tile);
}

/// Painters that no thread uses, passed from tile to tile.
class PainterPool {
 public:
  PainterPool(const TileJob& job, int thread_count)
      : job_(job), idle_(static_cast<std::size_t>(thread_count)) {}
  ~PainterPool() {
    for (std::atomic<TilePainter*>& slot : idle_) std::unique_ptr<TilePainter>(slot.load());
  }

  std::unique_ptr<TilePainter> take() {
    for (std::atomic<TilePainter*>& slot : idle_)
      if (TilePainter* painter = slot.exchange(nullptr)) {
        return std::unique_ptr<TilePainter>(painter);
      }
    return std::make_unique<TilePainter>(job_);
  }

  void give_back(std::unique_ptr<TilePainter> painter) {
    for (std::atomic<TilePainter*>& slot : idle_) {
      TilePainter* none = nullptr;
      if (slot.compare_exchange_strong(none, painter.get())) {
        static_cast<void>(painter.release());
        return;
      }
    }
  }

 private:
  const TileJob& job_;
  std::vector<std::atomic<TilePainter*>> idle_;
};

/// The bytes of a band, which is painted at a time.
constexpr std::size_t kBandBytes = std::size_t{4} << 20;

/// The bytes of an image. Their room is charged to `memory`, and they are made band by band.
struct ImageBytes {
  TableMemory& memory;
  Image& image;
};

/// Paints the tiles in bands, from the top. While the tiles of a band are painted, the bytes of the
/// next band are made: touching the memory of a large image takes a third of the time, and no other
/// thread would share the time if it was done before.
class ImagePainting {
 public:
  /// to_make: the memory that the job's target points to; null: it exists already.
  ImagePainting(Context& context, const TileJob& job, const ImageBytes* to_make)
      : context_(context), job_(job), to_make_(to_make), pool_(job, context.thread_count()) {}

  Status paint();

 private:
  Status make_bytes(std::size_t end_row);
  Status paint_tile(std::size_t tile);

  Context& context_;
  const TileJob& job_;
  const ImageBytes* to_make_;
  PainterPool pool_;
  std::atomic<std::size_t> done_{0};
};

/// Makes the bytes of all rows of tiles above `end_row`.
Status ImagePainting::make_bytes(std::size_t end_row) {
  if (!to_make_) return ok_status();
  Image& image = to_make_->image;
  const TileGrid& grid = job_.list.grid();
  const std::size_t bottom =
      (static_cast<std::size_t>(grid.first_row()) + end_row) * raster::kTileHeight;
  const std::size_t rows = std::min(bottom - static_cast<std::size_t>(grid.window.y0),
                                    static_cast<std::size_t>(image.height));
  return to_make_->memory.resize(context_, image.bytes, rows * image.row_bytes());
}

Status ImagePainting::paint_tile(std::size_t tile) {
  std::unique_ptr<TilePainter> painter = pool_.take();
  Status status = painter->paint(tile);
  pool_.give_back(std::move(painter));
  const std::size_t so_far = done_.fetch_add(1) + 1;
  if (context_.progress) {
    const auto count = static_cast<double>(job_.list.grid().tile_count());
    context_.progress->report("rasterise", static_cast<double>(so_far) / count);
  }
  return status;
}

Status ImagePainting::paint() {
  const auto rows = static_cast<std::size_t>(job_.list.grid().rows());
  const auto columns = static_cast<std::size_t>(job_.list.grid().columns());
  const std::size_t band =
      std::max(kBandBytes / raster::kTileHeight / job_.target.row_bytes, std::size_t{1});
  SFUMATO_TRY(make_bytes(band));
  for (std::size_t row = 0; row < rows; row += band) {
    const std::size_t first = row * columns, count = std::min(band, rows - row) * columns;
    SFUMATO_TRY(try_parallel_for(context_, count + 1, 1, [&](std::size_t i, std::size_t) {
      return i == 0 ? make_bytes(row + 2 * band) : paint_tile(first + i - 1);
    }));
  }
  return ok_status();
}

/// The input of drawing besides the options.
struct Drawing {
  const Picture& picture;
  const std::optional<Rgb>& own_background;  ///< for options without a background
};

/// Makes a plan. The picture and the options have not been checked against each other.
Result<PaintPlan> make_plan(Context& context, const Picture& picture, const RasterOptions& options,
                            bool has_blocks) {
  SFUMATO_TRY(picture::check_picture(context, picture, picture::PictureUse::pixels));
  SFUMATO_TRY_ASSIGN(const Affine& image_from_artboard,
                     raster::image_from_artboard(picture, options));
  double margin_px = options.mesh_overlay ? raster::kOverlayReachPx + 1 : 0;
  if (options.antialias) {
    margin_px = std::max(margin_px, raster::edge_margin_px(picture, image_from_artboard));
  }
  const TileGrid grid = raster::grid_of(options);
  return PaintPlan::create(context, picture,
                           {image_from_artboard, grid.width, grid.height, margin_px, has_blocks});
}

/// Draws a window into the target, whose bytes exist or are `to_make`. The options are the plan's,
/// and were checked.
Status draw_window(Context& context, const PaintPlan& plan, const Drawing& drawing,
                   const RasterOptions& options, const TileGrid& grid,
                   const raster::ImageTarget& target, const ImageBytes* to_make) {
  TileJob job;
  job.options = &options;
  job.context = &context;
  job.kernels = &raster::span_kernels(context.simd);
  job.backdrop = raster::choose_backdrop(options, drawing.own_background);
  job.target = target;
  job.target.window = grid.window;
  SFUMATO_TRY_ASSIGN(job.list, PaintList::create(context, plan, grid));
  ScopedCharge tile_charge;
  SFUMATO_TRY(tile_charge.add(
      context, static_cast<std::size_t>(context.thread_count()) * TilePainter::bytes(job.list),
      "tiles of the image"));
  return ImagePainting(context, job, to_make).paint();
}

/// Draws a picture. The options are checked.
Status draw_into(Context& context, const Drawing& drawing, const RasterOptions& options,
                 const raster::ImageTarget& target, const ImageBytes* to_make) {
  SFUMATO_TRY_ASSIGN(const PaintPlan& plan, make_plan(context, drawing.picture, options, false));
  return draw_window(context, plan, drawing, options, raster::grid_of(options), target, to_make);
}

Result<Image> draw(Context& context, const Drawing& drawing, const RasterOptions& options) {
  SFUMATO_TRY(raster::check_options(context.limits, options));
  Image image{options.width, options.height, options.format, {}};
  const std::size_t image_bytes = image.row_bytes() * static_cast<std::size_t>(options.height);
  TableMemory memory("the image");
  SFUMATO_TRY(memory.reserve(context, image.bytes, image_bytes));
  const ImageBytes to_make{memory, image};
  const raster::ImageTarget target{image.bytes.data(), image.row_bytes(), options.format,
                                   options.dither};
  SFUMATO_TRY(draw_into(context, drawing, options, target, &to_make));
  return image;
}

/// Checks an image that the caller owns.
Status check_target(const RasterOptions& options, const std::uint8_t* pixels,
                    std::size_t row_bytes) {
  if (!pixels) return make_error(StatusCode::bad_input, "no memory for the pixels given");
  const std::size_t least = Image{options.width, options.height, options.format, {}}.row_bytes();
  if (row_bytes >= least) return ok_status();
  return make_error(StatusCode::bad_input, std::to_string(row_bytes) +
                                               " bytes given for a row of pixels; expected " +
                                               std::to_string(least) + " at least");
}

/// Checks the options, and draws into the caller's pixels.
template <class Draw>
Status draw_to_caller(Context& context, const RasterOptions& options, std::uint8_t* pixels,
                      std::size_t row_bytes, const Draw& draw) {
  return public_verb(context, [&] {
    SFUMATO_TRY(raster::check_options(context.limits, options));
    SFUMATO_TRY(check_target(options, pixels, row_bytes));
    return draw(raster::ImageTarget{pixels, row_bytes, options.format, options.dither});
  });
}

}  // namespace

Result<Image> rasterize(Context& context, const Picture& picture, const RasterOptions& options) {
  return raster::rasterize_on(context, picture, options, picture.background);
}

Result<Image> raster::rasterize_on(Context& context, const Picture& picture,
                                   const RasterOptions& options,
                                   const std::optional<Rgb>& own_background) {
  return public_verb(context, [&] { return draw(context, {picture, own_background}, options); });
}

Status raster::rasterize_into_on(Context& context, const Picture& picture,
                                 const RasterOptions& options,
                                 const std::optional<Rgb>& own_background, std::uint8_t* pixels,
                                 std::size_t row_bytes) {
  return draw_to_caller(context, options, pixels, row_bytes, [&](const ImageTarget& target) {
    return draw_into(context, {picture, own_background}, options, target, nullptr);
  });
}

Status rasterize_into(Context& context, const Picture& picture, const RasterOptions& options,
                      std::uint8_t* pixels, std::size_t row_bytes) {
  return raster::rasterize_into_on(context, picture, options, picture.background, pixels,
                                   row_bytes);
}

struct PreparedRaster::Parts {
  RasterOptions options;
  PaintPlan plan;
};

PreparedRaster& PreparedRaster::operator=(PreparedRaster&& other) noexcept {
  std::swap(parts_, other.parts_);
  return *this;
}

PreparedRaster::~PreparedRaster() {
  const std::unique_ptr<Parts> parts(parts_);
}

Result<PreparedRaster> PreparedRaster::create(Context& context, const Picture& picture,
                                              const RasterOptions& options) {
  return public_verb(context, [&]() -> Result<PreparedRaster> {
    SFUMATO_TRY(raster::check_whole(options));
    SFUMATO_TRY_ASSIGN(auto&& plan, make_plan(context, picture, options, true));
    return PreparedRaster(std::make_unique<Parts>(Parts{options, std::move(plan)}).release());
  });
}

Status PreparedRaster::paint(Context& context, int x, int y, int width, int height,
                             std::uint8_t* pixels, std::size_t row_bytes) const {
  if (!parts_) return make_error(StatusCode::bad_input, "a prepared picture that was moved away");
  RasterOptions options = parts_->options;
  options.window = RasterWindow{x, y, options.width, options.height};
  options.width = width;
  options.height = height;
  const Picture& picture = parts_->plan.picture();
  return draw_to_caller(context, options, pixels, row_bytes,
                        [&](const raster::ImageTarget& target) {
                          return draw_window(context, parts_->plan, {picture, picture.background},
                                             options, raster::grid_of(options), target, nullptr);
                        });
}

}  // namespace sfumato
