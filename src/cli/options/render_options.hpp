#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/options/arguments.hpp"
#include "cli/options/option_helpers.hpp"

namespace sfumato::cli {

/// Options that affect several members of RenderArguments and are applied once all options are
/// known.
struct RenderChoices : JobChoices {
  std::optional<OutputKind> format;
  std::string extension = "png";  ///< of the format, as given
};

/// Adds --viewport, --width, --height and --scale.
void add_place_options(CommandSyntax& command, options::Settings& settings);

/// Adds --threads.
CLI::Option* add_threads(CommandSyntax& command, options::Settings& settings);

/// Adds --gather, --threads, --stats and --quiet.
void add_running_options(CommandSyntax& command, options::Settings& settings, JobArguments& jobs,
                         DocumentArguments& documents);

void add_render(CommandSyntax& root, RenderArguments& arguments, RenderChoices& choices);

/// Returns the given options of `render` that affect how a drawing is solved.
std::vector<std::string> given_drawing_options(const CLI::App& render);

void add_solve(CommandSyntax& root, SolveArguments& arguments, JobChoices& choices);

/// Applies the choices; throws CLI::ValidationError if options conflict.
void settle(SolveArguments& arguments, const JobChoices& choices);

/// Applies the choices; throws CLI::ValidationError if options conflict.
void settle(RenderArguments& arguments, const RenderChoices& choices);

}  // namespace sfumato::cli
