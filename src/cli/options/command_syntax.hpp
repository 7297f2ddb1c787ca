#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "options/option.hpp"

namespace sfumato::cli {

/// Describes the values of an option or an operand. docs/cli.md explains the members.
struct ValueForm {
  std::string kind = "text";
  std::string expected{};                      ///< the values in words, as in messages
  std::vector<std::string_view> choices{};     ///< accepted words
  std::vector<std::string_view> extensions{};  ///< usual extensions of the files, without dots
  bool is_output = false;                      ///< the command writes the file or folder
  std::optional<double> lowest{}, highest{};
  bool is_above = false;  ///< `lowest` itself is no value
};

/// Returns the form of an option of a table.
ValueForm form_of(const options::OptionInfo& option);

/// Return the forms of files that a command reads or writes.
ValueForm form_of_input(std::span<const std::string_view> extensions);
ValueForm form_of_output(std::span<const std::string_view> extensions);

/// The usual extensions of inputs.
inline constexpr std::string_view kDrawings[] = {"svg", "svgz", "xml"};
inline constexpr std::string_view kDrawingsAndSolved[] = {"svg", "svgz", "xml", "sfp"};
inline constexpr std::string_view kPhotos[] = {"png", "jpg", "jpeg", "webp"};

/// The texts of a command in the help.
struct CommandTexts {
  const char* name;
  const char* summary;
  std::span<const char* const> usages;    ///< each without the command's name
  std::span<const char* const> examples;  ///< each a line of a shell
  const char* notes = "";                 ///< paragraphs
};

/// A command as the parser, the help and `sfumato help --json` know it; or the program, which has
/// commands.
class CommandSyntax : public CLI::App {
 public:
  /// root: the program, or null if this is the program.
  explicit CommandSyntax(const CommandTexts& texts, CommandSyntax* root = nullptr);

  CommandSyntax& add_command(const CommandTexts& texts);

  /// Adds an option, or an operand if the name has no dash. A vector as target takes several files.
  template <class Target>
  CLI::Option* add_file(const std::string& name, Target& target, const std::string& value_name,
                        const std::string& help, ValueForm form) {
    return describe(add_option(name, target, help)->type_name(value_name), std::move(form));
  }

  CLI::Option* describe(CLI::Option* option, ValueForm form);

  const CommandTexts& texts() const { return texts_; }
  ValueForm form(const CLI::Option* option) const;
  std::span<CommandSyntax* const> commands() const { return commands_; }

 private:
  CommandTexts texts_;
  std::map<const CLI::Option*, ValueForm> forms_;  ///< of options with values
  std::vector<CommandSyntax*> commands_;           ///< which CLI::App owns
};

}  // namespace sfumato::cli
