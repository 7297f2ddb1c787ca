#include "cli/files/paths.hpp"
#include "cli/options/render_options.hpp"
#include "options/settle.hpp"

namespace sfumato::cli {
namespace {

/// Returns whether the name of the output does not determine its format.
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
         "works with --out-dir or '-o -' only; the extension of OUT sets the format");
  expect(arguments.many || !arguments.settings.coherent, "--coherent",
         "works with --out-dir or raw frames only");
}

}  // namespace

void settle(RenderArguments& arguments, const RenderChoices& choices) {
  settle_files(arguments, choices);
  expect_none(options::find_conflict(arguments.settings, arguments.kind));
  options::settle(arguments.settings, arguments.kind);
}

}  // namespace sfumato::cli
