#include "cli/options/help_options.hpp"

namespace sfumato::cli {
namespace {

constexpr const char* kHelpUsages[] = {"[COMMAND]", "--json"};
constexpr const char* kHelpExamples[] = {"sfumato help", "sfumato help render",
                                         "sfumato help --json"};

}  // namespace

void add_help(CommandSyntax& root, HelpArguments& arguments) {
  CommandSyntax& command = root.add_command({.name = "help",
                                             .summary = "Print the help of a command",
                                             .usages = kHelpUsages,
                                             .examples = kHelpExamples});
  ValueForm form{.kind = "choice"};
  for (const CommandSyntax* known : root.commands()) form.choices.push_back(known->texts().name);
  command.add_file("COMMAND", arguments.command, "", "A command [the program]", std::move(form));
  command.add_flag("--json", arguments.json,
                   "Print one JSON object that describes all commands and\noptions");
}

std::string help_of(const CommandSyntax& command) {
  const CLI::App* root = command.get_parent();
  const std::string name = command.get_name();
  return command.get_formatter()->make_help(&command, root ? root->get_name() + ' ' + name : name,
                                            CLI::AppFormatMode::Normal);
}

}  // namespace sfumato::cli
