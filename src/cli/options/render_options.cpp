#include "cli/options/render_options.hpp"

#include "cli/files/paths.hpp"
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
                 "A drawing (SVG or Orzan XML) or a solved picture (.sfp);\n'-': stdin; several "
                 "with --out-dir or raw frames")
      ->required()
      ->type_name("");
  add_output(app, choices.output, {.takes_frames = true}, "OUT",
             "Write the picture in the format of the extension; '-':\nstdout, in the format of "
             "--format; raw frames: all\ndrawings, one after another");
  app.add_option(
         "--out-dir", choices.output_folder,
         "Write each picture into this folder instead, named after\nits drawing; the folder "
         "is created if needed")
      ->type_name("DIR")
      ->excludes("--output");
  add_value(app, "--shard", kShardText,
            "Draw only part I of N (from 0): with --out-dir every Nth\ndrawing from the Ith on, "
            "in a film the Ith run [0/1]",
            into(choices.shard, parse_shard));
  app.add_flag("--newer-only", choices.newer_only,
               "Skip drawings whose pictures in --out-dir are up to date");
  add_value(app, "--format", one_of(known_formats(), "EXTENSION"),
            "Set the format for --out-dir and '-o -'; rgb24, rgba,\nrgb48le and rgba64le are raw "
            "frames for ffmpeg [png]",
            [&choices](const std::string& text) {
              choices.extension = text;
              choices.format = kind_of_format(text);
              return choices.format.has_value();
            });
  add_allowed_folders(app, arguments);
}

/// Adds all options of the table in a group of the help.
void add_group(CLI::App& app, options::Group group, options::Settings& settings) {
  for (const options::Option<options::Settings>& option : options::render_options()) {
    if (option.info.group == group) add_option(app, option, settings);
  }
}

/// Adds one option of the table.
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
  app.add_option("--stats", jobs.stats, "Write sizes and times as JSON; '-': stdout")
      ->type_name("FILE.json")
      ->group(group);
  app.add_flag("--quiet", documents.quiet, "Print no warnings and no progress bar")->group(group);
}

void add_place_options(CLI::App& app, options::Settings& settings) {
  add_group(app, options::Group::place, settings);
}

CLI::App* add_render(CLI::App& root, RenderArguments& arguments, RenderChoices& choices) {
  CLI::App* app =
      root.add_subcommand("render", "Render drawings as pictures: PNG, PDF, SVG, HTML and more");
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
