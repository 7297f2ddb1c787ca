#include "cli/options/render_options.hpp"

#include <algorithm>

#include "cli/files/paths.hpp"
#include "options/tables.hpp"

namespace sfumato::cli {
namespace {

constexpr const char* kRenderExamples[] = {
    "sfumato render lady_bug.xml -o lady_bug.png",
    "sfumato render lady_bug.xml -o big.png --width 4096 --depth 16",
    "sfumato render lady_bug.xml -o eye.png --viewport 200,100,64,64 --scale 8",
    "sfumato render lady_bug.xml -o noisy.png --method rays --rays 64 --max-error off",
    "sfumato render lady_bug.xml -o lady_bug.html",
    "sfumato render lady_bug.xml -o lady_bug.pdf --title \"Lady bug\"",
    "sfumato render lady_bug.sfp -o lady_bug.webp",
    "sfumato render *.svg --out-dir pictures --format webp",
    ("sfumato render frames/*.svg -o - --format rgb24 |\n"
     "      ffmpeg -f rawvideo -pixel_format rgb24 -video_size 1280x720 -framerate 24 -i - "
     "film.mp4"),
    "sfumato render - -o - <lady_bug.xml >lady_bug.png"};

constexpr const char* kRenderNotes =
    "Several drawings with --out-dir are drawn one after another; one that fails does not stop\n"
    "the others. Raw frames in one output are a film: all must have the same size, and a drawing\n"
    "that fails ends it. --coherent works with both. With --window the full image may have\n"
    "16,777,216 pixels on a side. Options that control solving are bad usage with a solved\n"
    "picture.";

constexpr const char* kRenderUsages[] = {"IN -o OUT [OPTIONS]", "IN... --out-dir DIR [OPTIONS]",
                                         "IN... -o - --format rgb24 [OPTIONS]"};

void add_files(CommandSyntax& command, RenderArguments& arguments, RenderChoices& choices) {
  constexpr OutputNames kNames{.takes_frames = true};
  command
      .add_file("IN", choices.inputs, "",
                "A drawing (SVG or Orzan XML) or a solved picture (.sfp);\n'-': stdin; several "
                "with --out-dir or raw frames",
                form_of_input(kDrawingsAndSolved))
      ->required();
  add_output(command, choices.output, kNames, "OUT",
             "Write the picture in the format of the extension; '-':\nstdout, in the format of "
             "--format; raw frames: all\ndrawings, one after another");
  add_output_folder(command, choices.output_folder, kRenderWords);
  add_shard(command, choices.shard,
            "Draw only part I of N (from 0): with --out-dir every Nth\ndrawing from the Ith on, "
            "in a film the Ith run [0/1]");
  command.add_flag("--newer-only", choices.newer_only,
                   "Skip drawings whose pictures in --out-dir are up to date");
  add_option(command,
             {.key = "format",
              .kind = options::ValueKind::word,
              .words = options::known_formats(),
              .ignores_case = true,
              .value_name = "EXTENSION",
              .help = "Set the format for --out-dir and '-o -'; rgb24, rgba,\nrgb48le and rgba64le "
                      "are raw frames for ffmpeg [png]"},
             [&choices](const options::Value& value) {
               choices.extension = value.text;
               choices.format = kind_of_format(choices.extension);
             });
  add_allowed_folders(command, arguments);
}

/// Adds all options of the table in a group of the help.
void add_group(CommandSyntax& command, options::Group group, options::Settings& settings) {
  for (const options::Option<options::Settings>& option : options::render_options()) {
    if (option.info.group == group) add_option(command, option, settings);
  }
}

/// Adds one option of the table.
CLI::Option* add_option_of(CommandSyntax& command, std::string_view key,
                           options::Settings& settings) {
  const auto table = options::render_options();
  return add_option(
      command,
      *std::ranges::find(table, key,
                         [](const auto& option) { return std::string_view(option.info.key); }),
      settings);
}

}  // namespace

CLI::Option* add_threads(CommandSyntax& command, options::Settings& settings) {
  return add_option_of(command, "threads", settings);
}

void add_running_options(CommandSyntax& command, options::Settings& settings, JobArguments& jobs,
                         DocumentArguments& documents) {
  add_option_of(command, "gather", settings);
  add_threads(command, settings);
  add_stats(command, jobs.stats, "Write sizes and times as JSON; '-': stdout");
  command.add_flag("--quiet", documents.quiet, "Print no warnings and no progress bar")
      ->group(heading(options::Group::running));
}

void add_place_options(CommandSyntax& command, options::Settings& settings) {
  add_group(command, options::Group::place, settings);
}

void add_render(CommandSyntax& root, RenderArguments& arguments, RenderChoices& choices) {
  CommandSyntax& command =
      root.add_command({.name = "render",
                        .summary = "Render drawings as pictures: PNG, PDF, SVG, HTML and more",
                        .usages = kRenderUsages,
                        .examples = kRenderExamples,
                        .notes = kRenderNotes});
  add_files(command, arguments, choices);
  for (const options::Group group :
       {options::Group::place, options::Group::solution, options::Group::mesh,
        options::Group::image, options::Group::vector}) {
    add_group(command, group, arguments.settings);
  }
  add_option_of(command, "device", arguments.settings);
  add_option_of(command, "coherent", arguments.settings);
  add_running_options(command, arguments.settings, arguments, arguments);
  add_resources(command, arguments.resources);
}

}  // namespace sfumato::cli
