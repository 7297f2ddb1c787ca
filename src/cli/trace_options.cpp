#include "cli/trace_options.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "cli/paths.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato::cli {
namespace {

constexpr const char* kTraceFooter =
    "Examples:\n"
    "  sfumato trace photo.jpg -o drawing.svg\n"
    "  sfumato trace photo.jpg -o drawing.svgz --points 5000\n"
    "  sfumato trace painting.png -o painting.svg --psnr 32 --smooth 2\n"
    "  sfumato trace *.jpg --out-dir drawings --detail 0.3\n"
    "  sfumato trace photo.jpg -o recoloured.svg --colors-only drawing.svg";

constexpr const char* kGroup = "Drawing";

constexpr std::uint64_t kLeastSide = 16;

template <class Value>
using Words = std::vector<std::pair<const char*, Value>>;

/// An option whose values are words, each of which sets `target`.
template <class Value>
CLI::Option* add_words(CLI::App& app, const char* name, const Words<Value>& words,
                       const std::string& help, Value& target) {
  std::vector<std::string> names;
  for (const auto& [word, value] : words) names.emplace_back(word);
  return add_value(app, name, one_of(names), help, [words, &target](const std::string& text) {
    for (const auto& [word, value] : words) {
      if (text != word) continue;
      target = value;
      return true;
    }
    return false;
  });
}

/// Sets `target` to a number in [lowest, highest].
template <class Target>
auto number_into(Target& target, double lowest, double highest) {
  return [&target, lowest, highest](const std::string& text) {
    const std::optional<double> value = options::parse_number(text);
    if (!value || *value < lowest || *value > highest) return false;
    target = *value;
    return true;
  };
}

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

/// What says how curves are made, and has no place with --colors-only.
constexpr const char* kOfCurves[] = {"--points",     "--detail",   "--max-curves",
                                     "--psnr",       "--smooth",   "--stops",
                                     "--edges-only", "--no-alpha", "--texture"};

/// The options of kOfCurves.
void add_amounts(CLI::App& app, TraceOptions& options, TraceChoices& choices) {
  const CLI::Option* points = add_value(
      app, "--points", {"a whole number from 1 to " + std::to_string(limits::kControlPoints), "N"},
      "Control points at most [2,000 for 640 × 480 pixels]",
      whole_into(options.points, 1, limits::kControlPoints));
  add_value(app, "--detail", {"a number from 0 to 1", "NUMBER"},
            "Instead: 0 for 250 control points, 1 for 16,000", number_into(choices.detail, 0, 1))
      ->excludes(app.get_option(points->get_name()));
  add_value(app, "--max-curves",
            {"a whole number from 1 to " + std::to_string(limits::kCurves), "N"},
            "Curves at most [as many as there are points for]",
            whole_into(options.max_curves, 1, limits::kCurves));
  add_value(app, "--psnr", {"decibels above 0", "DB"},
            "End as soon as the drawing is as near as this", [&options](const std::string& text) {
              return into(options.psnr_db, options::parse_positive)(text);
            });
  add_value(app, "--smooth", {"a number of pixels from 0 to 32", "PIXELS"},
            "What is finer is texture, which no curve follows [0]",
            number_into(options.smooth_px, 0, TraceOptions::kMostSmooth));
  add_words<TraceStops>(
      app, "--stops",
      {{"few", TraceStops::few}, {"normal", TraceStops::normal}, {"many", TraceStops::many}},
      "How many colours are kept along curves [normal]", options.stops);
  app.add_flag("--edges-only", options.edges_only, "A draft: only edges of the picture");
  app.add_flag_callback(
      "--no-alpha", [&options] { options.has_opacity = false; },
      "Transparent pictures as on white; else they become\ndrawings with opacity");
  app.add_flag(
      "--texture", options.has_texture,
      "What the curves miss becomes a texture, which is as\nlarge as a PNG of the picture");
}

void add_looks(CLI::App& app, TraceOptions& options) {
  add_words<TraceBlur>(
      app, "--blur",
      {{"on", TraceBlur::fitted}, {"off", TraceBlur::sharp}, {"fixed", TraceBlur::estimated}},
      "Blur of curves: fitted together with the colours, none,\nor from the picture alone [on]",
      options.blur);
  add_value(app, "--max-side",
            {"a whole number of pixels from " + std::to_string(kLeastSide) + " to " +
                 std::to_string(limits::kImageSide),
             "PIXELS"},
            "A larger picture is looked at in this size [1024]",
            whole_into(options.max_side, kLeastSide, limits::kImageSide));
  add_value(app, "--seed", {"a whole number", "N"},
            "Of the choice of pixels that colours are fitted to [0]",
            [&options](const std::string& text) {
              const auto seed = options::parse_whole(text, 0, UINT64_MAX);
              options.seed = seed.value_or(options.seed);
              return seed.has_value();
            });
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

}  // namespace

CLI::App* add_trace(CLI::App& root, TraceArguments& arguments, TraceChoices& choices) {
  CLI::App* app = root.add_subcommand("trace", "Make a drawing of a photo or a painting");
  app->footer(kTraceFooter);
  add_files(*app, arguments, choices);
  const std::size_t file_options = app->get_options().size();
  add_amounts(*app, arguments.options, choices);
  add_looks(*app, arguments.options);
  const std::vector<CLI::Option*> options = app->get_options({});
  for (std::size_t i = file_options; i < options.size(); ++i) options[i]->group(kGroup);
  add_running_options(*app, arguments);
  add_resources(*app, arguments.resources);
  app->get_option("--max-time")
      ->description("Begin no further round after this time, and give up a\nminute later [60]");
  return app;
}

void settle(const CLI::App& app, TraceArguments& arguments, const TraceChoices& choices) {
  std::vector<InputFile> drawings;
  if (!arguments.input.empty()) {
    for (const char* name : kOfCurves) {
      expect(app.count(name) == 0, name, "has no place with --colors-only, which makes no curves");
    }
    drawings.push_back({arguments.input, "the drawing of --colors-only"});
    const bool is_read_twice =
        arguments.input == "-" &&
        std::count(choices.inputs.begin(), choices.inputs.end(), arguments.input) > 0;
    expect(!is_read_twice, "--colors-only", "stdin can be read only once");
  }
  settle_jobs(choices, "svg", kTraceWords, drawings, arguments, arguments.outputs);
  if (choices.detail) arguments.options.points = options::points_of_detail(*choices.detail);
  // How long there is for further rounds; deadline_of() is for what must end.
  arguments.options.max_seconds = arguments.resources.seconds.value_or(0);
}

}  // namespace sfumato::cli
