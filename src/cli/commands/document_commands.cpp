#include "cli/commands/document_commands.hpp"

namespace sfumato::cli {
namespace {

constexpr const char* kInfoExamples[] = {"sfumato info lady_bug.xml",
                                         "sfumato info --json lady_bug.xml"};

constexpr const char* kConvertExamples[] = {"sfumato convert lady_bug.xml -o lady_bug.svg",
                                            "sfumato convert by_hand.svg -o normalised.svg",
                                            "sfumato convert - -o - <lady_bug.xml >lady_bug.svg"};

constexpr const char* kLintExamples[] = {"sfumato lint lady_bug.svg",
                                         "sfumato lint --strict --quiet *.svg"};

constexpr const char* kConvertNotes =
    "The SVG is exact and canonical: it renders to the same bytes, and converting it again gives\n"
    "the same file.";

constexpr const char* kLintNotes =
    "Prints one line for each hint: curves that cross or miss each other, sides without a\n"
    "colour, seams and more. Several drawings are checked one after another; the exit code is\n"
    "that of the first drawing that failed.";

constexpr const char* kInfoUsages[] = {"IN [OPTIONS]"};
constexpr const char* kConvertUsages[] = {"IN -o OUT.svg [OPTIONS]"};
constexpr const char* kLintUsages[] = {"IN... [OPTIONS]"};

}  // namespace

void add_info(CommandSyntax& root, InfoArguments& arguments) {
  CommandSyntax& command = root.add_command({.name = "info",
                                             .summary = "Print what a drawing contains",
                                             .usages = kInfoUsages,
                                             .examples = kInfoExamples});
  add_document(command, arguments, true);
  command.add_flag("--json", arguments.json, "Print one JSON object");
  command.add_flag("--quiet", arguments.quiet, "Print no warnings");
  add_resources(command, arguments.resources);
}

void add_convert(CommandSyntax& root, ConvertArguments& arguments) {
  CommandSyntax& command = root.add_command({.name = "convert",
                                             .summary = "Convert a drawing to SVG",
                                             .usages = kConvertUsages,
                                             .examples = kConvertExamples,
                                             .notes = kConvertNotes});
  add_document(command, arguments, false);
  add_output(command, arguments.output, {.only = OutputKind::svg, .takes_packed = true}, "OUT.svg",
             "Write this SVG; .svgz: packed by gzip; '-': stdout")
      ->required();
  command.add_flag("--quiet", arguments.quiet, "Print no warnings");
  add_resources(command, arguments.resources);
}

void add_lint(CommandSyntax& root, LintArguments& arguments) {
  CommandSyntax& command = root.add_command({.name = "lint",
                                             .summary = "Find likely mistakes in drawings",
                                             .usages = kLintUsages,
                                             .examples = kLintExamples,
                                             .notes = kLintNotes});
  command
      .add_file("IN", arguments.inputs, "", "One or more drawings (SVG or Orzan XML); '-': stdin",
                form_of_input(kDrawings))
      ->required();
  add_allowed_folders(command, arguments);
  command.add_flag("--strict", arguments.strict, "Exit with 1 if there is a hint");
  command.add_flag("--verbose", arguments.verbose,
                   "Print notes too, such as which side of a loop is inside");
  command.add_flag("--json", arguments.json, "Print one JSON object for each drawing");
  command.add_flag("--quiet", arguments.quiet, "Print no warnings of the reader");
  add_resources(command, arguments.resources);
}

}  // namespace sfumato::cli
