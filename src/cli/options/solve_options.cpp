#include "cli/options/render_options.hpp"
#include "options/settle.hpp"
#include "options/tables.hpp"

namespace sfumato::cli {
namespace {

constexpr const char* kSolveExamples[] = {
    "sfumato solve lady_bug.xml -o lady_bug.sfp",
    "sfumato solve lady_bug.xml -o fine.sfp --scale 8 --max-error 0.25",
    "sfumato solve *.svg --out-dir solved", "sfumato render lady_bug.sfp -o lady_bug.pdf"};

/// The part of a group's heading that holds for this command.
constexpr const char* kMeshHeading = "Mesh";

using RenderOption = options::Option<options::Settings>;

/// Returns whether the option changes the solved picture but not the files made from it.
bool is_of_drawings(const options::OptionInfo& option) {
  return (option.calls & options::kSolve) != 0 && (option.calls & options::kExport) == 0;
}

constexpr const char* kSolveNotes =
    "`sfumato render` draws and exports solved pictures later, as often as needed and without\n"
    "the drawing. The results have the same bytes.";

constexpr const char* kSolveUsages[] = {"IN -o OUT.sfp [OPTIONS]", "IN... --out-dir DIR [OPTIONS]"};

void add_files(CommandSyntax& command, SolveArguments& arguments, JobChoices& choices) {
  command
      .add_file("IN", choices.inputs, "",
                "A drawing (SVG or Orzan XML); '-': stdin; several with\n--out-dir",
                form_of_input(kDrawings))
      ->required();
  constexpr OutputNames kNames{.is_solved = true};
  add_output(command, choices.output, kNames, "OUT.sfp", "Write the solved picture; '-': stdout");
  add_output_folder(command, choices.output_folder, kSolveWords);
  add_allowed_folders(command, arguments);
}

/// Adds the solver's options, with the defaults of an 8-bit image.
void add_solver_options(CommandSyntax& command, options::Settings& settings) {
  for (const RenderOption& option : options::render_options()) {
    const bool is_of_films = option.info.group == options::Group::running;
    if ((option.info.calls & options::kSolve) == 0 || is_of_films) continue;
    CLI::Option* const added = add_option(command, option, settings);
    const bool is_mesh =
        option.info.group == options::Group::mesh || option.info.group == options::Group::vector;
    if (is_mesh) added->group(kMeshHeading);
  }
  CLI::Option* const method = command.get_option("--method");
  method->type_name("exact|rays")
      ->description(
          "Choose how to solve: exact (closed form on a mesh) or rays\n(random rays on a mesh) "
          "[exact]");
  command.describe(method, {.kind = "choice", .choices = {"exact", "rays"}});
  command.get_option("--max-error")
      ->description(
          "Refine the mesh where it is wrong by more than E code\nvalues of 255; off: do not "
          "refine [1]");
  command.get_option("--detail")
      ->description("Make the mesh fine enough to enlarge the picture this\nmany times [1]");
}

}  // namespace

void add_solve(CommandSyntax& root, SolveArguments& arguments, JobChoices& choices) {
  CommandSyntax& command = root.add_command({.name = "solve",
                                             .summary = "Solve drawings, to render them later",
                                             .usages = kSolveUsages,
                                             .examples = kSolveExamples,
                                             .notes = kSolveNotes});
  add_files(command, arguments, choices);
  add_solver_options(command, arguments.settings);
  add_running_options(command, arguments.settings, arguments, arguments);
  add_resources(command, arguments.resources);
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
  expect_none(options::find_solve_conflict(arguments.settings));
}

}  // namespace sfumato::cli
