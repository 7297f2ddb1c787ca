#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <system_error>

#include "cli/commands/jobs.hpp"
#include "cli/options/option_helpers.hpp"

namespace sfumato::cli {
namespace {

namespace fs = std::filesystem;

std::vector<Job> jobs_of(const JobChoices& choices, const std::string& extension) {
  std::vector<Job> jobs;
  for (const std::string& input : choices.inputs) {
    if (choices.output_folder.empty()) {
      jobs.push_back({input, choices.output});
      continue;
    }
    // "drawing.svg.gz" and "drawing.svgz" both become "drawing".
    fs::path name = fs::path(input).filename();
    if (name.extension() == ".gz") name = name.stem();
    jobs.push_back(
        {input, (fs::path(choices.output_folder) / name.stem()).string() + '.' + extension});
  }
  return jobs;
}

/// Checks that no output and no file of figures replaces an input or another output.
void settle_file_uses(const JobArguments& arguments, const JobWords& words,
                      std::vector<InputFile> inputs, std::vector<std::string>& written) {
  std::vector<OutputFile> outputs;
  for (const Job& job : arguments.jobs) {
    inputs.push_back({job.input, std::string("the ") + words.input});
    if (arguments.film && !outputs.empty()) continue;
    outputs.push_back({job.output, std::string("the ") + words.output, in_quotes(job.input)});
  }
  const bool has_folder = !arguments.output_folder.empty();
  expect_none(has_folder ? "--out-dir" : "--output", complaint_about(inputs, outputs));
  if (!arguments.stats.empty()) outputs.push_back({arguments.stats, "the figures", "--stats"});
  expect_none("--stats", complaint_about(inputs, outputs));
  for (const OutputFile& output : outputs) written.push_back(output.path);
}

/// Returns whether the output exists and is not older than the input.
bool is_up_to_date(const Job& job) {
  std::error_code no_input, no_output;
  const fs::file_time_type input = fs::last_write_time(job.input, no_input);
  const fs::file_time_type output = fs::last_write_time(job.output, no_output);
  return !no_input && !no_output && output >= input;
}

/// Returns the jobs of a shard: a run of them, or every count-th.
std::vector<Job> jobs_of_shard(Shard shard, bool is_run, const std::vector<Job>& jobs) {
  const auto index = static_cast<std::size_t>(shard.index),
             count = static_cast<std::size_t>(shard.count);
  std::vector<Job> chosen;
  const std::size_t begin = is_run ? jobs.size() * index / count : index;
  const std::size_t end = is_run ? jobs.size() * (index + 1) / count : jobs.size();
  for (std::size_t i = begin; i < end; i += is_run ? 1 : count) chosen.push_back(jobs[i]);
  return chosen;
}

/// Returns the jobs that this call does.
std::vector<Job> chosen_jobs(const JobChoices& choices, bool are_runs,
                             const std::vector<Job>& jobs) {
  std::vector<Job> chosen = jobs_of_shard(choices.shard.value_or(Shard{}), are_runs, jobs);
  if (choices.newer_only) std::erase_if(chosen, is_up_to_date);
  return chosen;
}

}  // namespace

void settle_jobs(const JobChoices& choices, const std::string& extension, const JobWords& words,
                 const std::vector<InputFile>& other_inputs, JobArguments& arguments,
                 std::vector<std::string>& outputs) {
  const bool has_folder = !choices.output_folder.empty();
  arguments.many = has_folder || arguments.film;
  arguments.output_folder = choices.output_folder;
  if (!has_folder && choices.output.empty()) {
    const std::string name = words.output;  // "solved picture": its last word
    throw CLI::ValidationError("no output: use -o " + name.substr(name.rfind(' ') + 1) + '.' +
                               extension + " or --out-dir DIR");
  }
  expect(arguments.many || choices.inputs.size() == 1, "IN",
         std::string("several ") + words.input + "s given; use --out-dir DIR for their " +
             words.output + 's');
  const bool reads_stdin = std::count(choices.inputs.begin(), choices.inputs.end(), "-") > 0;
  expect(!has_folder || !reads_stdin, "--out-dir", "stdin has no name; use -o");
  arguments.jobs = jobs_of(choices, extension);
  expect(choices.output != "-" || arguments.stats != "-", "--stats",
         std::string("stdout is taken by the ") + words.output + "; use a file name");
  settle_file_uses(arguments, words, other_inputs, outputs);
  expect(arguments.many || !choices.shard, "--shard", "works with --out-dir only");
  expect(has_folder || !choices.newer_only, "--newer-only", "works with --out-dir only");
  arguments.jobs = chosen_jobs(choices, arguments.shards_are_runs, arguments.jobs);
}

}  // namespace sfumato::cli
