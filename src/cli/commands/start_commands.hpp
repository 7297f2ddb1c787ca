#pragma once

#include "cli/options/arguments.hpp"
#include "cli/options/option_helpers.hpp"
#include "cli/options/render_options.hpp"

/// Options of the commands that start a drawing.
namespace sfumato::cli {

CLI::App* add_init(CLI::App& root, InitArguments& arguments);
CLI::App* add_watch(CLI::App& root, WatchArguments& arguments, RenderChoices& choices);
CLI::App* add_edit(CLI::App& root, EditArguments& arguments);

/// Throw CLI::ValidationError if options conflict.
void settle(InitArguments& arguments);
void settle(WatchArguments& arguments, const RenderChoices& choices);
void settle(const EditArguments& arguments);

}  // namespace sfumato::cli
