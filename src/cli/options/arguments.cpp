#include "cli/options/arguments.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "base/text/utf8.hpp"
#include "cli/commands/document_commands.hpp"
#include "cli/commands/start_commands.hpp"
#include "cli/files/file_uses.hpp"
#include "cli/options/help_options.hpp"
#include "cli/options/option_helpers.hpp"
#include "cli/options/render_options.hpp"
#include "cli/options/tiles_options.hpp"
#include "cli/options/trace_options.hpp"
#include "formats/text/suggestion.hpp"
#include "options/values.hpp"

namespace sfumato::cli {
namespace {

constexpr const char* kRootExamples[] = {"sfumato init drawing.svg",
                                         "sfumato edit drawing.svg",
                                         "sfumato watch drawing.svg",
                                         "sfumato render lady_bug.xml -o lady_bug.png",
                                         "sfumato solve lady_bug.xml -o lady_bug.sfp",
                                         "sfumato tiles lady_bug.sfp -o deep --scale 128",
                                         "sfumato info lady_bug.xml",
                                         "sfumato convert lady_bug.xml -o lady_bug.svg",
                                         "sfumato trace photo.jpg -o drawing.svg",
                                         "sfumato lint lady_bug.svg",
                                         "sfumato compare before.png after.png -o difference.png"};

constexpr const char* kRootNotes =
    "Run `sfumato help COMMAND` for the options of a command.\n"
    "\n"
    "A drawing is an SVG with the attributes of the namespace urn:sfumato:1, plain or packed by\n"
    "gzip, or the XML of Orzan et al. '-' is standard input, and as an output standard output.\n"
    "Textures are read from the drawing's folder and its subfolders, or from the current folder\n"
    "if the drawing comes from standard input; nothing is fetched.\n"
    "\n"
    "Messages are one line on standard error, with file, line and column if they are known.\n"
    "Output files appear whole or not at all.";

constexpr const char* kRootUsages[] = {"COMMAND [ARGUMENTS]", "help [COMMAND]", "--version"};

constexpr CommandTexts kRoot{
    .name = "sfumato",
    .summary =
        "Sfumato draws diffusion curves: Bezier curves with a colour on each side that "
        "spreads smoothly.",
    .usages = kRootUsages,
    .examples = kRootExamples,
    .notes = kRootNotes};

constexpr const char* kCompareExamples[] = {
    "sfumato compare exact.png fast.png",
    "sfumato compare exact.png fast.png -o difference.png --scale 32"};

constexpr std::string_view kPng[] = {"png"};
constexpr const char* kCompareUsages[] = {"A B [-o OUT.png [--scale NUMBER]] [OPTIONS]"};

void add_compare(CommandSyntax& root, CompareArguments& arguments) {
  CommandSyntax& command = root.add_command({.name = "compare",
                                             .summary = "Measure how much two PNG images differ",
                                             .usages = kCompareUsages,
                                             .examples = kCompareExamples});
  for (const auto& [name, picture] : {std::pair("A", &arguments.first), {"B", &arguments.second}}) {
    command.add_file(name, *picture, "", "A PNG file; '-': stdin", form_of_input(kPng))->required();
  }
  add_output(command, arguments.output, {.only = OutputKind::png}, "OUT.png",
             "Write a picture of the differences");
  add_option(command,
             {.key = "scale",
              .kind = options::ValueKind::number,
              .expected = "a number above 0",
              .value_name = "NUMBER",
              .help = "Multiply the differences in the picture [128]"},
             [&arguments](const options::Value& value) { arguments.scale = *value.number; })
      ->needs(command.get_option("--output"));
  command.add_flag("--json", arguments.json, "Print one JSON object");
  add_resources(command, arguments.resources);
}

void settle(const CompareArguments& arguments) {
  expect(arguments.first != "-" || arguments.second != "-", "B",
         "both pictures are '-', but stdin can be read only once; give a file name for one");
  expect(arguments.output != "-", "--output", "stdout is taken by the figures; use a file name");
  expect_none("--output",
              complaint_about({{arguments.first, "the picture"}, {arguments.second, "the picture"}},
                              {{arguments.output, "the picture of the differences", "--output"}}));
}

void settle(ConvertArguments& arguments) {
  expect_none("--output",
              complaint_about({{arguments.input, "the drawing"}},
                              {{arguments.output, "the converted drawing", "--output"}}));
  arguments.outputs = {arguments.output};
}

/// Returns the beginning of a complaint, without control characters. It quotes arguments of any
/// length.
std::string shortened(const std::string& text) {
  constexpr std::size_t kMostBytes = 1000;
  std::size_t end = std::min(text.size(), kMostBytes);
  const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; };
  while (end < text.size() && end > 0 && continues(text[end])) --end;
  return printable(text.substr(0, end), "\n") + (end < text.size() ? "…" : "");
}

/// Returns the option that a one-letter option of other programs stands for, as a hint.
std::string meaning_elsewhere(std::string_view option) {
  if (option.starts_with("-w")) return "; use --width";
  if (option.starts_with("-z") || option.starts_with("-s")) return "; use --scale";
  if (option.starts_with("-d")) return "; use --dpi";
  if (option.starts_with("-b")) return "; use --background";
  return {};
}

/// Returns a hint at the option that was probably meant: the nearest name, or the first name that
/// begins with the text.
std::string option_hint(const CLI::App& command, std::string_view name) {
  std::vector<std::string_view> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& known : option->get_lnames()) names.push_back(known);
  }
  std::string_view best = text::nearest(name, names);
  const auto begun = std::ranges::find_if(
      names, [name](std::string_view known) { return known.starts_with(name); });
  if (best.empty() && !name.empty() && begun != names.end()) best = *begun;
  return best.empty() ? std::string() : "; did you mean --" + std::string(best) + "?";
}

