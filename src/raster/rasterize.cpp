#include "raster/rasterize.hpp"

#include <algorithm>
#include <atomic>
#include <memory>
#include <utility>
#include <vector>

#include "raster/coverage.hpp"
#include "raster/layer_view.hpp"
#include "raster/options.hpp"
#include "raster/overlay.hpp"
#include "raster/span_kernels.hpp"
#include "raster/tile_bins.hpp"

namespace sfumato {
namespace {

using raster::LayerView;
using raster::Tile;
using raster::TileBins;
using raster::TileGrid;

/// One instance of the stack, ready to be painted.
struct PaintedInstance {
  LayerView layer;
  TileBins bins;
};

/// Everything that the painting of a tile reads.
struct Scene {
  const RasterOptions* options = nullptr;
  const raster::SpanKernels* kernels = nullptr;
  std::vector<PaintedInstance> stack;
  raster::Backdrop backdrop;
  TileGrid grid;
  raster::ImageTarget target;
};

Status prepare_stack(Context& context, const Picture& picture, const RasterOptions& options,
                     Scene* scene) {
  Status status = raster::check_picture(picture);
  if (!status) return status;
  const Result<Affine> image_from_artboard = raster::image_from_artboard(picture, options);
  if (!image_from_artboard) return image_from_artboard.status();
  const double margin_px = options.mesh_overlay ? raster::kOverlayReachPx + 1 : 0;
  for (const PictureItem& item : picture.stack) {
    const auto* instance_item = std::get_if<PatchInstance>(&item);
    if (!instance_item) continue;
    const PatchInstance& instance = *instance_item;
    PaintedInstance painted;
    painted.layer = raster::view_instance(picture, instance, *image_from_artboard);
    Result<TileBins> bins = raster::bin_triangles(context, painted.layer,
                                                  picture.layers[instance.layer].triangle_count(),
                                                  scene->grid, margin_px);
    if (!bins) return bins.status();
    painted.bins = std::move(*bins);
    scene->stack.push_back(std::move(painted));
  }
  return ok_status();
}

/// The most that a Scratch holds.
constexpr std::size_t kScratchBytes =
    6 * raster::kTileFloats * sizeof(float) + raster::MixedPixels::kMostBytes;

/// What a tile is painted with; taken and given back for each range of tiles.
struct Scratch {
  explicit Scratch(bool has_alpha)
      : planes(std::make_unique_for_overwrite<float[]>(raster::kTileFloats * (has_alpha ? 4 : 3))) {
  }

  std::unique_ptr<float[]> planes;
  raster::MixedPixels mixed;
  raster::Overlay overlay;
};

Tile make_tile(const Scene& scene, std::size_t index, Scratch* scratch) {
  const std::size_t columns = static_cast<std::size_t>(scene.grid.columns());
  Tile tile;
  tile.x0 = static_cast<int>(index % columns) * raster::kTileWidth;
  tile.y0 = static_cast<int>(index / columns) * raster::kTileHeight;
  tile.width = std::min(raster::kTileWidth, scene.grid.width - tile.x0);
  tile.height = std::min(raster::kTileHeight, scene.grid.height - tile.y0);
  float* plane = scratch->planes.get();
  const float color[3] = {scene.backdrop.color.r, scene.backdrop.color.g, scene.backdrop.color.b};
  for (int c = 0; c < 3; ++c) {
    tile.color[c] = plane + c * raster::kTileFloats;
    std::fill_n(tile.color[c], raster::kTileFloats, color[c]);
  }
  if (channel_count(scene.target.format) == 4) {
    tile.alpha = plane + 3 * raster::kTileFloats;
    std::fill_n(tile.alpha, raster::kTileFloats, scene.backdrop.alpha);
  }
  return tile;
}

void paint_tile(const Scene& scene, std::size_t index, Scratch* scratch) {
  const Tile tile = make_tile(scene, index, scratch);
  for (const PaintedInstance& instance : scene.stack) {
    const raster::TriangleList triangles = instance.bins.of(index);
    scene.kernels->draw_triangles(instance.layer, triangles, tile);
    if (scene.options->antialias) scratch->mixed.paint(instance.layer, triangles, tile);
  }
  if (scene.options->mesh_overlay) {
    scratch->overlay.clear();
    for (const PaintedInstance& instance : scene.stack)
      scratch->overlay.add(instance.layer, instance.bins.of(index), tile);
    scratch->overlay.paint(tile);
  }
  scene.kernels->write_pixels(tile, scene.target);
}

Status paint_tiles(Context& context, const Scene& scene) {
  const bool has_alpha = channel_count(scene.target.format) == 4;
  std::atomic<std::size_t> done{0};
  const std::size_t count = scene.grid.tile_count();
  return parallel_for(context, count, 1, [&](std::size_t begin, std::size_t end) {
    Scratch scratch(has_alpha);
    for (std::size_t i = begin; i < end; ++i) paint_tile(scene, i, &scratch);
    if (!context.progress) return;
    const std::size_t so_far = done.fetch_add(end - begin) + (end - begin);
    context.progress->report("rasterise", static_cast<double>(so_far) / count);
  });
}

}  // namespace

Result<Image> rasterize(Context& context, const Picture& picture, const RasterOptions& options) {
  Status status = raster::check_size(options);
  if (!status) return status;
  Scene scene;
  scene.options = &options;
  scene.kernels = &raster::span_kernels(context.simd);
  scene.grid = {options.width, options.height};
  scene.backdrop = raster::choose_backdrop(options, picture.background);

  Image image{options.width, options.height, options.format, {}};
  const std::size_t image_bytes = image.row_bytes() * options.height;
  ScopedCharge charge;
  status = charge.add(context, image_bytes, "the image");
  if (!status) return status;
  status = charge.add(context, context.thread_count() * kScratchBytes, "tiles of the image");
  if (!status) return status;
  status = prepare_stack(context, picture, options, &scene);
  if (!status) return status;
  image.bytes.resize(image_bytes);
  scene.target = {image.bytes.data(), image.row_bytes(), options.format, options.dither};
  status = paint_tiles(context, scene);
  if (!status) return status;
  return image;
}

}  // namespace sfumato
