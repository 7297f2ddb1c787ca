#include "cli/options/tiles_options.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

#include "base/text/ascii.hpp"
#include "cli/files/file_uses.hpp"
#include "options/settle.hpp"
#include "options/tables.hpp"
#include "tiles/big_tiff.hpp"

namespace sfumato::cli {
namespace {

constexpr const char* kTilesExamples[] = {
    "sfumato solve lady_bug.xml -o lady_bug.sfp --scale 128", "sfumato tiles lady_bug.sfp -o deep",
    "sfumato tiles lady_bug.sfp -o lady_bug.dzi --width 65536 --format webp",
    "sfumato tiles lady_bug.sfp -o deep --shard 3/16",
    "sfumato tiles lady_bug.sfp -o lady_bug.tif"};

constexpr std::uint64_t kLargestTile = 4096;
constexpr std::uint64_t kLargestOverlap = 64;

/// The options that `tiles` shares with `render`.
constexpr std::array<std::string_view, 10> kOptions{
    "width",     "height",  "scale",    "background",   "dither",
    "no-dither", "quality", "lossless", "no-antialias", "threads"};

constexpr std::string_view kFormats[] = {"png", "webp", "jpg"};

constexpr const char* kTilesUsages[] = {"IN.sfp -o OUT [OPTIONS]"};
constexpr const char* kTilesNotes =
    "Each level has the pixels that `sfumato render` draws at that size. The same call again\n"
    "skips the tiles that exist.";

bool has_extension(const std::string& path, std::string_view extension) {
  return ascii_lower(std::filesystem::path(path).extension().string()) == extension;
}

/// Returns the path of the .dzi file in the folder `output`; it is named after the picture.
std::string description_in(const std::string& output, const std::string& input) {
  const std::string stem = std::filesystem::path(input).stem().string();
  const std::string name = input == "-" || stem.empty() ? "picture" : stem;
  return (std::filesystem::path(output) / (name + ".dzi")).string();
}

void add_files(CommandSyntax& command, TilesArguments& arguments, TilesChoices& choices) {
  constexpr std::string_view kSolved[] = {kSolvedExtension};
  constexpr std::string_view kOutputs[] = {"dzi", "tif", "tiff"};
  command
      .add_file("IN.sfp", arguments.input, "", "A solved picture (see `sfumato solve`); '-': stdin",
                form_of_input(kSolved))
      ->required();
  command
      .add_file("-o,--output", arguments.output, "OUT",
                "Write Deep Zoom tiles (OUT is a folder or NAME.dzi) or one\nBigTIFF with all "
                "levels (NAME.tif)",
                form_of_output(kOutputs))
      ->required();
  add_shard(command, choices.shard,
            "Do only part I of N (from 0); a call that was cut off\ncontinues where it stopped "
            "[0/1]");
  add_option(command,
             {.key = "format",
              .kind = options::ValueKind::word,
              .words = kFormats,
              .help = "Set the format of the tiles [png]"},
             [&choices](const options::Value& value) { choices.format = value.text; });
  add_option(command,
             {.key = "tile",
              .kind = options::ValueKind::whole,
              .wholes = {tiles::kTiffTileStep, kLargestTile},
              .expected = "a whole number of pixels from 16 to 4096",
              .value_name = "PIXELS",
              .help = "Set the side of a tile [256]"},
             [&choices](const options::Value& value) {
               choices.tile_side = static_cast<int>(value.whole);
             });
  add_option(
      command,
      {.key = "overlap",
       .kind = options::ValueKind::whole,
       .wholes = {0, kLargestOverlap},
       .expected = "a whole number of pixels from 0 to 64",
       .value_name = "PIXELS",
       .help = "Set how far tiles reach into their neighbours [0]"},
      [&choices](const options::Value& value) { choices.overlap = static_cast<int>(value.whole); });
}

}  // namespace

void add_tiles(CommandSyntax& root, TilesArguments& arguments, TilesChoices& choices) {
  CommandSyntax& command =
      root.add_command({.name = "tiles",
                        .summary = "Cut a solved picture into tiles for deep zoom",
                        .usages = kTilesUsages,
                        .examples = kTilesExamples,
                        .notes = kTilesNotes});
  add_files(command, arguments, choices);
  for (const options::Option<options::Settings>& option : options::render_options()) {
    if (std::ranges::find(kOptions, option.info.key) == kOptions.end()) continue;
    add_option(command, option, arguments.settings);
  }
  command.get_option("--width")->description(
      "Set the width of the largest level [the solved size]");
  command.get_option("--height")
      ->description("Set the height of the largest level [the solved size]");
  command.get_option("--scale")->description(
      "Set the size as pixels per user unit instead [the solved\nsize]");
  add_stats(command, arguments.stats, "Write sizes and times as JSON; '-': stdout");
  command.add_flag("--quiet", arguments.quiet, "Print no warnings and no progress bar")
      ->group(heading(options::Group::running));
  add_resources(command, arguments.resources);
  command.get_option("--max-time")->description("Stop after this time [off]");
}

void settle(TilesArguments& arguments, const TilesChoices& choices) {
  expect(!arguments.output.empty() && arguments.output != "-", "--output",
         "use a folder, NAME.dzi or NAME.tif");
  arguments.is_tiff =
      has_extension(arguments.output, ".tif") || has_extension(arguments.output, ".tiff");
  arguments.tile_side = choices.tile_side.value_or(arguments.tile_side);
  arguments.overlap = choices.overlap.value_or(arguments.overlap);
  arguments.shard = choices.shard.value_or(arguments.shard);
  arguments.extension = choices.format.value_or(arguments.extension);
  if (arguments.is_tiff) {
    expect(!choices.shard, "--shard", "works with Deep Zoom only: a BigTIFF is one file");
    expect(!choices.overlap, "--overlap", "works with Deep Zoom only");
    expect(!choices.format, "--format", "works with Deep Zoom only");
    expect(arguments.tile_side % tiles::kTiffTileStep == 0, "--tile",
           "use a multiple of 16 with a BigTIFF");
  } else if (!has_extension(arguments.output, ".dzi")) {
    arguments.output = description_in(arguments.output, arguments.input);
  }
  expect_none("--output", complaint_about({{arguments.input, "the solved picture"}},
                                          {{arguments.output, "the tiles", "--output"},
                                           {arguments.stats, "the figures", "--stats"}}));
  expect(arguments.overlap < arguments.tile_side, "--overlap", "use less than the side of a tile");
  const OutputKind kind = *options::kind_of_extension(arguments.extension);
  expect_none(options::find_conflict(arguments.settings, kind));
  options::settle(arguments.settings, kind);
}

}  // namespace sfumato::cli
