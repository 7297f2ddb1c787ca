#include "raster/render_pixels.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/stopwatch.hpp"
#include "patches/point_evaluator.hpp"
#include "raster/options.hpp"
#include "raster/span_kernels.hpp"
#include "raster/tile.hpp"

namespace sfumato {
namespace {

using raster::Tile;

/// Points are taken in squares of this side, so that the 16 of a packet lie close together.
constexpr int kSquare = 4;

/// One row of tiles: where its pixels are and what they show.
struct Band {
  std::vector<Vec2> point;
  std::vector<int> column;  ///< per point: pixel of the image
  std::vector<int> row;     ///< per point: pixel of the band
  std::vector<float> rgb;
  std::vector<std::uint8_t> hit;
};

void place_points(const RasterOptions& options, const Box& viewport, int y0, int height,
                  Band* band) {
  band->point.clear();
  band->column.clear();
  band->row.clear();
  const double x_step = viewport.width() / options.width;
  const double y_step = viewport.height() / options.height;
  for (int square_y = 0; square_y < height; square_y += kSquare) {
    for (int square_x = 0; square_x < options.width; square_x += kSquare) {
      for (int y = square_y; y < std::min(square_y + kSquare, height); ++y) {
        for (int x = square_x; x < std::min(square_x + kSquare, options.width); ++x) {
          band->point.push_back(
              {viewport.min.x + (x + 0.5) * x_step, viewport.min.y + (y0 + y + 0.5) * y_step});
          band->column.push_back(x);
          band->row.push_back(y);
        }
      }
    }
  }
  band->rgb.resize(3 * band->point.size());
  band->hit.resize(band->point.size());
}

/// The planes of a tile, row by row with the stride of tiles.
struct Planes {
  explicit Planes(bool has_alpha) : values(raster::kTileFloats * (has_alpha ? 4 : 3)) {}
  float* plane(int i) { return values.data() + i * raster::kTileFloats; }
  std::vector<float> values;
};

/// Writes the columns [x0, x0 + width) of a band into the image.
void write_tile(const Band& band, int x0, int width, int y0, int height,
                const raster::Backdrop& backdrop, const raster::SpanKernels& kernels,
                const raster::ImageTarget& target, Planes* planes) {
  const bool has_alpha = channel_count(target.format) == 4;
  Tile tile{x0,
            y0,
            width,
            height,
            {planes->plane(0), planes->plane(1), planes->plane(2)},
            has_alpha ? planes->plane(3) : nullptr};
  const float backdrop_rgb[3] = {backdrop.color.r, backdrop.color.g, backdrop.color.b};
  for (std::size_t i = 0; i < band.point.size(); ++i) {
    if (band.column[i] < x0 || band.column[i] >= x0 + width) continue;
    const std::size_t at = static_cast<std::size_t>(band.row[i]) * raster::kTileStride +
                           static_cast<std::size_t>(band.column[i] - x0);
    for (int c = 0; c < 3; ++c) {
      tile.color[c][at] = band.hit[i] ? band.rgb[3 * i + c] : backdrop_rgb[c];
    }
    if (has_alpha) tile.alpha[at] = band.hit[i] ? 1.0f : backdrop.alpha;
  }
  kernels.write_pixels(tile, target);
}

/// The colours of the topmost layers at the band's points.
Status evaluate(Context& context, const Document& document, const PointEvaluator& evaluator,
                Band* band) {
  std::fill(band->rgb.begin(), band->rgb.end(), 0.0f);
  std::fill(band->hit.begin(), band->hit.end(), std::uint8_t{0});
  std::vector<Vec2> mapped(band->point.size());
  std::vector<std::uint8_t> hit(band->hit.size());
  for (const StackItem& item : document.stack) {
    const auto* instance = std::get_if<LayerInstance>(&item);
    if (!instance || evaluator.color_channels(instance->layer) == 0) continue;
    const auto channels = static_cast<std::size_t>(evaluator.color_channels(instance->layer));
    std::vector<float> color(channels * mapped.size());
    std::transform(band->point.begin(), band->point.end(), mapped.begin(),
                   inverse(instance->artboard_from_layer));
    Status status = evaluator.evaluate(context, instance->layer, mapped, color, hit);
    if (!status) return status;
    for (std::size_t i = 0; i < hit.size(); ++i) {
      if (!hit[i]) continue;
      std::copy_n(color.data() + channels * i, 3, band->rgb.data() + 3 * i);
      band->hit[i] = 1;
    }
  }
  return ok_status();
}

/// Evaluates and writes the image from top to bottom.
Status paint(Context& context, const Document& document, const PointEvaluator& evaluator,
             const Box& viewport, const RasterOptions& options, const raster::Backdrop& backdrop,
             Image* image) {
  const raster::SpanKernels& kernels = raster::span_kernels(context.simd);
  const raster::ImageTarget target{image->bytes.data(), image->row_bytes(), options.format,
                                   options.dither};
  Band band;
  Planes planes(channel_count(options.format) == 4);
  for (int y0 = 0; y0 < options.height; y0 += raster::kTileHeight) {
    const int height = std::min(raster::kTileHeight, options.height - y0);
    place_points(options, viewport, y0, height, &band);
    Status status = evaluate(context, document, evaluator, &band);
    if (!status) return status;
    for (int x0 = 0; x0 < options.width; x0 += raster::kTileWidth) {
      const int width = std::min(raster::kTileWidth, options.width - x0);
      write_tile(band, x0, width, y0, height, backdrop, kernels, target, &planes);
    }
    if (context.progress) {
      context.progress->report("gather", static_cast<double>(y0 + height) / options.height);
    }
  }
  return ok_status();
}

constexpr std::size_t kBytesPerBandPixel =
    sizeof(Vec2) + 2 * sizeof(int) + 3 * sizeof(float) + sizeof(std::uint8_t);

}  // namespace

Result<Image> render_pixels(Context& context, const Document& document,
                            const DiffuseOptions& diffuse_options,
                            const RasterOptions& raster_options, DiffuseStats* stats) {
  if (Status status = raster::check_size(raster_options); !status) return status;
  const Box viewport =
      raster_options.viewport.value_or(diffuse_options.viewport.value_or(document.artboard));
  DiffuseOptions options = diffuse_options;
  options.viewport = viewport;
  Result<PointEvaluator> evaluator = PointEvaluator::create(context, document, options, stats);
  if (!evaluator) return evaluator.status();
  Image image{raster_options.width, raster_options.height, raster_options.format, {}};
  const std::size_t image_bytes = image.row_bytes() * static_cast<std::size_t>(image.height);
  const std::size_t band_pixels = static_cast<std::size_t>(image.width) * raster::kTileHeight;
  ScopedCharge charge;
  if (Status status =
          charge.add(context, image_bytes + 2 * band_pixels * kBytesPerBandPixel, "the image");
      !status) {
    return status;
  }
  image.bytes.resize(image_bytes);
  const raster::Backdrop backdrop = raster::choose_backdrop(raster_options, document.background);
  const Stopwatch watch;
  Status status = paint(context, document, *evaluator, viewport, raster_options, backdrop, &image);
  if (!status) return status;
  if (stats) {
    stats->nodes += static_cast<std::uint64_t>(image.width) * image.height;
    stats->gather_seconds += watch.seconds();
  }
  return image;
}

}  // namespace sfumato
