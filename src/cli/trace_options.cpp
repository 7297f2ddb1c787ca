#include "cli/trace_options.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "cli/paths.hpp"
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
    "  sfumato trace photo.jpg -o mended.svg --colors-only drawing.svg --only 0:4,0:7";

void add_files(CLI::App& app, TraceArguments& arguments, TraceChoices& choices) {
  app.add_option("IN", choices.inputs,
                 "A photo or a painting: PNG, JPEG or WebP; '-': from\nstdin; several with "
                 "--out-dir")
      ->required()
      ->type_name("");
  add_output(app, choices.output, {.only = OutputKind::svg, .takes_packed = true}, "OUT.svg",
             "The drawing, packed by gzip as .svgz; '-': to stdout");
  app.add_option("--out-dir", choices.output_folder,
                 "Instead: every drawing into this folder, named as its\npicture; made where it "
                 "is not there")
      ->type_name("DIR")
      ->excludes("--output");
  app.add_option("--colors-only", arguments.input,
                 "Make no curves: give those of this drawing the colours\nof the picture; '-': "
                 "from stdin")
      ->type_name("DRAWING");
  add_allowed_folders(app, arguments);
}

void add_running_options(CLI::App& app, TraceArguments& arguments) {
  const char* group = heading(options::Group::running);
  add_value(app, "--threads", {"a whole number from 1 to " + std::to_string(limits::kThreads), "N"},
            "Threads; the drawing is the same for any number [all cores]",
            whole_into(arguments.threads, 1, limits::kThreads))
      ->group(group);
  app.add_option("--stats", arguments.stats, "Sizes, times and nearness as JSON; '-': to stdout")
      ->type_name("FILE.json")
      ->group(group);
  app.add_flag("--quiet", arguments.quiet, "No warnings, no progress bar, no last line")
      ->group(group);
}

/// What says how curves are made has no place with --colors-only.
void expect_none_of_curves(const CLI::App& app) {
  for (const options::Option<options::TraceSettings>& option : options::trace_options()) {
    if ((option.info.calls & options::kFitColors) != 0) continue;
    const std::string name = std::string("--") + option.info.key;
    expect(app.count(name) == 0, name.c_str(),
           "has no place with --colors-only, which makes no curves");
  }
}

/// What is fitted of the drawing of --colors-only.
ColorFit settled_fit(const options::TraceSettings& settings) {
  ColorFit fit = options::color_fit_of(settings);
  const bool is_any_fitted = !fit.keeps_colors || fit.blur == TraceBlur::fitted;
  expect(is_any_fitted, "--keep-colors", "expected with --blur on; else nothing is fitted");
  if (!settings.only) return fit;
  expect(options::parse_curves(*settings.only, fit.only), "--only",
         '"' + *settings.only + "\" given, expected " + options::kCurveList);
  return fit;
}

}  // namespace

CLI::App* add_trace(CLI::App& root, TraceArguments& arguments, TraceChoices& choices) {
  CLI::App* app = root.add_subcommand("trace", "Make a drawing of a photo or a painting");
  app->footer(kTraceFooter);
  add_files(*app, arguments, choices);
  for (const options::Option<options::TraceSettings>& option : options::trace_options()) {
    CLI::Option* const added = add_option(*app, option, choices.settings);
    if ((option.info.calls & options::kTrace) == 0) added->needs(app->get_option("--colors-only"));
  }
  add_running_options(*app, arguments);
  add_resources(*app, arguments.resources);
  app->get_option("--max-time")
      ->description("Begin no further round after this time, and give up a\nminute later [60]");
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
    expect(!is_read_twice, "--colors-only", "stdin can be read only once");
  }
  settle_jobs(choices, "svg", kTraceWords, drawings, arguments, arguments.outputs);
  const options::TraceSettings& settings = choices.settings;
  arguments.options = settings.trace;
  arguments.fit = settled_fit(settings);
  if (settings.detail) arguments.options.points = options::points_of_detail(*settings.detail);
  // How long there is for further rounds; deadline_of() is for what must end.
  arguments.options.max_seconds = arguments.resources.seconds.value_or(0);
}

}  // namespace sfumato::cli
