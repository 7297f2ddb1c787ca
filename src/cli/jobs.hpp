#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/file_uses.hpp"
#include "cli/progress_bar.hpp"
#include "options/output_kind.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/function_ref.hpp"
#include "sfumato/base/status.hpp"
#include "tiles/deep_zoom.hpp"

/// Commands that make an output of each of their inputs: `render`, `solve` and `trace`.
namespace sfumato::cli {

/// One input of a call and the destination of what becomes of it.
struct Job {
  std::string input;
  std::string output;
};

using options::OutputKind;
using tiles::Shard;

/// What such commands are given.
struct JobChoices {
  std::vector<std::string> inputs;
  std::string output;          ///< of a single input
  std::string output_folder;   ///< --out-dir
  std::optional<Shard> shard;  ///< of the jobs, with --out-dir or for a film
  bool newer_only = false;     ///< leave out inputs whose outputs are there and not older
};

/// What such a command does.
struct JobArguments {
  std::vector<Job> jobs;
  bool many = false;               ///< --out-dir was given, or this is a film
  bool shards_are_runs = false;    ///< not every so many jobs, but one behind the other
  std::optional<OutputKind> film;  ///< all jobs write raw frames of this kind into one output
  std::string output_folder;
  std::string stats;  ///< where the JSON goes; empty: nowhere
};

/// What the inputs and the outputs of a command are called: "drawing" and "picture".
struct JobWords {
  const char* input;
  const char* output;
};
inline constexpr JobWords kRenderWords{"drawing", "picture"};
inline constexpr JobWords kSolveWords{"drawing", "solved picture"};
inline constexpr JobWords kTraceWords{"picture", "drawing"};

/// The jobs of the choices: either a single input becomes `output`, or of a film all of them, or
/// each input becomes a file in `output_folder` under its own name with another extension. Throws
/// CLI::ValidationError where not exactly one of the two is given, or where an output would replace
/// an input or another output.
///
/// arguments  `stats`, `film` and `shards_are_runs` are set, and jobs, many and output_folder will
/// be outputs    files that the call writes are appended
void settle_jobs(const JobChoices& choices, const std::string& extension, const JobWords& words,
                 const std::vector<InputFile>& other_inputs, JobArguments& arguments,
                 std::vector<std::string>& outputs);

/// Makes the folder of the outputs and checks that the JSON can be written. Errors: io.
Status prepare_outputs(const JobArguments& arguments);

/// Does one job, and gives the line of JSON on it, with its newline.
using DoJob = FunctionRef<Status(const Job& job, std::string& stats)>;

/// Does the jobs of one call, one after another, and writes the JSON. A job that fails is reported
/// and ends no other, except in a film, where others would come at a wrong time; a signal ends all.
///
/// bar    null: there is none
/// Returns the exit code: of the first job that failed.
int run_jobs(Context& context, const JobArguments& arguments, const JobWords& words,
             ProgressBar* bar, DoJob do_job);

}  // namespace sfumato::cli
