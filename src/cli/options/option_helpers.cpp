#include "cli/options/option_helpers.hpp"

#include <algorithm>
#include <filesystem>
#include <span>
#include <string_view>
#include <system_error>

#include "options/values.hpp"

namespace sfumato::cli {
namespace {

/// In the order of options::Group.
constexpr const char* kHeadings[] = {"Options",
                                     "Drawing",
                                     "Part and size",
                                     "Solution",
                                     "Mesh (no effect with --method pixels)",
                                     "Image",
                                     "HTML, PDF, EPS, SVG and GLB",
                                     "Running",
                                     "Limits"};
static_assert(std::size(kHeadings) == static_cast<std::size_t>(options::Group::resources) + 1);

/// Returns what is wrong with the name of a folder, or nothing.
std::string complaint_about_folder(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return {};
  return "there is no folder \"" + path + "\"; use a folder that exists";
}

/// Reads the I/N of --shard.
std::optional<Shard> parse_shard(std::string_view text) {
  constexpr std::uint64_t kMostShards = 1'000'000;
  const std::size_t slash = std::min(text.find('/'), text.size());
  const auto count =
      options::parse_whole(text.substr(std::min(slash + 1, text.size())), 1, kMostShards);
  if (!count) return std::nullopt;
  const auto index = options::parse_whole(text.substr(0, slash), 0, *count - 1);
  if (!index) return std::nullopt;
  return Shard{static_cast<int>(*index), static_cast<int>(*count)};
}

}  // namespace

void expect(bool good, const char* option, const std::string& complaint) {
  if (!good) throw CLI::ValidationError(option, complaint);
}

void expect_none(const char* option, const std::string& complaint) {
  expect(complaint.empty(), option, complaint);
}

void expect_none(const options::Conflict& conflict) {
  expect(conflict.key.empty(), options::spelled(conflict.key, true).c_str(),
         options::spelled(conflict.complaint, true));
}

CLI::Option* add_shard(CommandSyntax& command, std::optional<Shard>& shard, const char* help) {
  const options::OptionInfo info{.key = "shard",
                                 .kind = options::ValueKind::text,
                                 .expected = "I/N, with I from 0 to N - 1",
                                 .value_name = "I/N",
                                 .help = help};
  return add_option(command, info, [&shard, info](const options::Value& value) {
    shard = parse_shard(value.text);
    expect(shard.has_value(), "--shard", options::complaint_about_value(info, value.text));
  });
}

CLI::Option* add_output(CommandSyntax& command, std::string& output, const OutputNames& names,
                        const std::string& value_name, const std::string& help) {
  const auto read = [&output, names](const std::string& name) {
    expect_none("--output", complaint_about_output(name, names));
    output = name;
  };
  CLI::Option* const added = command.add_option_function<std::string>("-o,--output", read, help);
  return command.describe(added->type_name(value_name), form_of_output(extensions_of(names)));
}

void add_output_folder(CommandSyntax& command, std::string& folder, const JobWords& words) {
  const std::string help = std::string("Write each ") + words.output +
                           " into this folder instead, named after\nits " + words.input +
                           "; the folder is created if needed";
  command.add_file("--out-dir", folder, "DIR", help, {.kind = "folder", .is_output = true})
      ->excludes("--output");
}

void add_document(CommandSyntax& command, DocumentArguments& arguments, bool takes_solved) {
  const std::string solved = takes_solved ? " or a solved picture (.sfp);\n" : "; ";
  std::span<const std::string_view> extensions = kDrawings;
  if (takes_solved) extensions = kDrawingsAndSolved;
  command
      .add_file("IN", arguments.input, "", "A drawing (SVG or Orzan XML)" + solved + "'-': stdin",
                form_of_input(extensions))
      ->required();
  add_allowed_folders(command, arguments);
}

void add_allowed_folders(CommandSyntax& command, DocumentArguments& arguments) {
  command
      .add_file("--allow-files", arguments.allowed_folders, "DIR",
                "Also read textures from this folder and its subfolders;\nmay be repeated "
                "[only the folder of IN]",
                {.kind = "folder"})
      ->allow_extra_args(false)
      ->check(CLI::Validator(complaint_about_folder, ""));
}

void add_stats(CommandSyntax& command, std::string& stats, const char* help) {
  constexpr std::string_view kJson[] = {"json"};
  command.add_file("--stats", stats, "FILE.json", help, form_of_output(kJson))
      ->group(heading(options::Group::running));
}

const char* heading(options::Group group) {
  return kHeadings[static_cast<std::size_t>(group)];
}

CLI::Option* add_option(CommandSyntax& command, const options::OptionInfo& option,
                        std::function<void(const options::Value&)> set) {
  const std::string label = std::string("--") + option.key;
  const std::string help = options::spelled(option.help, true);
  CLI::Option* added = nullptr;
  if (option.kind == options::ValueKind::flag) {
    added = command.add_flag_callback(
        label, [set] { set({}); }, help);
  } else {
    const auto read = [set, option, label](const std::string& text) {
      const std::optional<options::Value> value = options::parse_value(option, text);
      if (!value) throw CLI::ValidationError(label, options::complaint_about_value(option, text));
      set(*value);
    };
    added = command.add_option_function<std::string>(label, read, help)
                ->type_name(options::value_name(option));
  }
  if (option.excludes) added->excludes(command.get_option(std::string("--") + option.excludes));
  return command.describe(added->group(heading(option.group)), form_of(option));
}

}  // namespace sfumato::cli
