#include "cli/options/option_helpers.hpp"

#include <filesystem>
#include <string_view>
#include <system_error>

#include "formats/text/suggestion.hpp"

namespace sfumato::cli {
namespace {

/// Returns what is wrong with the name of a folder, or nothing.
std::string complaint_about_folder(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return {};
  return "there is no folder \"" + path + "\"; use a folder that exists";
}

}  // namespace

void expect(bool good, const char* option, const std::string& complaint) {
  if (!good) throw CLI::ValidationError(option, complaint);
}

ValueText one_of(std::vector<std::string> words, std::string value_name) {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : "|") + word;
  if (value_name.empty()) value_name = list;
  return {"one of " + list, std::move(value_name), std::move(words)};
}

std::string word_hint(const std::string& text, const std::vector<std::string>& words) {
  const std::vector<std::string_view> candidates(words.begin(), words.end());
  return text::did_you_mean(text, candidates);
}

std::optional<Shard> parse_shard(const std::string& text) {
  constexpr std::uint64_t kMostShards = 1'000'000;
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) return std::nullopt;
  const auto count = options::parse_whole(text.substr(slash + 1), 1, kMostShards);
  if (!count) return std::nullopt;
  const auto index = options::parse_whole(text.substr(0, slash), 0, *count - 1);
  if (!index) return std::nullopt;
  return Shard{static_cast<int>(*index), static_cast<int>(*count)};
}

CLI::Option* add_output(CLI::App& app, std::string& output, const OutputNames& names,
                        const std::string& value_name, const std::string& help) {
  const auto read = [&output, names](const std::string& name) {
    const std::string complaint = complaint_about_output(name, names);
    if (!complaint.empty()) throw CLI::ValidationError("--output", complaint);
    output = name;
  };
  return app.add_option_function<std::string>("-o,--output", read, help)->type_name(value_name);
}

void add_document(CLI::App& app, DocumentArguments& arguments) {
  app.add_option("IN", arguments.input, "A drawing (SVG or Orzan XML); '-': stdin")
      ->required()
      ->type_name("");
  add_allowed_folders(app, arguments);
}

void add_allowed_folders(CLI::App& app, DocumentArguments& arguments) {
  app.add_option("--allow-files", arguments.allowed_folders,
                 "Also read textures from this folder and its subfolders;\nmay be repeated "
                 "[only the folder of IN]")
      ->type_name("DIR")
      ->allow_extra_args(false)
      ->check(CLI::Validator(complaint_about_folder, ""));
}

const char* heading(options::Group group) {
  switch (group) {
    case options::Group::none:
      break;
    case options::Group::drawing:
      return "Drawing";
    case options::Group::place:
      return "Part and size";
    case options::Group::solution:
      return "Solution";
    case options::Group::mesh:
      return "Mesh (no effect with --method pixels)";
    case options::Group::image:
      return "Image";
    case options::Group::vector:
      return "HTML, PDF, EPS, SVG and GLB";
    case options::Group::running:
      return "Running";
    case options::Group::resources:
      return "Limits";
  }
  return "Options";
}

CLI::Option* add_option(CLI::App& app, const options::OptionInfo& option,
                        std::function<void(const options::Value&)> set) {
  const std::string label = std::string("--") + option.key;
  const std::string help = options::spelled(option.help, true);
  CLI::Option* added = nullptr;
  if (option.kind == options::ValueKind::flag) {
    added = app.add_flag_callback(
        label, [set] { set({}); }, help);
  } else {
    const auto read = [set, &option, label](const std::string& text) {
      const std::optional<options::Value> value = options::parse_value(option, text);
      if (!value) throw CLI::ValidationError(label, options::complaint_about_value(option, text));
      set(*value);
    };
    added = app.add_option_function<std::string>(label, read, help)
                ->type_name(options::value_name(option));
  }
  if (option.excludes) added->excludes(app.get_option(std::string("--") + option.excludes));
  return added->group(heading(option.group));
}

}  // namespace sfumato::cli
