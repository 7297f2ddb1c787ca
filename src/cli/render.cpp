#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>

#include "base/native/file.hpp"
#include "base/native/tbb_executor.hpp"
#include "base/stopwatch.hpp"
#include "cli/commands.hpp"
#include "cli/document_input.hpp"
#include "cli/interrupt.hpp"
#include "cli/paths.hpp"
#include "cli/progress_bar.hpp"
#include "cli/stats.hpp"
#include "formats/png.hpp"
#include "raster/render_pixels.hpp"

namespace sfumato::cli {
namespace {

constexpr std::chrono::milliseconds kProgressDelay{1000};

Status check_outputs(const RenderArguments& arguments) {
  Status status = check_output(arguments.output);
  if (status && !arguments.stats.empty()) status = check_output(arguments.stats);
  return status;
}

/// The two ways from a document to pixels; both need diffuse.viewport and raster's size set.
Result<Image> draw(Context& context, const Document& document,
                   const DiffuseOptions& diffuse_options, const RasterOptions& raster_options,
                   bool per_pixel, RenderStats& stats) {
  DiffuseStats& solved = stats.diffuse;
  if (per_pixel) {
    const Stopwatch watch;
    Result<Image> image =
        render_pixels(context, document, diffuse_options, raster_options, &solved);
    const double rest = watch.seconds() - solved.geometry_seconds - solved.triangulation_seconds -
                        solved.gather_seconds;
    stats.rasterise_seconds = std::max(0.0, rest);
    return image;
  }
  const Result<Picture> picture = diffuse(context, document, diffuse_options, &solved);
  if (!picture) return picture.status();
  const Stopwatch watch;
  Result<Image> image = rasterize(context, *picture, raster_options);
  stats.rasterise_seconds = watch.seconds();
  return image;
}

Result<Image> draw_as_asked(Context& context, Document& document, const RenderArguments& arguments,
                            RenderStats& stats) {
  const Box viewport = arguments.diffuse.viewport.value_or(document.artboard);
  const Result<OutputSize> size = output_size(arguments.size, viewport);
  if (!size) return size.status();
  DiffuseOptions diffuse_options = arguments.diffuse;
  diffuse_options.viewport = viewport;
  diffuse_options.pixels_per_unit = size->pixels_per_unit;
  RasterOptions raster_options = arguments.raster;
  raster_options.viewport = viewport;
  raster_options.width = size->width;
  raster_options.height = size->height;
  if (raster_options.background) document.background = raster_options.background;
  return draw(context, document, diffuse_options, raster_options, arguments.per_pixel, stats);
}

Status write_image(Context& context, const RenderArguments& arguments, const Image& image) {
  const auto png = encode_png(context, image);
  if (!png) return png.status();
  if (context.cancelled()) return make_error(StatusCode::cancelled, "cancelled");
  return write_file(arguments.output, *png);
}

Status write_stats(const RenderArguments& arguments, const RenderStats& stats) {
  if (arguments.stats.empty()) return ok_status();
  const std::string json = to_json(stats);
  return write_file(arguments.stats,
                    {reinterpret_cast<const std::uint8_t*>(json.data()), json.size()});
}

/// The whole of `sfumato render` after its input was read; `total` runs since its start.
Status render_document(Context& context, const RenderArguments& arguments, const std::string& input,
                       const Stopwatch& total) {
  RenderStats stats;
  stats.threads = context.thread_count();
  Result<ReadDocument> read = read_given_document(context, arguments, input);
  if (!read) return read.status();
  stats.read_seconds = total.seconds();
  const Result<Image> image = draw_as_asked(context, read->document, arguments, stats);
  if (!image) return image.status();
  const Stopwatch write_watch;
  const Status written = write_image(context, arguments, *image);
  if (!written) return written;
  stats.write_seconds = write_watch.seconds();
  stats.total_seconds = total.seconds();
  return write_stats(arguments, stats);
}

}  // namespace

int render(const RenderArguments& arguments) {
  const Stopwatch total;
  const Status writable = check_outputs(arguments);
  if (!writable) return fail(writable);
  const Result<std::string> input = read_input(arguments.input, limits::kInputBytes);
  if (!input) return fail(input.status());

  const std::unique_ptr<Executor> executor = make_tbb_executor(arguments.threads);
  std::optional<ProgressBar> progress;
  if (!arguments.quiet && isatty(STDERR_FILENO) != 0) progress.emplace(stderr, kProgressDelay);
  Context context{.executor = executor.get(),
                  .progress = progress ? &*progress : nullptr,
                  .budget = Budget(arguments.max_memory_bytes)};
  const CancelOnSignal cancel_on_signal(context.cancel);
  const Status status = render_document(context, arguments, *input, total);
  progress.reset();
  return status ? kDone : fail(status);
}

}  // namespace sfumato::cli
