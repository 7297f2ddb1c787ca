#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>

#include "cli/jobs.hpp"
#include "cli/option_helpers.hpp"

namespace sfumato::cli {
namespace {

namespace fs = std::filesystem;

std::vector<Job> jobs_of(const JobChoices& choices, const std::string& extension) {
  if (choices.output_folder.empty()) return {{choices.inputs.front(), choices.output}};
  std::vector<Job> jobs;
  for (const std::string& input : choices.inputs) {
    // "drawing.svg.gz" and "drawing.svgz" both become "drawing".
    fs::path name = fs::path(input).filename();
    if (name.extension() == ".gz") name = name.stem();
    jobs.push_back(
        {input, (fs::path(choices.output_folder) / name.stem()).string() + '.' + extension});
  }
  return jobs;
}

/// No output and no figures may replace an input, or one another.
void settle_file_uses(const JobArguments& arguments, const JobWords& words,
                      std::vector<InputFile> inputs, std::vector<std::string>& written) {
  std::vector<OutputFile> outputs;
  for (const Job& job : arguments.jobs) {
    inputs.push_back({job.input, std::string("the ") + words.input});
    outputs.push_back({job.output, std::string("the ") + words.output, in_quotes(job.input)});
  }
  std::string complaint = complaint_about(inputs, outputs);
  expect(complaint.empty(), arguments.many ? "--out-dir" : "--output", complaint);
  if (!arguments.stats.empty()) outputs.push_back({arguments.stats, "the figures", "--stats"});
  complaint = complaint_about(inputs, outputs);
  expect(complaint.empty(), "--stats", complaint);
  for (const OutputFile& output : outputs) written.push_back(output.path);
}

}  // namespace

void settle_jobs(const JobChoices& choices, const std::string& extension, const JobWords& words,
                 const std::vector<InputFile>& other_inputs, JobArguments& arguments,
                 std::vector<std::string>& outputs) {
  arguments.many = !choices.output_folder.empty();
  arguments.output_folder = choices.output_folder;
  expect(arguments.many || !choices.output.empty(), "--output", "expected, or --out-dir");
  expect(arguments.many || choices.inputs.size() == 1, "IN",
         std::string("several ") + words.input + "s given, expected --out-dir for their " +
             words.output + 's');
  const bool reads_stdin = std::count(choices.inputs.begin(), choices.inputs.end(), "-") > 0;
  expect(!arguments.many || !reads_stdin, "--out-dir", "stdin has no name, expected -o");
  arguments.jobs = jobs_of(choices, extension);
  expect(choices.output != "-" || arguments.stats != "-", "--stats",
         std::string("stdout is taken by the ") + words.output + ", expected a file name");
  settle_file_uses(arguments, words, other_inputs, outputs);
}

}  // namespace sfumato::cli
