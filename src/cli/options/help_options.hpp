#pragma once

#include <string>

#include "cli/options/command_syntax.hpp"

namespace sfumato::cli {

/// Arguments of `help`. Without a command: the help of the program.
struct HelpArguments {
  std::string command;
  bool json = false;  ///< of all commands
};

/// Adds the command after all others, which it lists as its choices.
void add_help(CommandSyntax& root, HelpArguments& arguments);

/// Returns the help of a command, which may be the root.
std::string help_of(const CommandSyntax& command);

/// Returns a JSON document that describes the program: docs/cli.md, help.
std::string help_json(const CommandSyntax& root);

}  // namespace sfumato::cli
