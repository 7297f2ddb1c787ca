
#include "base/charge.hpp"
#include "base/stopwatch.hpp"
#include "base/try.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/drawing_jobs.hpp"
#include "cli/files/document_input.hpp"
#include "output/output_size.hpp"
#include "sfumato/picture/picture_file.hpp"
#include "sfumato/solve/diffuse.hpp"

namespace sfumato::cli {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// Solved as for a picture of the requested size that is enlarged `detail` times.
DiffuseOptions options_for(const Document& document, const options::Settings& settings, Vec2 own) {
  DiffuseOptions options = settings.diffuse;
  options.viewport = options.viewport.value_or(document.artboard);
  options.pixels_per_unit = output::output_scale(settings.size, *options.viewport, own) *
                            settings.output.detail.value_or(1);
  return options;
}

/// Makes the file. Only one of the document and its picture is in memory, both only while one
/// becomes the other.
Result<Bytes> make_file(Context& context, const SolveArguments& arguments, RenderStats& stats) {
  const Stopwatch read_watch;
  SFUMATO_TRY_ASSIGN(auto&& read, read_drawing(context, arguments));
  stats.read_seconds = read_watch.seconds();
  ScopedCharge charge;
  SFUMATO_TRY(charge.add(context, bytes_of(read.document), "the document"));
  const Vec2 own = output::own_scale(read.document);
  const DiffuseOptions options = options_for(read.document, arguments.settings, own);
  SFUMATO_TRY_ASSIGN(auto&& picture, diffuse(context, read.document, options, &stats.diffuse));
  read.document = {};
  charge = {};
  SFUMATO_TRY(charge.add(context, bytes_of(picture), "the picture"));
  const Stopwatch write_watch;
  Result<Bytes> file =
      write_picture(context, picture, {own, options.pixels_per_unit, options.max_error});
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
