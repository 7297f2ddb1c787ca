#pragma once

#include "cli/arguments.hpp"
#include "cli/option_helpers.hpp"
#include "cli/render_options.hpp"

/// Options of the commands with which a drawing begins.
namespace sfumato::cli {

CLI::App* add_init(CLI::App& root, InitArguments& arguments);
CLI::App* add_watch(CLI::App& root, WatchArguments& arguments, RenderChoices& choices);
CLI::App* add_edit(CLI::App& root, EditArguments& arguments);

/// Throw CLI::ValidationError if options conflict.
void settle(InitArguments& arguments);
void settle(WatchArguments& arguments, const RenderChoices& choices);
void settle(const EditArguments& arguments);

}  // namespace sfumato::cli
