#include <optional>
#include <utility>

#include "base/charge.hpp"
#include "base/limit_error.hpp"
#include "base/stopwatch.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/drawing_jobs.hpp"
#include "cli/files/document_input.hpp"
#include "cli/files/picture_file.hpp"
#include "cli/files/solved_input.hpp"

namespace sfumato::cli {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// Draws one input. A solved picture, recognised by its first bytes, is drawn without the solver.
Result<Bytes> make_file(Context& context, const RenderArguments& arguments, RenderStats& stats,
                        std::optional<Solution>* kept) {
  const Stopwatch watch;
  Result<std::string> input = read_any_text(context, arguments.input);
  SFUMATO_TRY(input);
  ScopedCharge charge;
  SFUMATO_TRY(charge.add(context, capacity_bytes(*input), "the input"));
  if (is_solved(*input)) {
    SFUMATO_TRY_ASSIGN(auto&& solved, read_solved(context, arguments, *input));
    input = std::string();
    charge = {};
    stats.read_seconds = watch.seconds();
    return make_picture_file(context, std::move(solved), arguments, stats);
  }
  SFUMATO_TRY_ASSIGN(auto&& read, read_drawing_of(context, arguments, *input));
  input = std::string();
  charge = {};
  stats.read_seconds = watch.seconds();
  return make_picture_file(context, read.document, arguments, stats, kept);
}

/// The solution kept from earlier frames leaves less memory. If memory is too little, it is
/// dropped.
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
