#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/commands/jobs.hpp"
#include "cli/commands/stats.hpp"
#include "cli/options/arguments.hpp"
#include "options/settings.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/function_ref.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/solve/solution.hpp"

/// The common part of `render` and `solve`: both make a file from each drawing.
namespace sfumato::cli {

/// Makes the file of one job within the time that the call has left. kept: lasts from job to job;
/// none before the first
using MakeFile = FunctionRef<Result<std::vector<std::uint8_t>>(
    Context& context, const std::string& input, RenderStats& stats, std::optional<Solution>& kept)>;

/// Does the jobs of a call with the threads, and on the GPU, of its settings, and returns the exit
/// code.
int run_drawing_jobs(const DocumentArguments& documents, const JobArguments& jobs,
                     const options::Settings& settings, const JobWords& words, MakeFile make);

}  // namespace sfumato::cli
