#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/files/file_uses.hpp"
#include "cli/progress_bar.hpp"
#include "options/output_kind.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/function_ref.hpp"
#include "sfumato/base/status.hpp"
#include "tiles/deep_zoom.hpp"

/// Commands that make one output from each input: `render`, `solve` and `trace`.
namespace sfumato::cli {

/// One input of a call and the destination of its output.
struct Job {
  std::string input;
  std::string output;
};

using options::OutputKind;
using tiles::Shard;

/// Holds the choices of the user for such a command.
struct JobChoices {
  std::vector<std::string> inputs;
  std::string output;          ///< of a single input
  std::string output_folder;   ///< --out-dir
  std::optional<Shard> shard;  ///< of the jobs, with --out-dir or for a film
  bool newer_only = false;     ///< skip inputs whose outputs exist and are not older
};

/// Holds the work of such a command.
struct JobArguments {
  std::vector<Job> jobs;
  bool many = false;               ///< --out-dir was given, or this is a film
  bool shards_are_runs = false;    ///< a shard is a run of jobs, not every count-th job
  std::optional<OutputKind> film;  ///< all jobs write raw frames of this kind into one output
  std::string output_folder;
  std::string stats;  ///< where the JSON goes; empty: nowhere
};

/// The names of a command's inputs and outputs in messages: "drawing" and "picture".
struct JobWords {
  const char* input;
  const char* output;
};
inline constexpr JobWords kRenderWords{"drawing", "picture"};
inline constexpr JobWords kSolveWords{"drawing", "solved picture"};
inline constexpr JobWords kTraceWords{"picture", "drawing"};

/// Turns the choices into jobs. A single input, or all inputs of a film, become `output`; otherwise
/// each input becomes a file in `output_folder` under its own name with another extension. Throws
/// CLI::ValidationError unless exactly one of the two is given, or if an output would replace an
/// input or another output.
///
/// arguments: `stats`, `film` and `shards_are_runs` are input; jobs, many and output_folder are
/// set. outputs: the files that the call writes are appended.
void settle_jobs(const JobChoices& choices, const std::string& extension, const JobWords& words,
                 const std::vector<InputFile>& other_inputs, JobArguments& arguments,
                 std::vector<std::string>& outputs);

/// Makes the folder of the outputs and checks that the JSON can be written. Errors: io.
Status prepare_outputs(const JobArguments& arguments);

/// Does one job and sets `stats` to its line of JSON, with its newline.
using DoJob = FunctionRef<Status(const Job& job, std::string& stats)>;

/// Does the jobs of one call, one after another, and writes the JSON. A job that fails is reported
/// and does not end the others, except in a film, where later frames would come at a wrong time. A
/// signal ends all jobs.
///
/// bar: null if there is none. Returns the exit code of the first job that failed.
int run_jobs(Context& context, const JobArguments& arguments, const JobWords& words,
             ProgressBar* bar, DoJob do_job);

}  // namespace sfumato::cli
