#include "trace/image/drawn_image.hpp"

#include <algorithm>
#include <utility>

#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "sfumato/raster/rasterize.hpp"
#include "sfumato/solve/diffuse.hpp"

namespace sfumato::tracing {
namespace {

/// Intermediate drawings do not count as a stage of progress.
class Silence {
 public:
  explicit Silence(Context& context)
      : context_(context), progress_(std::exchange(context.progress, nullptr)) {}
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;
  ~Silence() { context_.progress = progress_; }

 private:
  Context& context_;
  Progress* progress_;
};

}  // namespace

Result<Image> drawn_image(Context& context, const Document& drawing, int width, int height,
                          double max_error, ScopedCharge& charge) {
  const Silence silence(context);
  DiffuseOptions diffuse_options;
  diffuse_options.pixels_per_unit =
      std::max(width / drawing.artboard.width(), height / drawing.artboard.height());
  diffuse_options.max_error = max_error;
  SFUMATO_TRY_ASSIGN(const sfumato::Picture& solved, diffuse(context, drawing, diffuse_options));
  ScopedCharge solved_charge;
  SFUMATO_TRY(solved_charge.add(context, bytes_of(solved), "the picture"));
  RasterOptions options;
  options.width = width;
  options.height = height;
  options.format = PixelFormat::rgba16;
  Result<Image> image = rasterize(context, solved, options);
  charge = {};
  if (image) SFUMATO_TRY(charge.add(context, capacity_bytes(image->bytes), "pixels"));
  return image;
}

}  // namespace sfumato::tracing
