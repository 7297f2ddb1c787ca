#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/json.hpp"
#include "cli/messages.hpp"
#include "cli/options/help_options.hpp"

namespace sfumato::cli {
namespace {

/// Returns the text without the line breaks of the help.
std::string in_one_line(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  return text;
}

/// Returns the paragraphs of a text, each in one line.
std::vector<std::string> paragraphs(std::string_view text) {
  std::vector<std::string> result;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find("\n\n"), text.size());
    result.push_back(in_one_line(std::string(text.substr(0, end))));
    text.remove_prefix(std::min(end + 2, text.size()));
  }
  return result;
}

void write_texts(JsonWriter& json, std::string_view name, const auto& texts) {
  json.key(name).begin_array();
  for (const auto& text : texts) json.value(std::string_view(text));
  json.end_array();
}

std::vector<std::string> names_of(const CLI::Option& option) {
  if (option.get_positional()) return {option.get_name()};
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back('-' + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

/// Writes the last names of other options of the command, in the order of the help.
void write_others(JsonWriter& json, std::string_view name, const CommandSyntax& command,
                  const std::set<CLI::Option*>& others) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    const bool is_one = std::ranges::find(others, option) != others.end();
    if (is_one) names.push_back(names_of(*option).back());
  }
  if (!names.empty()) write_texts(json, name, names);
}

void write_form(JsonWriter& json, const ValueForm& form) {
  json.member("kind", std::string_view(form.kind));
  if (form.kind == "file" || form.kind == "folder") json.key("is_output").truth(form.is_output);
  if (!form.extensions.empty()) write_texts(json, "extensions", form.extensions);
  if (!form.choices.empty()) write_texts(json, "choices", form.choices);
  if (form.lowest) json.member(form.is_above ? "above" : "lowest", *form.lowest);
  if (form.highest) json.member("highest", *form.highest);
  if (!form.expected.empty()) json.member("expected", std::string_view(form.expected));
}

/// Writes the description. A help text ends with the default in brackets.
void write_description(JsonWriter& json, const CLI::Option& option) {
  const std::string text = in_one_line(option.get_description());
  const std::size_t bracket = text.ends_with(']') ? text.rfind(" [") : std::string::npos;
  json.member("description", std::string_view(text).substr(0, bracket));
  if (bracket == std::string::npos) return;
  json.member("default", std::string_view(text).substr(bracket + 2, text.size() - bracket - 3));
}

void write_option(JsonWriter& json, const CommandSyntax& command, const CLI::Option& option) {
  json.begin_object();
  write_texts(json, "names", names_of(option));
  write_description(json, option);
  write_form(json, command.form(&option));
  const std::string value_name = option.get_type_name();
  if (!value_name.empty()) json.member("value_name", std::string_view(value_name));
  json.key("is_required").truth(option.get_required());
  json.key("is_repeatable").truth(option.get_items_expected_max() > 1);
  write_others(json, "excludes", command, option.get_excludes());
  write_others(json, "needs", command, option.get_needs());
  if (!option.get_positional()) json.member("group", std::string_view(option.get_group()));
  json.end_object();
}

/// Writes the operands or the options of a command.
void write_options(JsonWriter& json, const CommandSyntax& command, bool operands) {
  json.key(operands ? "operands" : "options").begin_array();
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional() == operands) write_option(json, command, *option);
  }
  json.end_array();
}

/// Writes the members that the program and a command have.
void write_command(JsonWriter& json, const CommandSyntax& command) {
  const CommandTexts& texts = command.texts();
  json.member("name", std::string_view(texts.name));
  json.member("summary", std::string_view(texts.summary));
  write_texts(json, "usages", texts.usages);
  write_texts(json, "notes", paragraphs(texts.notes));
  write_texts(json, "examples", texts.examples);
  write_options(json, command, true);
  write_options(json, command, false);
}

}  // namespace

std::string help_json(const CommandSyntax& root) {
  JsonWriter json;
  json.begin_object();
  json.member("version", std::string_view(SFUMATO_VERSION));
  write_command(json, root);
  json.key("commands").begin_array();
  for (const CommandSyntax* command : root.commands()) {
    json.begin_object();
    write_command(json, *command);
    json.end_object();
  }
  json.end_array().key("exit_codes").begin_array();
  for (const ExitMeaning& exit : exit_meanings()) {
    json.begin_object().member("code", exit.code);
    json.member("meaning", std::string_view(exit.meaning)).end_object();
  }
  json.end_array().end_object();
  return json.text() + '\n';
}

}  // namespace sfumato::cli
