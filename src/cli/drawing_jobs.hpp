#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/arguments.hpp"
#include "cli/jobs.hpp"
#include "cli/stats.hpp"
#include "options/settings.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/function_ref.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/solve/solution.hpp"

/// What `render` and `solve` have in common: both make a file of each drawing.
namespace sfumato::cli {

/// Makes the file of one job, with the time that the call has from now on.
/// kept   lasts from job to job; none before the first
using MakeFile = FunctionRef<Result<std::vector<std::uint8_t>>(
    Context& context, const std::string& input, RenderStats& stats, std::optional<Solution>& kept)>;

/// Does the jobs of a call with the threads, and on the GPU, of its settings, and returns the exit
/// code.
int run_drawing_jobs(const DocumentArguments& documents, const JobArguments& jobs,
                     const options::Settings& settings, const JobWords& words, MakeFile make);

}  // namespace sfumato::cli
