#include "cli/options/tiles_options.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

#include "base/text/ascii.hpp"
#include "cli/files/file_uses.hpp"
#include "options/settle.hpp"
#include "options/tables.hpp"
#include "options/values.hpp"
#include "tiles/big_tiff.hpp"

namespace sfumato::cli {
namespace {

constexpr const char* kTilesFooter =
    "Examples:\n"
    "  sfumato solve lady_bug.xml -o lady_bug.sfp --scale 128\n"
    "  sfumato tiles lady_bug.sfp -o deep\n"
    "  sfumato tiles lady_bug.sfp -o lady_bug.dzi --width 65536 --format webp\n"
    "  sfumato tiles lady_bug.sfp -o deep --shard 3/16\n"
    "  sfumato tiles lady_bug.sfp -o lady_bug.tif";

constexpr std::uint64_t kLargestTile = 4096;
constexpr std::uint64_t kLargestOverlap = 64;

/// The options that `tiles` shares with `render`.
constexpr std::array<std::string_view, 9> kOptions{"width",      "height",   "scale",
                                                   "background", "dither",   "no-dither",
                                                   "quality",    "lossless", "no-antialias"};

bool has_extension(const std::string& path, std::string_view extension) {
  return ascii_lower(std::filesystem::path(path).extension().string()) == extension;
}

/// Returns the path of the .dzi file in the folder `output`; it is named after the picture.
std::string description_in(const std::string& output, const std::string& input) {
  const std::string stem = std::filesystem::path(input).stem().string();
  const std::string name = input == "-" || stem.empty() ? "picture" : stem;
  return (std::filesystem::path(output) / (name + ".dzi")).string();
}

}  // namespace

CLI::App* add_tiles(CLI::App& root, TilesArguments& arguments, TilesChoices& choices) {
  CLI::App* app = root.add_subcommand("tiles", "Cut a solved picture into tiles for deep zoom");
  app->footer(kTilesFooter);
  app->add_option("IN.sfp", arguments.input, "A solved picture (see `sfumato solve`); '-': stdin")
      ->required()
      ->type_name("");
  app->add_option("-o,--output", arguments.output,
                  "Write Deep Zoom tiles (OUT is a folder or NAME.dzi) or one\nBigTIFF with all "
                  "levels (NAME.tif)")
      ->required()
      ->type_name("OUT");
  add_value(
      *app, "--shard", kShardText,
      "Do only part I of N (from 0); a call that was cut off\ncontinues where it stopped [0/1]",
      into(choices.shard, parse_shard));
  add_value(*app, "--format", one_of({"png", "webp", "jpg"}), "Set the format of the tiles [png]",
            into(choices.format, [](const std::string& text) -> std::optional<std::string> {
              if (text == "png" || text == "webp" || text == "jpg") return text;
              return std::nullopt;
            }));
  add_value(*app, "--tile", {"a whole number of pixels from 16 to 4096", "PIXELS"},
            "Set the side of a tile [256]", into(choices.tile_side, [](const std::string& text) {
              return options::parse_whole(text, tiles::kTiffTileStep, kLargestTile);
            }));
  add_value(*app, "--overlap", {"a whole number of pixels from 0 to 64", "PIXELS"},
            "Set how far tiles reach into their neighbours [0]",
            into(choices.overlap, [](const std::string& text) {
              return options::parse_whole(text, 0, kLargestOverlap);
            }));
  for (const options::Option<options::Settings>& option : options::render_options()) {
    const bool is_taken = std::ranges::find(kOptions, option.info.key) != kOptions.end();
    if (is_taken || option.info.key == std::string_view("threads")) {
      add_option(*app, option, arguments.settings);
    }
  }
  app->get_option("--width")->description("Set the width of the largest level [the solved size]");
  app->get_option("--height")->description("Set the height of the largest level [the solved size]");
  app->get_option("--scale")->description(
      "Set the size as pixels per user unit instead [the solved\nsize]");
  app->add_option("--stats", arguments.stats, "Write sizes and times as JSON; '-': stdout")
      ->type_name("FILE.json")
      ->group(heading(options::Group::running));
  app->add_flag("--quiet", arguments.quiet, "Print no warnings and no progress bar")
      ->group(heading(options::Group::running));
  add_resources(*app, arguments.resources);
  app->get_option("--max-time")->description("Stop after this time [off]");
  return app;
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
  const std::string complaint = complaint_about(
      {{arguments.input, "the solved picture"}},
      {{arguments.output, "the tiles", "--output"}, {arguments.stats, "the figures", "--stats"}});
  expect(complaint.empty(), "--output", complaint);
  expect(arguments.overlap < arguments.tile_side, "--overlap", "use less than the side of a tile");
  const OutputKind kind = *options::kind_of_extension(arguments.extension);
  const options::Conflict conflict = options::find_conflict(arguments.settings, kind);
  expect(conflict.key.empty(), options::spelled(conflict.key, true).c_str(),
         options::spelled(conflict.complaint, true));
  options::settle(arguments.settings, kind);
}

}  // namespace sfumato::cli
