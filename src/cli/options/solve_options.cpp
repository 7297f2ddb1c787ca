#include "cli/options/render_options.hpp"
#include "options/settle.hpp"
#include "options/tables.hpp"

namespace sfumato::cli {
namespace {

constexpr const char* kSolveFooter =
    "Examples:\n"
    "  sfumato solve lady_bug.xml -o lady_bug.sfp\n"
    "  sfumato solve lady_bug.xml -o fine.sfp --scale 8 --max-error 0.25\n"
    "  sfumato solve *.svg --out-dir solved\n"
    "  sfumato render lady_bug.sfp -o lady_bug.pdf";

/// The part of a group's heading that holds for this command.
constexpr const char* kMeshHeading = "Mesh";

using RenderOption = options::Option<options::Settings>;

/// Returns whether the option changes the solved picture but not the files made from it.
bool is_of_drawings(const options::OptionInfo& option) {
  return (option.calls & options::kSolve) != 0 && (option.calls & options::kExport) == 0;
}

void add_files(CLI::App& app, SolveArguments& arguments, JobChoices& choices) {
  app.add_option("IN", choices.inputs,
                 "A drawing (SVG or Orzan XML); '-': stdin; several with\n--out-dir")
      ->required()
      ->type_name("");
  add_output(app, choices.output, {.is_solved = true}, "OUT.sfp",
             "Write the solved picture; '-': stdout");
  app.add_option(
         "--out-dir", choices.output_folder,
         "Write each picture into this folder instead, named after\nits drawing; the folder "
         "is created if needed")
      ->type_name("DIR")
      ->excludes("--output");
  add_allowed_folders(app, arguments);
}

/// Adds the solver's options, with the defaults of an 8-bit image.
void add_solver_options(CLI::App& app, options::Settings& settings) {
  for (const RenderOption& option : options::render_options()) {
    const bool is_of_films = option.info.group == options::Group::running;
    if ((option.info.calls & options::kSolve) == 0 || is_of_films) continue;
    CLI::Option* const added = add_option(app, option, settings);
    const bool is_mesh =
        option.info.group == options::Group::mesh || option.info.group == options::Group::vector;
    if (is_mesh) added->group(kMeshHeading);
  }
  app.get_option("--method")
      ->description(
          "Choose how to solve: exact (closed form on a mesh) or rays\n(random rays on a mesh) "
          "[exact]");
  app.get_option("--max-error")
      ->description(
          "Refine the mesh where it is wrong by more than E code\nvalues of 255; off: do not "
          "refine [1]");
  app.get_option("--detail")
      ->description("Make the mesh fine enough to enlarge the picture this\nmany times [1]");
}

}  // namespace

CLI::App* add_solve(CLI::App& root, SolveArguments& arguments, JobChoices& choices) {
  CLI::App* app = root.add_subcommand("solve", "Solve drawings, to render them later");
  app->footer(kSolveFooter);
  add_files(*app, arguments, choices);
  add_solver_options(*app, arguments.settings);
  add_running_options(*app, arguments.settings, arguments, arguments);
  add_resources(*app, arguments.resources);
  return app;
}

std::vector<std::string> given_drawing_options(const CLI::App& render) {
  std::vector<std::string> given;
  const auto note = [&](const std::string& name) {
    if (render.count(name) > 0) given.push_back(name);
  };
  for (const RenderOption& option : options::render_options()) {
    if (is_of_drawings(option.info)) note(std::string("--") + option.info.key);
  }
  note("--gather");
  note("--allow-files");
  return given;
}

void settle(SolveArguments& arguments, const JobChoices& choices) {
  settle_jobs(choices, kSolvedExtension, kSolveWords, {}, arguments, arguments.outputs);
  const options::Conflict conflict = options::find_solve_conflict(arguments.settings);
  if (conflict.key.empty()) return;
  throw CLI::ValidationError(options::spelled(conflict.key, true),
                             options::spelled(conflict.complaint, true));
}

}  // namespace sfumato::cli
