#include "cli/commands/start_commands.hpp"

#include <algorithm>

#include "base/text/ascii.hpp"
#include "cli/commands/templates.hpp"
#include "cli/files/paths.hpp"

namespace sfumato::cli {
namespace {

constexpr const char* kInitExamples[] = {
    "sfumato init drawing.svg", "sfumato init sphere.svg --template sphere",
    "sfumato init drawing.svg --from icon.svg", "sfumato init - | sfumato render - -o picture.png"};

constexpr const char* kWatchExamples[] = {
    "sfumato watch drawing.svg", "sfumato watch drawing.svg --scale 2 -o drawing.png --port 8080"};

constexpr const char* kWatchNotes =
    "Prints the address of the page, which shows the picture again whenever the drawing or one\n"
    "of its textures changes. Only this machine can open it. Press Ctrl-C to stop; an open page\n"
    "continues if the command starts again with the same port.";

constexpr const char* kEditExamples[] = {"sfumato edit drawing.svg",
                                         "sfumato edit drawing.svg --no-browser --port 8080"};

constexpr const char* kEditNotes =
    "Prints the address of the page. The address contains a secret: everyone who has it can read\n"
    "and write the drawing, and nothing else. Save on the page writes the file. Press Ctrl-C to\n"
    "stop.";

constexpr const char* kInitUsages[] = {"OUT.svg [--template NAME | --from IN.svg] [OPTIONS]"};
constexpr const char* kWatchUsages[] = {"IN [-o OUT] [OPTIONS]"};
constexpr const char* kEditUsages[] = {"DRAWING [OPTIONS]"};
constexpr std::string_view kSvgs[] = {"svg", "svgz"};

/// Adds --port of a page.
void add_port(CommandSyntax& command, int& port) {
  add_option(command,
             {.key = "port",
              .kind = options::ValueKind::whole,
              .wholes = {0, 65535},
              .value_name = "N",
              .help = "Serve the page on this port of 127.0.0.1; 0: any free port [0]"},
             [&port](const options::Value& value) { port = static_cast<int>(value.whole); });
}

}  // namespace

void add_init(CommandSyntax& root, InitArguments& arguments) {
  CommandSyntax& command = root.add_command({.name = "init",
                                             .summary = "Create a drawing to start from",
                                             .usages = kInitUsages,
                                             .examples = kInitExamples});
  command
      .add_file("OUT.svg", arguments.output, "", "The new drawing; '-': stdout",
                form_of_output(extensions_of({.only = OutputKind::svg})))
      ->required();
  add_option(command,
             {.key = "template",
              .kind = options::ValueKind::word,
              .words = kTemplates,
              .help = "Choose the template [shape]"},
             [&arguments](const options::Value& value) { arguments.template_name = value.text; });
  command
      .add_file(
          "--from", arguments.input, "IN.svg",
          "Make curves from the fills, strokes and gradients of an\nordinary SVG instead; '-': "
          "stdin",
          form_of_input(kSvgs))
      ->excludes("--template");
  command.add_flag("--force", arguments.force, "Replace OUT.svg if it exists");
  add_allowed_folders(command, arguments);
  command.add_flag("--quiet", arguments.quiet, "Print no warnings");
  add_resources(command, arguments.resources);
}

void settle(InitArguments& arguments) {
  arguments.outputs = {arguments.output};
  expect_none("OUT.svg", complaint_about_output(arguments.output, {.only = OutputKind::svg}));
}

void add_watch(CommandSyntax& root, WatchArguments& arguments, RenderChoices& choices) {
  CommandSyntax& command =
      root.add_command({.name = "watch",
                        .summary = "Show a drawing in the browser and update it on each save",
                        .usages = kWatchUsages,
                        .examples = kWatchExamples,
                        .notes = kWatchNotes});
  command
      .add_file("IN", arguments.input, "", "A drawing (SVG or Orzan XML)", form_of_input(kDrawings))
      ->required();
  constexpr OutputNames kNames{.takes_dash = false};
  add_output(command, choices.output, kNames, "OUT", "Also write the picture at each change");
  add_port(command, arguments.port);
  add_allowed_folders(command, arguments);
  add_place_options(command, arguments.page.settings);
  add_threads(command, arguments.page.settings)->description("Use N threads [all cores]");
  command.add_flag("--quiet", arguments.quiet, "Print no warnings, only the address and errors")
      ->group(heading(options::Group::running));
  add_resources(command, arguments.resources);
}

void settle(WatchArguments& arguments, const RenderChoices& choices) {
  expect(arguments.input != "-", "IN", "stdin cannot be watched; use a file name");
  if (!choices.output.empty()) arguments.outputs = {choices.output};
  RenderArguments& page = arguments.page;
  static_cast<DocumentArguments&>(page) = arguments;
  RenderChoices shown = choices;
  shown.inputs = {arguments.input};
  if (!choices.output.empty()) {
    RenderArguments file = page;
    settle(file, shown);
    arguments.file = std::move(file);
  }
  shown.output = "-";
  settle(page, shown);
}

void add_edit(CommandSyntax& root, EditArguments& arguments) {
  CommandSyntax& command = root.add_command({.name = "edit",
                                             .summary = "Edit a drawing in the browser",
                                             .usages = kEditUsages,
                                             .examples = kEditExamples,
                                             .notes = kEditNotes});
  command
      .add_file("DRAWING", arguments.input, "",
                "An SVG file (.svg, .svgz); created if it does not exist", form_of_output(kSvgs))
      ->required();
  command.add_flag_callback(
      "--no-browser", [&arguments] { arguments.opens_browser = false; },
      "Print the address but open no browser");
  add_port(command, arguments.port);
  add_allowed_folders(command, arguments);
}

void settle(const EditArguments& arguments) {
  const std::string name = ascii_lower(arguments.input);
  expect(name.ends_with(".svg") || name.ends_with(".svgz"), "DRAWING",
         "cannot edit \"" + arguments.input +
             "\"; use a file name that ends in .svg or .svgz "
             "(`sfumato convert` makes an SVG of Orzan XML)");
}

}  // namespace sfumato::cli
