#include "trace/drawn_image.hpp"

#include <algorithm>
#include <utility>

#include "base/table_memory.hpp"
#include "sfumato/raster/rasterize.hpp"
#include "sfumato/solve/diffuse.hpp"

namespace sfumato::tracing {
namespace {

/// What is drawn on the way is no stage of its own.
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
  const Result<sfumato::Picture> solved = diffuse(context, drawing, diffuse_options);
  if (!solved) return solved.status();
  ScopedCharge solved_charge;
  Status status = solved_charge.add(context, bytes_of(*solved), "the picture");
  if (!status) return status;
  RasterOptions options;
  options.width = width;
  options.height = height;
  options.format = PixelFormat::rgba16;
  Result<Image> image = rasterize(context, *solved, options);
  charge = {};
  if (image) status = charge.add(context, capacity_bytes(image->bytes), "pixels");
  if (!status) return status;
  return image;
}

}  // namespace sfumato::tracing
