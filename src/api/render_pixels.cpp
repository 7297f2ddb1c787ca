#include "sfumato/api/render_pixels.hpp"

#include "base/public_verb.hpp"
#include "base/stopwatch.hpp"
#include "base/try.hpp"
#include "picture/picture_counts.hpp"

namespace sfumato {
namespace {

Result<Image> render(Context& context, const Document& document,
                     const DiffuseOptions& diffuse_options, const RasterOptions& raster_options,
                     DiffuseStats* stats) {
  DiffuseOptions options = diffuse_options;
  if (raster_options.viewport) options.viewport = raster_options.viewport;
  options.exact_pixels = true;
  SFUMATO_TRY_ASSIGN(const Picture& picture, diffuse(context, document, options, stats));
  const Stopwatch watch;
  Result<Image> image = rasterize(context, picture, raster_options);
  if (image && stats) {
    stats->nodes += picture::count_read_points(picture);
    stats->gather_seconds += watch.seconds();
  }
  return image;
}

}  // namespace

Result<Image> render_pixels(Context& context, const Document& document,
                            const DiffuseOptions& diffuse_options,
                            const RasterOptions& raster_options, DiffuseStats* stats) {
  return public_verb(
      context, [&] { return render(context, document, diffuse_options, raster_options, stats); });
}

}  // namespace sfumato
