#include "cli/commands/document_commands.hpp"

namespace sfumato::cli {
namespace {

constexpr const char* kInfoFooter =
    "Examples:\n"
    "  sfumato info lady_bug.xml\n"
    "  sfumato info --json lady_bug.xml";

constexpr const char* kConvertFooter =
    "Examples:\n"
    "  sfumato convert lady_bug.xml -o lady_bug.svg\n"
    "  sfumato convert by_hand.svg -o normalised.svg\n"
    "  sfumato convert - -o - <lady_bug.xml >lady_bug.svg";

constexpr const char* kLintFooter =
    "Examples:\n"
    "  sfumato lint lady_bug.svg\n"
    "  sfumato lint --strict --quiet *.svg";

}  // namespace

CLI::App* add_info(CLI::App& root, InfoArguments& arguments) {
  CLI::App* app = root.add_subcommand("info", "Print what a drawing contains");
  app->footer(kInfoFooter);
  add_document(*app, arguments);
  app->add_flag("--json", arguments.json, "Print one JSON object");
  app->add_flag("--quiet", arguments.quiet, "Print no warnings");
  add_resources(*app, arguments.resources);
  return app;
}

CLI::App* add_convert(CLI::App& root, ConvertArguments& arguments) {
  CLI::App* app = root.add_subcommand("convert", "Convert a drawing to SVG");
  app->footer(kConvertFooter);
  add_document(*app, arguments);
  add_output(*app, arguments.output, {.only = OutputKind::svg, .takes_packed = true}, "OUT.svg",
             "Write this SVG; .svgz: packed by gzip; '-': stdout")
      ->required();
  app->add_flag("--quiet", arguments.quiet, "Print no warnings");
  add_resources(*app, arguments.resources);
  return app;
}

CLI::App* add_lint(CLI::App& root, LintArguments& arguments) {
  CLI::App* app = root.add_subcommand("lint", "Find likely mistakes in drawings");
  app->footer(kLintFooter);
  app->add_option("IN", arguments.inputs, "One or more drawings (SVG or Orzan XML); '-': stdin")
      ->required()
      ->type_name("");
  add_allowed_folders(*app, arguments);
  app->add_flag("--strict", arguments.strict, "Exit with 1 if there is a hint");
  app->add_flag("--verbose", arguments.verbose,
                "Print notes too, such as which side of a loop is inside");
  app->add_flag("--json", arguments.json, "Print one JSON object for each drawing");
  app->add_flag("--quiet", arguments.quiet, "Print no warnings of the reader");
  add_resources(*app, arguments.resources);
  return app;
}

}  // namespace sfumato::cli
