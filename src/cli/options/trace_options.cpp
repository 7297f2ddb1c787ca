#include "cli/options/trace_options.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "cli/files/paths.hpp"
#include "options/curve_list.hpp"
#include "options/tables.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato::cli {
namespace {

constexpr const char* kTraceExamples[] = {
    "sfumato trace photo.jpg -o drawing.svg",
    "sfumato trace photo.jpg -o drawing.svgz --points 5000",
    "sfumato trace painting.png -o painting.svg --psnr 32 --smooth 2",
    "sfumato trace *.jpg --out-dir drawings --detail 0.3",
    "sfumato trace photo.jpg -o recoloured.svg --colors-only drawing.svg",
    "sfumato trace photo.jpg -o fixed.svg --colors-only drawing.svg --only 0:4,0:7"};

constexpr const char* kTraceNotes =
    "Curves follow the edges of the picture; their colours and blur are fitted so that the\n"
    "drawing looks like the picture. The picture is turned upright, and its colours are\n"
    "converted to sRGB. The last line on standard error summarises the drawing.";

constexpr const char* kTraceUsages[] = {"IN -o OUT.svg [OPTIONS]", "IN... --out-dir DIR [OPTIONS]"};

void add_files(CommandSyntax& command, TraceArguments& arguments, TraceChoices& choices) {
  command
      .add_file("IN", choices.inputs, "",
                "A photo or painting (PNG, JPEG or WebP); '-': stdin;\nseveral with --out-dir",
                form_of_input(kPhotos))
      ->required();
  constexpr OutputNames kNames{.only = OutputKind::svg, .takes_packed = true};
  add_output(command, choices.output, kNames, "OUT.svg",
             "Write the drawing; .svgz: packed by gzip; '-': stdout");
  add_output_folder(command, choices.output_folder, kTraceWords);
  command.add_file("--colors-only", arguments.input, "DRAWING",
                   "Recolour this drawing instead of making curves; '-':\nstdin",
                   form_of_input(kDrawings));
  add_allowed_folders(command, arguments);
}

void add_running_options(CommandSyntax& command, TraceArguments& arguments) {
  add_option(command,
             {.key = "threads",
              .kind = options::ValueKind::whole,
              .wholes = {1, limits::kThreads},
              .value_name = "N",
              .help = "Use N threads; the drawing does not depend on N [all cores]",
              .group = options::Group::running},
             [&arguments](const options::Value& value) {
               arguments.threads = static_cast<int>(value.whole);
             });
  add_stats(command, arguments.stats, "Write sizes, times and PSNR as JSON; '-': stdout");
  command.add_flag("--quiet", arguments.quiet, "Print no warnings, no progress bar and no summary")
      ->group(heading(options::Group::running));
}

/// Refuses the options about making curves, which cannot be combined with --colors-only.
void expect_none_of_curves(const CLI::App& app) {
  for (const options::Option<options::TraceSettings>& option : options::trace_options()) {
    if ((option.info.calls & options::kFitColors) != 0) continue;
    const std::string name = std::string("--") + option.info.key;
    expect(app.count(name) == 0, name.c_str(),
           "cannot be combined with --colors-only, which makes no curves");
  }
}

/// Returns what to fit in the drawing of --colors-only.
ColorFit settled_fit(const options::TraceSettings& settings) {
  ColorFit fit = options::color_fit_of(settings);
  const bool is_any_fitted = !fit.keeps_colors || fit.blur == TraceBlur::fitted;
  expect(is_any_fitted, "--keep-colors", "works with --blur on only; otherwise nothing is fitted");
  if (!settings.only) return fit;
  expect(options::parse_curves(*settings.only, fit.only), "--only",
         "invalid value \"" + *settings.only + "\"; use " + options::kCurveList);
  return fit;
}

}  // namespace

void add_trace(CommandSyntax& root, TraceArguments& arguments, TraceChoices& choices) {
  CommandSyntax& command = root.add_command({.name = "trace",
                                             .summary = "Trace a photo or painting into a drawing",
                                             .usages = kTraceUsages,
                                             .examples = kTraceExamples,
                                             .notes = kTraceNotes});
  add_files(command, arguments, choices);
  for (const options::Option<options::TraceSettings>& option : options::trace_options()) {
    CLI::Option* const added = add_option(command, option, choices.settings);
    if ((option.info.calls & options::kTrace) == 0) {
      added->needs(command.get_option("--colors-only"));
    }
  }
  add_running_options(command, arguments);
  add_resources(command, arguments.resources);
  command.get_option("--max-time")
      ->description(
          "Begin no further round after this time, and stop a minute\nlater at the latest [60]");
}

void settle(const CLI::App& app, TraceArguments& arguments, const TraceChoices& choices) {
  std::vector<InputFile> drawings;
  if (!arguments.input.empty()) {
    expect_none_of_curves(app);
    drawings.push_back({arguments.input, "the drawing of --colors-only"});
    const bool is_read_twice =
        arguments.input == "-" &&
        std::count(choices.inputs.begin(), choices.inputs.end(), arguments.input) > 0;
    expect(!is_read_twice, "--colors-only",
           "stdin can be read only once; use a file name for the drawing or the picture");
  }
  settle_jobs(choices, "svg", kTraceWords, drawings, arguments, arguments.outputs);
  const options::TraceSettings& settings = choices.settings;
  arguments.options = settings.trace;
  arguments.fit = settled_fit(settings);
  if (settings.detail) arguments.options.points = options::points_of_detail(*settings.detail);
  // The time for further rounds. deadline_of() is the time after which the command stops.
  arguments.options.max_seconds = arguments.resources.seconds.value_or(0);
}

}  // namespace sfumato::cli
