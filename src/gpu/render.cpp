#include "gpu/render.hpp"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "gpu/device.hpp"
#include "gpu/painter.hpp"
#include "gpu/scene.hpp"
#include "raster/check_picture.hpp"
#include "raster/layer_view.hpp"
#include "raster/options.hpp"
#include "raster/span_kernels.hpp"

namespace sfumato {
namespace {

using raster::PixelRect;

/// Side of what is painted at once, pixels of the image.
constexpr int kTileSide = 1024;

/// Four planes of one tile of the CPU's rasterizer.
struct Planes {
  std::vector<float> values = std::vector<float>(4 * raster::kTileFloats);

  float* plane(int c) { return values.data() + static_cast<std::size_t>(c) * raster::kTileFloats; }
};

/// Writes pixels as the CPU's rasterizer does: its formats, its rounding, its dither.
void write_pixels(const float* rgba, const PixelRect& rect, const raster::SpanKernels& kernels,
                  const raster::ImageTarget& target, Planes* planes) {
  const int width = rect.x1 - rect.x0;
  for (int y0 = rect.y0; y0 < rect.y1; y0 += raster::kTileHeight) {
    for (int x0 = rect.x0; x0 < rect.x1; x0 += raster::kTileWidth) {
      raster::Tile tile{x0,
                        y0,
                        std::min(raster::kTileWidth, rect.x1 - x0),
                        std::min(raster::kTileHeight, rect.y1 - y0),
                        {planes->plane(0), planes->plane(1), planes->plane(2)},
                        channel_count(target.format) == 4 ? planes->plane(3) : nullptr};
      for (int y = 0; y < tile.height; ++y) {
        const float* row = rgba + 4 * (std::ptrdiff_t{y0 - rect.y0 + y} * width + (x0 - rect.x0));
        for (int x = 0; x < tile.width; ++x)
          for (int c = 0; c < 4; ++c)
            planes->plane(c)[y * raster::kTileStride + x] = row[4 * x + c];
      }
      kernels.write_pixels(tile, target);
    }
  }
}

gpu::PaintSettings settings_of(const Picture& picture, const RasterOptions& options) {
  gpu::PaintSettings settings;
  settings.tile_width = std::min(kTileSide, options.width);
  settings.tile_height = std::min(kTileSide, options.height);
  settings.backdrop = raster::choose_backdrop(options, picture.background);
  settings.antialias = options.antialias;
  settings.overlay = options.mesh_overlay;
  return settings;
}

Status paint_tiles(Context& context, gpu::Painter& painter, const RasterOptions& options,
                   const raster::ImageTarget& target) {
  std::vector<float> rgba(std::size_t{4} * kTileSide * kTileSide);
  Planes planes;
  const raster::SpanKernels& kernels = raster::span_kernels(context.simd);
  for (int y = 0; y < options.height; y += kTileSide) {
    for (int x = 0; x < options.width; x += kTileSide) {
      const PixelRect rect{x, y, std::min(x + kTileSide, options.width),
                           std::min(y + kTileSide, options.height)};
      if (Status status = painter.paint(rect, rgba.data()); !status) return status;
      write_pixels(rgba.data(), rect, kernels, target, &planes);
    }
    if (context.progress)
      context.progress->report("rasterise", std::min(1.0, 1.0 * (y + kTileSide) / options.height));
  }
  return ok_status();
}

}  // namespace

Result<Image> render_on_gpu(Context& context, const Picture& picture,
                            const RasterOptions& options) {
  Status status = raster::check_size(options);
  if (status) status = raster::check_picture(picture);
  if (!status) return status;
  const Result<Affine> image_from_artboard = raster::image_from_artboard(picture, options);
  if (!image_from_artboard) return image_from_artboard.status();
  Image image{options.width, options.height, options.format, {}};
  const std::size_t image_bytes = image.row_bytes() * static_cast<std::size_t>(options.height);
  ScopedCharge charge;
  status = charge.add(context, image_bytes, "the image");
  if (!status) return status;

  Result<std::unique_ptr<gpu::Device>> device = gpu::Device::create();
  if (!device) return device.status();
  const Result<gpu::Scene> scene =
      gpu::Scene::create(context, **device, picture, *image_from_artboard,
                         {0, 0, options.width, options.height}, options.mesh_overlay);
  if (!scene) return scene.status();
  Result<gpu::Painter> painter =
      gpu::Painter::create(context, **device, *scene, settings_of(picture, options));
  if (!painter) return painter.status();
  image.bytes.resize(image_bytes);
  status = paint_tiles(context, *painter, options,
                       {image.bytes.data(), image.row_bytes(), options.format, options.dither});
  if (!status) return status;
  return image;
}

Result<std::string> gpu_name() {
  Result<std::unique_ptr<gpu::Device>> device = gpu::Device::create();
  if (!device) return device.status();
  return (*device)->name();
}

}  // namespace sfumato
