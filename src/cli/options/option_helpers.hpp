#pragma once

#include <functional>
#include <optional>
#include <string>

#include "cli/files/paths.hpp"
#include "cli/options/arguments.hpp"
#include "cli/options/command_syntax.hpp"
#include "options/option.hpp"
#include "options/settle.hpp"

/// Helpers for options whose values our own parsers read, so that each error says what to use.
namespace sfumato::cli {

/// Throws CLI::ValidationError for `option` unless `good`.
void expect(bool good, const char* option, const std::string& complaint);

/// Throws CLI::ValidationError for `option` unless the complaint is empty.
void expect_none(const char* option, const std::string& complaint);

/// Throws CLI::ValidationError for a conflict, if there is one.
void expect_none(const options::Conflict& conflict);

/// Adds --shard; "3/16" is the fourth of sixteen.
CLI::Option* add_shard(CommandSyntax& command, std::optional<Shard>& shard, const char* help);

/// Adds the option -o, whose value is called value_name in the help.
CLI::Option* add_output(CommandSyntax& command, std::string& output, const OutputNames& names,
                        const std::string& value_name, const std::string& help);

/// Adds --out-dir, after -o.
void add_output_folder(CommandSyntax& command, std::string& folder, const JobWords& words);

/// Adds the document IN, and --allow-files, which names folders for its textures.
void add_document(CommandSyntax& command, DocumentArguments& arguments, bool takes_solved);

/// --allow-files alone.
void add_allowed_folders(CommandSyntax& command, DocumentArguments& arguments);

/// Adds --stats.
void add_stats(CommandSyntax& command, std::string& stats, const char* help);

/// Returns the heading of a group in the help.
const char* heading(options::Group group);

/// Adds an option that calls `set` with the values that it accepts.
CLI::Option* add_option(CommandSyntax& command, const options::OptionInfo& option,
                        std::function<void(const options::Value&)> set);

/// Adds an option of a table of options/tables.hpp that sets `target`.
template <class Target>
CLI::Option* add_option(CommandSyntax& command, const options::Option<Target>& option,
                        Target& target) {
  return add_option(command, option.info, [set = option.set, &target](const options::Value& value) {
    set(target, value);
  });
}

}  // namespace sfumato::cli
