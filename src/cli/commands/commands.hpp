#pragma once

#include "cli/options/arguments.hpp"

/// The commands. Each prints its own messages and returns the exit code of the process.
namespace sfumato::cli {

int render(const RenderArguments& arguments);
int solve(const SolveArguments& arguments);
int tiles(const TilesArguments& arguments);
int info(const InfoArguments& arguments);
int convert(const ConvertArguments& arguments);
int lint(const LintArguments& arguments);
int compare(const CompareArguments& arguments);
int init(const InitArguments& arguments);
int watch(const WatchArguments& arguments);
int edit(const EditArguments& arguments);
int trace(const TraceArguments& arguments);

/// Runs the whole program: parses the arguments, runs the command, and catches exceptions of
/// third-party libraries. Returns the exit code.
int run(int argc, const char* const* argv);

}  // namespace sfumato::cli
