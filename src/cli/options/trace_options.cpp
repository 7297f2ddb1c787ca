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

constexpr const char* kTraceFooter =
    "Examples:\n"
    "  sfumato trace photo.jpg -o drawing.svg\n"
    "  sfumato trace photo.jpg -o drawing.svgz --points 5000\n"
    "  sfumato trace painting.png -o painting.svg --psnr 32 --smooth 2\n"
    "  sfumato trace *.jpg --out-dir drawings --detail 0.3\n"
    "  sfumato trace photo.jpg -o recoloured.svg --colors-only drawing.svg\n"
    "  sfumato trace photo.jpg -o fixed.svg --colors-only drawing.svg --only 0:4,0:7";

void add_files(CLI::App& app, TraceArguments& arguments, TraceChoices& choices) {
  app.add_option("IN", choices.inputs,
                 "A photo or painting (PNG, JPEG or WebP); '-': stdin;\nseveral with "
                 "--out-dir")
      ->required()
      ->type_name("");
  add_output(app, choices.output, {.only = OutputKind::svg, .takes_packed = true}, "OUT.svg",
             "Write the drawing; .svgz: packed by gzip; '-': stdout");
  app.add_option(
         "--out-dir", choices.output_folder,
         "Write each drawing into this folder instead, named after\nits picture; the folder "
         "is created if needed")
      ->type_name("DIR")
      ->excludes("--output");
  app.add_option(
         "--colors-only", arguments.input,
         "Make no new curves: give the curves of this drawing the\ncolours of the picture; '-': "
         "stdin")
      ->type_name("DRAWING");
  add_allowed_folders(app, arguments);
}

void add_running_options(CLI::App& app, TraceArguments& arguments) {
  const char* group = heading(options::Group::running);
  add_value(app, "--threads", {"a whole number from 1 to " + std::to_string(limits::kThreads), "N"},
            "Use N threads; the drawing does not depend on N [all cores]",
            whole_into(arguments.threads, 1, limits::kThreads))
      ->group(group);
  app.add_option("--stats", arguments.stats, "Write sizes, times and PSNR as JSON; '-': stdout")
      ->type_name("FILE.json")
      ->group(group);
  app.add_flag("--quiet", arguments.quiet, "Print no warnings, no progress bar and no summary")
      ->group(group);
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

CLI::App* add_trace(CLI::App& root, TraceArguments& arguments, TraceChoices& choices) {
  CLI::App* app = root.add_subcommand("trace", "Trace a photo or painting into a drawing");
  app->footer(kTraceFooter);
  add_files(*app, arguments, choices);
  for (const options::Option<options::TraceSettings>& option : options::trace_options()) {
    CLI::Option* const added = add_option(*app, option, choices.settings);
    if ((option.info.calls & options::kTrace) == 0) added->needs(app->get_option("--colors-only"));
  }
  add_running_options(*app, arguments);
  add_resources(*app, arguments.resources);
  app->get_option("--max-time")
      ->description(
          "Begin no further round after this time, and stop a minute\nlater at the latest [60]");
  return app;
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
