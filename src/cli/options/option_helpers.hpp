#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/files/paths.hpp"
#include "cli/options/arguments.hpp"
#include "options/option.hpp"
#include "options/values.hpp"

/// Helpers for options whose values our own parsers read, so that each error says what to use.
namespace sfumato::cli {

/// Throws CLI::ValidationError for `option` unless `good`.
void expect(bool good, const char* option, const std::string& complaint);

/// A description of the values that an option accepts, and their form in the help.
struct ValueText {
  std::string expected;
  std::string value_name;
  std::vector<std::string> words{};  ///< all accepted values, if these are a few words
};

/// Describes a value that is one of these words. The help shows value_name or, if that is empty,
/// all words.
ValueText one_of(std::vector<std::string> words, std::string value_name = {});

/// Returns "; did you mean X?" if the text is similar to one of the words; else nothing.
std::string word_hint(const std::string& text, const std::vector<std::string>& words);

/// Adds a long option, perhaps after a short one. `set(text)` returns false if the text is not a
/// valid value.
template <class Set>
CLI::Option* add_value(CLI::App& app, const std::string& name, const ValueText& value_text,
                       const std::string& help, Set set) {
  const std::string label = name.substr(name.find("--"));
  const auto read = [set, label, value_text](const std::string& text) {
    if (!set(text)) {
      throw CLI::ValidationError(label, "invalid value \"" + text + "\"; use " +
                                            value_text.expected +
                                            word_hint(text, value_text.words));
    }
  };
  return app.add_option_function<std::string>(name, read, help)->type_name(value_text.value_name);
}

/// Returns a function that sets `target` to the result of `parse` and returns false if that is
/// empty.
template <class Target, class Parse>
auto into(Target& target, Parse parse) {
  return [&target, parse](const std::string& text) {
    const auto value = parse(text);
    if (value) target = *value;
    return value.has_value();
  };
}

/// Like `into`, for whole numbers in [lowest, highest].
template <class Target>
auto whole_into(Target& target, std::uint64_t lowest, std::uint64_t highest) {
  return [&target, lowest, highest](const std::string& text) {
    const std::optional<std::uint64_t> value = options::parse_whole(text, lowest, highest);
    if (value) target = static_cast<int>(*value);
    return value.has_value();
  };
}

/// Describes the values that parse_shard() reads.
inline const ValueText kShardText{"I/N, with I from 0 to N - 1", "I/N"};

/// Reads a shard: "3/16" is the fourth of sixteen.
std::optional<Shard> parse_shard(const std::string& text);

/// Adds the option -o, whose value is called value_name in the help.
CLI::Option* add_output(CLI::App& app, std::string& output, const OutputNames& names,
                        const std::string& value_name, const std::string& help);

/// Adds the document IN, and --allow-files, which names folders for its textures.
void add_document(CLI::App& app, DocumentArguments& arguments);

/// --allow-files alone.
void add_allowed_folders(CLI::App& app, DocumentArguments& arguments);

/// Returns the heading of a group in the help.
const char* heading(options::Group group);

/// Adds an option that calls `set` with the texts that it accepts.
CLI::Option* add_option(CLI::App& app, const options::OptionInfo& option,
                        std::function<void(const options::Value&)> set);

/// Adds an option of a table of options/tables.hpp that sets `target`.
template <class Target>
CLI::Option* add_option(CLI::App& app, const options::Option<Target>& option, Target& target) {
  return add_option(app, option.info,
                    [&option, &target](const options::Value& value) { option.set(target, value); });
}

}  // namespace sfumato::cli
