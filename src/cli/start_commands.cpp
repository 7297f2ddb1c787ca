#include "cli/start_commands.hpp"

#include <algorithm>

#include "base/ascii.hpp"
#include "cli/paths.hpp"
#include "cli/templates.hpp"

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
    "The page's address is printed; only this machine can open it. Ctrl-C ends.";

constexpr const char* kEditFooter =
    "Examples:\n"
    "  sfumato edit drawing.svg\n"
    "  sfumato edit drawing.svg --no-browser --port 8080\n"
    "\n"
    "The page's address is printed. It holds a secret: who has it reads and writes the drawing, "
    "and\n"
    "nothing else. Saving on the page writes the file; Ctrl-C ends.";

std::vector<std::string> template_names() {
  std::vector<std::string> names;
  for (const Template& known : templates()) names.emplace_back(known.name);
  return names;
}

bool is_template(const std::string& text) {
  return std::ranges::find(templates(), text, &Template::name) != templates().end();
}

/// --port of a page.
void add_port(CLI::App& app, int& port) {
  add_value(app, "--port", {"a whole number from 0 to 65535", "N"},
            "Of the page on 127.0.0.1; 0: any that is free [0]", whole_into(port, 0, 65535));
}

}  // namespace

CLI::App* add_init(CLI::App& root, InitArguments& arguments) {
  CLI::App* app = root.add_subcommand("init", "Write a drawing to begin with");
  app->footer(kInitFooter);
  app->add_option("OUT.svg", arguments.output, "The new drawing; '-': to stdout")
      ->required()
      ->type_name("");
  add_value(*app, "--template", one_of(template_names()), "What to begin with [shape]",
            [&arguments](const std::string& text) {
              arguments.template_name = text;
              return is_template(text);
            });
  app->add_option("--from", arguments.input,
                  "Instead: curves from the fills, strokes and gradients of\nan ordinary SVG; '-': "
                  "from stdin")
      ->type_name("IN.svg")
      ->excludes("--template");
  app->add_flag("--force", arguments.force, "Replace OUT.svg where there is one");
  add_allowed_folders(*app, arguments);
  app->add_flag("--quiet", arguments.quiet, "No warnings");
  add_resources(*app, arguments.resources);
  return app;
}

void settle(InitArguments& arguments) {
  arguments.outputs = {arguments.output};
  const std::string complaint = complaint_about_output(arguments.output, {.only = OutputKind::svg});
  if (!complaint.empty()) throw CLI::ValidationError("OUT.svg", complaint);
}

CLI::App* add_watch(CLI::App& root, WatchArguments& arguments, RenderChoices& choices) {
  CLI::App* app = root.add_subcommand("watch", "Show a drawing, anew whenever it changes");
  app->footer(kWatchFooter);
  app->add_option("IN", arguments.input, "Diffusion curves (SVG or Orzan XML)")
      ->required()
      ->type_name("");
  add_output(*app, choices.output, {.takes_dash = false}, "OUT",
             "Also write the picture, at each change");
  add_port(*app, arguments.port);
  add_allowed_folders(*app, arguments);
  add_place_options(*app, arguments.page.settings);
  add_value(
      *app, "--threads", {"a whole number from 1 to " + std::to_string(limits::kThreads), "N"},
      "Threads [all cores]", whole_into(arguments.page.settings.threads, 1, limits::kThreads));
  app->add_flag("--quiet", arguments.quiet, "No warnings, only the address and errors");
  add_resources(*app, arguments.resources);
  return app;
}

void settle(WatchArguments& arguments, const RenderChoices& choices) {
  if (arguments.input == "-") {
    throw CLI::ValidationError("IN", "stdin cannot be watched, expected a file name");
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
  CLI::App* app = root.add_subcommand("edit", "Draw in the browser, and save to the file");
  app->footer(kEditFooter);
  app->add_option("DRAWING", arguments.input, "An SVG (.svg, .svgz); created where it is not there")
      ->required()
      ->type_name("");
  app->add_flag("!--no-browser", arguments.opens_browser, "Print the address, open no browser");
  add_port(*app, arguments.port);
  add_allowed_folders(*app, arguments);
  return app;
}

void settle(const EditArguments& arguments) {
  const std::string name = ascii_lower(arguments.input);
  if (name.ends_with(".svg") || name.ends_with(".svgz")) return;
  throw CLI::ValidationError("DRAWING", "\"" + arguments.input +
                                            "\" given, expected a file name that ends in .svg or "
                                            ".svgz; `sfumato convert` makes an SVG of Orzan's XML");
}

}  // namespace sfumato::cli
