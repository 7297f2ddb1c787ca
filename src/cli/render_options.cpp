#include "cli/render_options.hpp"

#include "cli/paths.hpp"
#include "options/tables.hpp"

namespace sfumato::cli {
namespace {

constexpr const char* kRenderFooter =
    "Examples:\n"
    "  sfumato render lady_bug.xml -o lady_bug.png\n"
    "  sfumato render lady_bug.xml -o big.png --width 4096 --depth 16\n"
    "  sfumato render lady_bug.xml -o eye.png --viewport 200,100,64,64 --scale 8\n"
    "  sfumato render lady_bug.xml -o noisy.png --method rays --rays 64 --max-error off\n"
    "  sfumato render lady_bug.xml -o lady_bug.html\n"
    "  sfumato render lady_bug.xml -o lady_bug.pdf --title \"Lady bug\"\n"
    "  sfumato render lady_bug.sfp -o lady_bug.webp\n"
    "  sfumato render *.svg --out-dir pictures --format webp\n"
    "  sfumato render frames/*.svg -o - --format rgb24 | ffmpeg -f rawvideo -pixel_format rgb24 "
    "\\\n"
    "      -video_size 1280x720 -framerate 24 -i - film.mp4\n"
    "  sfumato render - -o - <lady_bug.xml >lady_bug.png";

void add_files(CLI::App& app, RenderArguments& arguments, RenderChoices& choices) {
  app.add_option("IN", choices.inputs,
                 "Diffusion curves (SVG or Orzan XML) or a solved picture\n(.sfp); '-': from "
                 "stdin; several with --out-dir, or as raw frames")
      ->required()
      ->type_name("");
  add_output(app, choices.output, {.takes_frames = true}, "OUT",
             "The picture, made as its extension says; '-': to\nstdout, as --format says; raw "
             "frames of several drawings,\none behind the other");
  app.add_option("--out-dir", choices.output_folder,
                 "Instead: every picture into this folder, named as its\ndrawing; made where it "
                 "is not there")
      ->type_name("DIR")
      ->excludes("--output");
  add_value(app, "--shard", kShardText,
            "With --out-dir: every Nth drawing, from the Ith on, which\nis counted from 0; of a "
            "film: the Ith of N runs [0/1]",
            into(choices.shard, parse_shard));
  app.add_flag("--newer-only", choices.newer_only,
               "With --out-dir: no drawings whose pictures are there and\nnot older");
  add_value(app, "--format", one_of(known_formats(), "EXTENSION"),
            "What --out-dir and '-o -' write; for ffmpeg raw frames:\nrgb24, rgba, rgb48le, "
            "rgba64le [png]",
            [&choices](const std::string& text) {
              choices.extension = text;
              choices.format = kind_of_format(text);
              return choices.format.has_value();
            });
  add_allowed_folders(app, arguments);
}

/// All options of the table in a group of the help.
void add_group(CLI::App& app, options::Group group, options::Settings& settings) {
  for (const options::Option<options::Settings>& option : options::render_options()) {
    if (option.info.group == group) add_option(app, option, settings);
  }
}

/// One option of the table.
void add_option_of(CLI::App& app, std::string_view key, options::Settings& settings) {
  for (const options::Option<options::Settings>& option : options::render_options()) {
    if (option.info.key == key) add_option(app, option, settings);
  }
}

}  // namespace

void add_running_options(CLI::App& app, options::Settings& settings, JobArguments& jobs,
                         DocumentArguments& documents) {
  const char* group = heading(options::Group::running);
  add_option_of(app, "gather", settings);
  add_option_of(app, "threads", settings);
  app.add_option("--stats", jobs.stats, "Sizes and times as JSON; '-': to stdout")
      ->type_name("FILE.json")
      ->group(group);
  app.add_flag("--quiet", documents.quiet, "No warnings, no progress bar")->group(group);
}

void add_place_options(CLI::App& app, options::Settings& settings) {
  add_group(app, options::Group::place, settings);
}

CLI::App* add_render(CLI::App& root, RenderArguments& arguments, RenderChoices& choices) {
  CLI::App* app = root.add_subcommand("render", "Draw files of diffusion curves");
  app->footer(kRenderFooter);
  add_files(*app, arguments, choices);
  for (const options::Group group :
       {options::Group::place, options::Group::solution, options::Group::mesh,
        options::Group::image, options::Group::vector}) {
    add_group(*app, group, arguments.settings);
  }
  add_option_of(*app, "device", arguments.settings);
  add_option_of(*app, "coherent", arguments.settings);
  add_running_options(*app, arguments.settings, arguments, arguments);
  add_resources(*app, arguments.resources);
  return app;
}

}  // namespace sfumato::cli
