#pragma once

#include "cli/options/arguments.hpp"
#include "cli/options/option_helpers.hpp"

/// Options of the commands that read a document but do not draw it.
namespace sfumato::cli {

void add_info(CommandSyntax& root, InfoArguments& arguments);
void add_convert(CommandSyntax& root, ConvertArguments& arguments);
void add_lint(CommandSyntax& root, LintArguments& arguments);

}  // namespace sfumato::cli
