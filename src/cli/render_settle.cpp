#include "cli/paths.hpp"
#include "cli/render_options.hpp"
#include "options/settle.hpp"

namespace sfumato::cli {
namespace {

void settle_files(RenderArguments& arguments, const RenderChoices& choices) {
  const bool many = !choices.output_folder.empty();
  settle_jobs(choices, choices.extension, kRenderWords, {}, arguments, arguments.outputs);
  expect(!choices.format || many || choices.output == "-", "--format",
         "expected with --out-dir or '-o -' only: a file's extension says it");
  arguments.kind = many || choices.output == "-" ? choices.format.value_or(OutputKind::png)
                                                 : *output_kind(choices.output);
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
