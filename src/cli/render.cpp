#include <optional>
#include <utility>

#include "base/charge.hpp"
#include "base/limit_error.hpp"
#include "base/stopwatch.hpp"
#include "base/table_memory.hpp"
#include "cli/commands.hpp"
#include "cli/document_input.hpp"
#include "cli/drawing_jobs.hpp"
#include "cli/picture_file.hpp"
#include "cli/solved_input.hpp"

namespace sfumato::cli {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// A solved picture, told apart by its first bytes, is drawn without the solver.
Result<Bytes> make_file(Context& context, const RenderArguments& arguments, RenderStats& stats,
                        std::optional<Solution>* kept) {
  const Stopwatch watch;
  Result<std::string> input = read_any_text(context, arguments.input);
  if (!input) return input.status();
  ScopedCharge charge;
  Status status = charge.add(context, capacity_bytes(*input), "the input");
  if (!status) return status;
  if (is_solved(*input)) {
    Result<SolvedInput> solved = read_solved(context, arguments, *input);
    if (!solved) return solved.status();
    input = std::string();
    charge = {};
    stats.read_seconds = watch.seconds();
    return make_picture_file(context, std::move(*solved), arguments, stats);
  }
  Result<ReadDocument> read = read_drawing_of(context, arguments, *input);
  if (!read) return read.status();
  input = std::string();
  charge = {};
  stats.read_seconds = watch.seconds();
  return make_picture_file(context, read->document, arguments, stats, kept);
}

/// What is kept of the frames before leaves less memory: where that is too little it is dropped.
Result<Bytes> make_coherent_file(Context& context, const RenderArguments& arguments,
                                 RenderStats& stats, std::optional<Solution>& kept) {
  auto file = make_file(context, arguments, stats, &kept);
  if (file || !is_lack_of_memory(file.status()) || arguments.input == "-") return file;
  kept.reset();
  const int threads = std::exchange(stats, {}).threads;
  stats.threads = threads;
  return make_file(context, arguments, stats, nullptr);
}

}  // namespace

int render(const RenderArguments& arguments) {
  RenderArguments current = arguments;
  return run_drawing_jobs(arguments, arguments, arguments.settings, kRenderWords,
                          [&](Context& context, const std::string& input, RenderStats& stats,
                              std::optional<Solution>& kept) {
                            current.input = input;
                            return arguments.settings.coherent
                                       ? make_coherent_file(context, current, stats, kept)
                                       : make_file(context, current, stats, nullptr);
                          });
}

}  // namespace sfumato::cli