/// Returns what is wrong with the first option that the command does not have, or nothing.
std::string unknown_option(const CLI::App& command) {
  for (const std::string& argument : command.remaining()) {
    if (!argument.starts_with('-') || argument.size() < 2) continue;
    const std::string option = argument.substr(0, argument.find('='));
    return "unknown option " + text::quoted(option) + " for " + command.get_name() +
           (option.starts_with("--") ? option_hint(command, std::string_view(option).substr(2))
                                     : meaning_elsewhere(option));
  }
  return {};
}

/// Returns "render, solve or tiles".
std::string one_of(std::span<const std::string_view> names) {
  std::string list;
  for (std::size_t i = 0; i < names.size(); ++i) {
    list.append(i == 0 ? "" : i + 1 == names.size() ? " or " : ", ").append(names[i]);
  }
  return list;
}

std::string unknown_command(std::string_view given, const CommandSyntax& root) {
  std::vector<std::string_view> names;
  for (const CommandSyntax* command : root.commands()) names.push_back(command->texts().name);
  const std::string hint = given.starts_with("--") ? option_hint(root, given.substr(2))
                                                   : text::did_you_mean(given, names);
  return (given.starts_with("-") ? "unknown option \"" : "unknown command \"") +
         std::string(given) + "\"; use " + one_of(names) + hint;
}

/// Returns what is wrong with an argument before the command, or nothing.
std::string misplaced_argument(const CommandSyntax& root) {
  const std::vector<std::string> remaining = root.remaining();
  if (remaining.empty()) return {};
  const std::string option = remaining.front().substr(0, remaining.front().find('='));
  std::vector<std::string_view> owners;
  for (const CommandSyntax* command : root.commands()) {
    const bool has_option = option.starts_with('-') && command->get_option_no_throw(option);
    if (has_option) owners.push_back(command->texts().name);
  }
  if (!owners.empty()) {
    return "option " + text::quoted(option) + " before the command; use it after " + one_of(owners);
  }
  return root.get_subcommands().empty() ? unknown_command(remaining.front(), root) : std::string();
}

NoCommand usage_error(const CommandSyntax& root, std::string what) {
  std::string command = "sfumato";
  for (const CLI::App* chosen : root.get_subcommands()) {
    command += ' ' + chosen->get_name();
    if (std::string unknown = unknown_option(*chosen); !unknown.empty()) what = std::move(unknown);
  }
  if (std::string misplaced = misplaced_argument(root); !misplaced.empty()) {
    what = std::move(misplaced);
  }
  return {"sfumato: error: " + shortened(what) + "\nTry '" + command + " --help'.\n", kBadUsage};
}

/// Returns what is wrong with a call for help: an unknown command, or -h with a number, which other
/// programs take for a height. Empty: nothing is wrong.
std::string wrong_beside_help(const CommandSyntax& root, std::span<const char* const> arguments) {
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    const std::string_view argument = arguments[i];
    if (root.get_subcommands().empty() && !argument.starts_with('-')) {
      return unknown_command(argument, root);
    }
    if (argument != "-h" || i + 1 == arguments.size()) continue;
    if (options::parse_number(arguments[i + 1])) return "-h prints help; use --height";
  }
  return {};
}

