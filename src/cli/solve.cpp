#include <utility>

#include "base/charge.hpp"
#include "base/stopwatch.hpp"
#include "cli/commands.hpp"
#include "cli/document_input.hpp"
#include "cli/drawing_jobs.hpp"
#include "output/output_size.hpp"
#include "sfumato/picture/picture_file.hpp"
#include "sfumato/solve/diffuse.hpp"

namespace sfumato::cli {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// As for a picture of the size that was asked for, which is enlarged `detail` times.
DiffuseOptions options_for(const Document& document, const options::Settings& settings, Vec2 own) {
  DiffuseOptions options = settings.diffuse;
  options.viewport = options.viewport.value_or(document.artboard);
  options.pixels_per_unit = output::output_scale(settings.size, *options.viewport, own) *
                            settings.output.detail.value_or(1);
  return options;
}

/// Holds either the document or its picture, never both for longer than it takes.
Result<Bytes> make_file(Context& context, const SolveArguments& arguments, RenderStats& stats) {
  const Stopwatch read_watch;
  Result<ReadDocument> read = read_drawing(context, arguments);
  if (!read) return read.status();
  stats.read_seconds = read_watch.seconds();
  ScopedCharge charge;
  Status status = charge.add(context, bytes_of(read->document), "the document");
  if (!status) return status;
  const Vec2 own = output::own_scale(read->document);
  const DiffuseOptions options = options_for(read->document, arguments.settings, own);
  Result<Picture> picture = diffuse(context, read->document, options, &stats.diffuse);
  if (!picture) return picture.status();
  read->document = {};
  charge = {};
  status = charge.add(context, bytes_of(*picture), "the picture");
  if (!status) return status;
  const Stopwatch write_watch;
  Result<Bytes> file =
      write_picture(context, *picture, {own, options.pixels_per_unit, options.max_error});
  stats.write_seconds = write_watch.seconds();
  return file;
}

}  // namespace

int solve(const SolveArguments& arguments) {
  SolveArguments current = arguments;
  return run_drawing_jobs(arguments, arguments, arguments.settings, kSolveWords,
                          [&](Context& context, const std::string& input, RenderStats& stats,
                              std::optional<Solution>&) {
                            current.input = input;
                            return make_file(context, current, stats);
                          });
}

}  // namespace sfumato::cli
