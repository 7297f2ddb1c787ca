#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

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

/// Whether the output is there, and not older than the input.
bool is_up_to_date(const Job& job) {
  std::error_code no_input, no_output;
  const fs::file_time_type input = fs::last_write_time(job.input, no_input);
  const fs::file_time_type output = fs::last_write_time(job.output, no_output);
  return !no_input && !no_output && output >= input;
}

/// The jobs that this call is to do.
std::vector<Job> chosen_jobs(const JobChoices& choices, const std::vector<Job>& jobs) {
  const Shard shard = choices.shard.value_or(Shard{});
  std::vector<Job> chosen;
  for (std::size_t i = static_cast<std::size_t>(shard.index); i < jobs.size();
       i += static_cast<std::size_t>(shard.count)) {
    if (!choices.newer_only || !is_up_to_date(jobs[i])) chosen.push_back(jobs[i]);
  }
  return chosen;
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
  expect(arguments.many || !choices.shard, "--shard", "expected with --out-dir only");
  expect(arguments.many || !choices.newer_only, "--newer-only", "expected with --out-dir only");
  arguments.jobs = chosen_jobs(choices, arguments.jobs);
}

}  // namespace sfumato::cli
