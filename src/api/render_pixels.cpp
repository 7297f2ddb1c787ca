#include "sfumato/api/render_pixels.hpp"

#include "base/public_verb.hpp"
#include "base/stopwatch.hpp"
#include "base/try.hpp"
#include "raster/rasterize_source.hpp"
#include "solve/points/exact_picture.hpp"

namespace sfumato {
namespace {

Result<Image> render(Context& context, const Document& document,
                     const DiffuseOptions& diffuse_options, const RasterOptions& raster_options,
                     DiffuseStats* stats) {
  DiffuseOptions options = diffuse_options;
  if (raster_options.viewport) options.viewport = raster_options.viewport;
  SFUMATO_TRY_ASSIGN(const auto& exact,
                     solve::ExactPicture::create(context, document, options, stats));
  const Stopwatch watch;
  Result<Image> image = rasterize(context, exact.picture(), raster_options, exact);
  if (image && stats) {
    stats->nodes +=
        static_cast<std::uint64_t>(image->width) * static_cast<std::uint64_t>(image->height);
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