/// Returns the exit codes for the help of the program.
std::string exit_code_list() {
  std::string text = "\n\nExit codes:\n";
  for (const ExitMeaning& exit : exit_meanings()) {
    const std::string code = std::to_string(exit.code);
    text += "  " + code + std::string(5 - code.size(), ' ') + exit.meaning + '\n';
  }
  text.pop_back();
  return text;
}

/// Holds the commands and their arguments.
class CommandLine {
 public:
  CommandLine();
  Command parse(int argc, const char* const* argv);

 private:
  Command chosen();
  Command settled_start();
  Command settled_help() const;

  CommandSyntax root_{kRoot};
  RenderArguments render_;
  RenderChoices render_choices_;
  SolveArguments solve_;
  JobChoices solve_choices_;
  TilesArguments tiles_;
  TilesChoices tiles_choices_;
  InfoArguments info_;
  ConvertArguments convert_;
  LintArguments lint_;
  CompareArguments compare_;
  InitArguments init_;
  WatchArguments watch_;
  RenderChoices watch_choices_;
  EditArguments edit_;
  TraceArguments trace_;
  TraceChoices trace_choices_;
  HelpArguments help_;
};

CommandLine::CommandLine() {
  root_.footer(root_.get_footer() + exit_code_list());
  root_.set_help_flag("-h,--help", "Print this help");
  root_.set_version_flag("--version", "sfumato " SFUMATO_VERSION, "Print the version");
  root_.require_subcommand(0, 1);
  add_render(root_, render_, render_choices_);
  add_solve(root_, solve_, solve_choices_);
  add_tiles(root_, tiles_, tiles_choices_);
  add_info(root_, info_);
  add_convert(root_, convert_);
  add_trace(root_, trace_, trace_choices_);
  add_lint(root_, lint_);
  add_compare(root_, compare_);
  add_init(root_, init_);
  add_watch(root_, watch_, watch_choices_);
  add_edit(root_, edit_);
  add_help(root_, help_);
}

Command CommandLine::chosen() {
  if (root_.got_subcommand("render")) {
    settle(render_, render_choices_);
    render_.drawing_options = given_drawing_options(*root_.get_subcommand("render"));
    return render_;
  }
  if (root_.got_subcommand("solve")) {
    settle(solve_, solve_choices_);
    return solve_;
  }
  if (root_.got_subcommand("tiles")) {
    settle(tiles_, tiles_choices_);
    return tiles_;
  }
  if (root_.got_subcommand("info")) return info_;
  if (root_.got_subcommand("convert")) {
    settle(convert_);
    return convert_;
  }
  if (root_.got_subcommand("trace")) {
    settle(*root_.get_subcommand("trace"), trace_, trace_choices_);
    return trace_;
  }
  if (root_.got_subcommand("lint")) return lint_;
  if (root_.got_subcommand("compare")) {
    settle(compare_);
    return compare_;
  }
  return settled_start();
}

/// Returns the chosen command if it starts a drawing, or is help: init, watch or edit.
Command CommandLine::settled_start() {
  if (root_.got_subcommand("init")) {
    settle(init_);
    return init_;
  }
  if (root_.got_subcommand("watch")) {
    settle(watch_, watch_choices_);
    return watch_;
  }
  if (root_.got_subcommand("edit")) {
    settle(edit_);
    return edit_;
  }
  return root_.got_subcommand("help") ? settled_help() : NoCommand{help_of(root_), kBadUsage};
}

Command CommandLine::settled_help() const {
  if (help_.json) {
    expect(help_.command.empty(), "--json",
           "describes all commands; leave out \"" + help_.command + "\"");
    return NoCommand{help_json(root_), kDone};
  }
  if (help_.command.empty()) return NoCommand{help_of(root_), kDone};
  for (const CommandSyntax* command : root_.commands()) {
    if (command->texts().name == help_.command) return NoCommand{help_of(*command), kDone};
  }
  return usage_error(root_, unknown_command(help_.command, root_));
}

Command CommandLine::parse(int argc, const char* const* argv) {
  try {
    root_.parse(argc, argv);
    return chosen();
  } catch (const CLI::CallForHelp&) {
    const std::string wrong = wrong_beside_help(root_, {argv, static_cast<std::size_t>(argc)});
    return wrong.empty() ? NoCommand{root_.help(), kDone} : usage_error(root_, wrong);
  } catch (const CLI::CallForVersion& version) {
    return NoCommand{std::string(version.what()) + '\n', kDone};
  } catch (const CLI::ParseError& error) {
    return usage_error(root_, error.what());
  }
}

}  // namespace

Command parse_arguments(int argc, const char* const* argv) {
  return CommandLine().parse(argc, argv);
}

}  // namespace sfumato::cli
