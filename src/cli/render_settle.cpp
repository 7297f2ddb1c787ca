#include <algorithm>

#include "cli/file_uses.hpp"
#include "cli/paths.hpp"
#include "cli/render_options.hpp"
#include "options/settle.hpp"

namespace sfumato::cli {
namespace {

/// Throws where `given` and what it needs are not there together.
void expect(bool good, const char* option, const std::string& complaint) {
  if (!good) throw CLI::ValidationError(option, complaint);
}

/// No picture and no stats may replace a drawing that is read, or one another.
void settle_file_uses(RenderArguments& arguments) {
  std::vector<InputFile> inputs;
  std::vector<OutputFile> outputs;
  for (const RenderJob& job : arguments.jobs) {
    inputs.push_back({job.input, "the drawing"});
    outputs.push_back({job.output, "the picture", in_quotes(job.input)});
  }
  std::string complaint = complaint_about(inputs, outputs);
  expect(complaint.empty(), arguments.many ? "--out-dir" : "--output", complaint);
  if (!arguments.stats.empty()) outputs.push_back({arguments.stats, "the figures", "--stats"});
  complaint = complaint_about(inputs, outputs);
  expect(complaint.empty(), "--stats", complaint);
  for (const OutputFile& output : outputs) arguments.outputs.push_back(output.path);
}

void settle_files(RenderArguments& arguments, const RenderChoices& choices) {
  arguments.many = !choices.output_folder.empty();
  arguments.output_folder = choices.output_folder;
  expect(arguments.many || !choices.output.empty(), "--output", "expected, or --out-dir");
  expect(arguments.many || choices.inputs.size() == 1, "IN",
         "several drawings given, expected --out-dir for their pictures");
  const bool reads_stdin = std::count(choices.inputs.begin(), choices.inputs.end(), "-") > 0;
  expect(!arguments.many || !reads_stdin, "--out-dir", "stdin has no name, expected -o");
  expect(!choices.format || arguments.many || choices.output == "-", "--format",
         "expected with --out-dir or '-o -' only: a file's extension says it");
  arguments.kind = arguments.many || choices.output == "-"
                       ? choices.format.value_or(OutputKind::png)
                       : *output_kind(choices.output);
  arguments.jobs =
      render_jobs(choices.inputs, choices.output, choices.output_folder, choices.extension);
  expect(choices.output != "-" || arguments.stats != "-", "--stats",
         "stdout is taken by the picture, expected a file name");
  settle_file_uses(arguments);
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
