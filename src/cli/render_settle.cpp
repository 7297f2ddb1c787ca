#include "cli/paths.hpp"
#include "cli/render_options.hpp"
#include "options/settle.hpp"

namespace sfumato::cli {
namespace {

/// Whether the name of an output does not say what it is.
bool takes_format(const RenderChoices& choices) {
  return choices.output.empty() || choices.output == "-";
}

void settle_files(RenderArguments& arguments, const RenderChoices& choices) {
  arguments.kind = takes_format(choices) ? choices.format.value_or(OutputKind::png)
                                         : *output_kind(choices.output);
  const bool is_film = !choices.output.empty() && options::is_frame(arguments.kind);
  if (is_film) arguments.film = arguments.kind;
  arguments.shards_are_runs = is_film || arguments.settings.coherent;
  settle_jobs(choices, choices.extension, kRenderWords, {}, arguments, arguments.outputs);
  expect(!choices.format || takes_format(choices), "--format",
         "expected with --out-dir or '-o -' only: a file's extension says it");
  expect(arguments.many || !arguments.settings.coherent, "--coherent",
         "expected with --out-dir or raw frames only");
}

}  // namespace

void settle(RenderArguments& arguments, const RenderChoices& choices) {
  settle_files(arguments, choices);
  const options::Conflict conflict = options::find_conflict(arguments.settings, arguments.kind);
  if (!conflict.key.empty()) {
    throw CLI::ValidationError(options::spelled(conflict.key, true),
                               options::spelled(conflict.complaint, true));
  }
  options::settle(arguments.settings, arguments.kind);
}

}  // namespace sfumato::cli
