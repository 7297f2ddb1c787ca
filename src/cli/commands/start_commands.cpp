#include "cli/commands/start_commands.hpp"

#include <algorithm>

#include "base/text/ascii.hpp"
#include "cli/commands/templates.hpp"
#include "cli/files/paths.hpp"

namespace sfumato::cli {
namespace {

constexpr const char* kInitFooter =
    "Examples:\n"
    "  sfumato init drawing.svg\n"
    "  sfumato init sphere.svg --template sphere\n"
    "  sfumato init drawing.svg --from icon.svg\n"
    "  sfumato init - | sfumato render - -o picture.png";

constexpr const char* kWatchFooter =
    "Examples:\n"
    "  sfumato watch drawing.svg\n"
    "  sfumato watch drawing.svg --scale 2 -o drawing.png --port 8080\n"
    "\n"
    "Prints the address of the page. Only this machine can open it. Press Ctrl-C to stop.";

constexpr const char* kEditFooter =
    "Examples:\n"
    "  sfumato edit drawing.svg\n"
    "  sfumato edit drawing.svg --no-browser --port 8080\n"
    "\n"
    "Prints the address of the page. The address contains a secret: everyone who has it can read\n"
    "and write the drawing, and nothing else. Save on the page writes the file. Press Ctrl-C to "
    "stop.";

std::vector<std::string> template_names() {
  std::vector<std::string> names;
  for (const Template& known : templates()) names.emplace_back(known.name);
  return names;
}

bool is_template(const std::string& text) {
  return std::ranges::find(templates(), text, &Template::name) != templates().end();
}

/// Adds --port of a page.
void add_port(CLI::App& app, int& port) {
  add_value(app, "--port", {"a whole number from 0 to 65535", "N"},
            "Serve the page on this port of 127.0.0.1; 0: any free port [0]",
            whole_into(port, 0, 65535));
}

}  // namespace

CLI::App* add_init(CLI::App& root, InitArguments& arguments) {
  CLI::App* app = root.add_subcommand("init", "Create a drawing to start from");
  app->footer(kInitFooter);
  app->add_option("OUT.svg", arguments.output, "The new drawing; '-': stdout")
      ->required()
      ->type_name("");
  add_value(*app, "--template", one_of(template_names()), "Choose the template [shape]",
            [&arguments](const std::string& text) {
              arguments.template_name = text;
              return is_template(text);
            });
  app->add_option(
         "--from", arguments.input,
         "Make curves from the fills, strokes and gradients of an\nordinary SVG instead; '-': "
         "stdin")
      ->type_name("IN.svg")
      ->excludes("--template");
  app->add_flag("--force", arguments.force, "Replace OUT.svg if it exists");
  add_allowed_folders(*app, arguments);
  app->add_flag("--quiet", arguments.quiet, "Print no warnings");
  add_resources(*app, arguments.resources);
  return app;
}

void settle(InitArguments& arguments) {
  arguments.outputs = {arguments.output};
  const std::string complaint = complaint_about_output(arguments.output, {.only = OutputKind::svg});
  if (!complaint.empty()) throw CLI::ValidationError("OUT.svg", complaint);
}

CLI::App* add_watch(CLI::App& root, WatchArguments& arguments, RenderChoices& choices) {
  CLI::App* app =
      root.add_subcommand("watch", "Show a drawing in the browser and update it on each save");
  app->footer(kWatchFooter);
  app->add_option("IN", arguments.input, "A drawing (SVG or Orzan XML)")->required()->type_name("");
  add_output(*app, choices.output, {.takes_dash = false}, "OUT",
             "Also write the picture at each change");
  add_port(*app, arguments.port);
  add_allowed_folders(*app, arguments);
  add_place_options(*app, arguments.page.settings);
  add_value(*app, "--threads",
            {"a whole number from 1 to " + std::to_string(limits::kThreads), "N"},
            "Use N threads [all cores]",
            whole_into(arguments.page.settings.threads, 1, limits::kThreads));
  app->add_flag("--quiet", arguments.quiet, "Print no warnings, only the address and errors");
  add_resources(*app, arguments.resources);
  return app;
}

void settle(WatchArguments& arguments, const RenderChoices& choices) {
  if (arguments.input == "-") {
    throw CLI::ValidationError("IN", "stdin cannot be watched; use a file name");
  }
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

CLI::App* add_edit(CLI::App& root, EditArguments& arguments) {
  CLI::App* app = root.add_subcommand("edit", "Edit a drawing in the browser");
  app->footer(kEditFooter);
  app->add_option("DRAWING", arguments.input,
                  "An SVG file (.svg, .svgz); created if it does not exist")
      ->required()
      ->type_name("");
  app->add_flag("!--no-browser", arguments.opens_browser, "Print the address but open no browser");
  add_port(*app, arguments.port);
  add_allowed_folders(*app, arguments);
  return app;
}

void settle(const EditArguments& arguments) {
  const std::string name = ascii_lower(arguments.input);
  if (name.ends_with(".svg") || name.ends_with(".svgz")) return;
  throw CLI::ValidationError("DRAWING", "cannot edit \"" + arguments.input +
                                            "\"; use a file name that ends in .svg or .svgz "
                                            "(`sfumato convert` makes an SVG of Orzan XML)");
}

}  // namespace sfumato::cli
