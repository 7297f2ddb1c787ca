#pragma once

#include "cli/options/arguments.hpp"
#include "cli/options/option_helpers.hpp"

/// Options of the commands that read a document but do not draw it.
namespace sfumato::cli {

CLI::App* add_info(CLI::App& root, InfoArguments& arguments);
CLI::App* add_convert(CLI::App& root, ConvertArguments& arguments);
CLI::App* add_lint(CLI::App& root, LintArguments& arguments);

}  // namespace sfumato::cli
