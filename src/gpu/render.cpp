#include "sfumato/gpu/render.hpp"

#include <algorithm>
#include <vector>

#include "base/no_throw.hpp"
#include "base/parallel.hpp"
#include "base/public_verb.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "gpu/device.hpp"
#include "gpu/draw_list.hpp"
#include "gpu/painter.hpp"
#include "picture/check_picture.hpp"
#include "raster/kernels/span_kernels.hpp"
#include "raster/layers/layer_view.hpp"
#include "raster/options.hpp"

namespace sfumato {
namespace {

/// Side of the square that is painted at once, pixels of the image.
constexpr int kTileSide = 1024;

/// Pixels in the format of the device: four floats each, row by row.
struct ReadPixels {
  const float* rgba = nullptr;
  PixelRect rect;

  const float* at(int x, int y) const {
    return rgba + 4 * (std::ptrdiff_t{y - rect.y0} * (rect.x1 - rect.x0) + (x - rect.x0));
  }
};

/// Writes the rows [y0, y0 + kTileHeight) as the CPU's rasterizer does: its formats, its rounding,
/// its dither.
void write_rows(const ReadPixels& pixels, int y0, const raster::SpanKernels& kernels,
                const raster::ImageTarget& target) {
  std::vector<float> planes(4 * raster::kTileFloats);
  const auto plane = [&](int c) { return planes.data() + c * raster::kTileFloats; };
  const PixelRect& rect = pixels.rect;
  for (int x0 = rect.x0; x0 < rect.x1; x0 += raster::kTileWidth) {
    const raster::Tile tile{x0,
                            y0,
                            std::min(raster::kTileWidth, rect.x1 - x0),
                            std::min(raster::kTileHeight, rect.y1 - y0),
                            {plane(0), plane(1), plane(2)},
                            channel_count(target.format) == 4 ? plane(3) : nullptr};
    for (int y = 0; y < tile.height; ++y) {
      const float* row = pixels.at(x0, y0 + y);
      for (int x = 0; x < tile.width; ++x)
        for (int c = 0; c < 4; ++c) plane(c)[y * raster::kTileStride + x] = row[4 * x + c];
    }
    kernels.write_pixels(tile, target);
  }
}

Status write_pixels(Context& context, const ReadPixels& pixels, const raster::ImageTarget& target) {
  const raster::SpanKernels& kernels = raster::span_kernels(context.simd);
  const int height = pixels.rect.y1 - pixels.rect.y0;
  const int bands = (height + raster::kTileHeight - 1) / raster::kTileHeight;
  return parallel_for(context, static_cast<std::size_t>(bands), 1,
                      [&](std::size_t begin, std::size_t end) {
                        for (std::size_t i = begin; i < end; ++i) {
                          const int y0 = pixels.rect.y0 + static_cast<int>(i) * raster::kTileHeight;
                          write_rows(pixels, y0, kernels, target);
                        }
                      });
}

gpu::PaintSettings settings_of(const gpu::Device& device, const Picture& picture,
                               const RasterOptions& options) {
  gpu::PaintSettings settings;
  settings.tile_width = std::min(kTileSide, options.width);
  settings.tile_height = std::min(kTileSide, options.height);
  settings.backdrop = raster::choose_backdrop(options, picture.background);
  settings.antialias = options.antialias;
  settings.overlay = options.mesh_overlay;
  settings.single_precision = device.blends_floats();
  return settings;
}

Status paint_tiles(Context& context, gpu::Painter& painter, const RasterOptions& options,
                   const raster::ImageTarget& target) {
  const std::size_t values = std::size_t{4} * std::min(kTileSide, options.width) *
                             static_cast<std::size_t>(std::min(kTileSide, options.height));
  TableMemory memory("an image on the GPU");
  std::vector<float> rgba;
  SFUMATO_TRY(memory.resize(context, rgba, values));
  for (int y = 0; y < options.height; y += kTileSide) {
    for (int x = 0; x < options.width; x += kTileSide) {
      const PixelRect rect{x, y, std::min(x + kTileSide, options.width),
                           std::min(y + kTileSide, options.height)};
      SFUMATO_TRY(painter.paint(rect, rgba.data()));
      SFUMATO_TRY(write_pixels(context, {rgba.data(), rect}, target));
    }
    if (context.progress)
      context.progress->report("rasterise", std::min(1.0, 1.0 * (y + kTileSide) / options.height));
  }
  return ok_status();
}

Result<Image> render(Context& context, const Picture& picture, const RasterOptions& options) {
  SFUMATO_TRY(raster::check_options(context.limits, options));
  if (options.window) {
    return make_error(StatusCode::bad_input, "a window given, which the GPU does not draw");
  }
  SFUMATO_TRY(picture::check_picture(context, picture));
  SFUMATO_TRY_ASSIGN(const Affine& image_from_artboard,
                     raster::image_from_artboard(picture, options));
  Image image{options.width, options.height, options.format, {}};
  const std::size_t image_bytes = image.row_bytes() * static_cast<std::size_t>(options.height);
  TableMemory memory("the image");
  SFUMATO_TRY(memory.reserve(context, image.bytes, image_bytes));

  SFUMATO_TRY_ASSIGN(auto&& device, gpu::Device::create());
  SFUMATO_TRY_ASSIGN(
      const gpu::DrawList& list,
      gpu::DrawList::create(context, *device, picture, image_from_artboard,
                            {0, 0, options.width, options.height}, options.mesh_overlay));
  SFUMATO_TRY_ASSIGN(auto&& painter, gpu::Painter::create(context, *device, list,
                                                          settings_of(*device, picture, options)));
  SFUMATO_TRY(memory.resize(context, image.bytes, image_bytes));
  SFUMATO_TRY(paint_tiles(context, painter, options,
                          {image.bytes.data(), image.row_bytes(), options.format, options.dither}));
  return image;
}

Result<std::string> device_name() {
  SFUMATO_TRY_ASSIGN(auto&& device, gpu::Device::create());
  return device->name();
}

}  // namespace

Result<Image> render_on_gpu(Context& context, const Picture& picture,
                            const RasterOptions& options) {
  return public_verb(context, [&] { return render(context, picture, options); });
}

Result<std::string> gpu_name() {
  return no_throw(device_name);
}

}  // namespace sfumato
