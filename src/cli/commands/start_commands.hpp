#pragma once

#include "cli/options/arguments.hpp"
#include "cli/options/option_helpers.hpp"
#include "cli/options/render_options.hpp"

/// Options of the commands that start a drawing.
namespace sfumato::cli {

void add_init(CommandSyntax& root, InitArguments& arguments);
void add_watch(CommandSyntax& root, WatchArguments& arguments, RenderChoices& choices);
void add_edit(CommandSyntax& root, EditArguments& arguments);

/// Throw CLI::ValidationError if options conflict.
void settle(InitArguments& arguments);
void settle(WatchArguments& arguments, const RenderChoices& choices);
void settle(const EditArguments& arguments);

}  // namespace sfumato::cli
