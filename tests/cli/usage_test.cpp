#include <gtest/gtest.h>

#include "cli/run_command.hpp"
#include "cli/scenes.hpp"

namespace sfumato::test {
namespace {

/// Runs `sfumato render` on a good scene with these extra options.
CommandResult render_with(const TemporaryFolder& folder, std::vector<std::string> options) {
  const std::string input = folder.add("scene.xml", two_curve_scene());
  options.insert(options.begin(), {"render", input, "-o", folder.path("out.png")});
  return run_sfumato(std::move(options));
}

TEST(Usage, help_without_arguments_is_an_error) {
  const CommandResult result = run_sfumato({});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_TRUE(contains(result.err, "Usage: sfumato"));
}

TEST(Usage, help_goes_to_stdout_where_it_is_asked_for) {
  const CommandResult result = run_sfumato({"--help"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
  for (const char* command :
       {"render", "info", "convert", "trace", "lint", "compare", "init", "watch", "edit"}) {
    EXPECT_TRUE(contains(result.out, command)) << command;
    const CommandResult help = run_sfumato({command, "--help"});
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_TRUE(contains(help.out, std::string("Usage: sfumato ") + command));
    EXPECT_TRUE(contains(help.out, "Examples:"));
  }
}

TEST(Usage, version_is_one_line) {
  const CommandResult result = run_sfumato({"--version"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_TRUE(result.out.starts_with("sfumato 0."));
  EXPECT_EQ(result.out.find('\n'), result.out.size() - 1);
}

struct BadValue {
  const char* option;
  const char* value;
  const char* expected;  ///< the message's advice
};

TEST(Usage, bad_values_say_what_was_expected) {
  const BadValue cases[] = {
      {"--width", "0", "a whole number of pixels"},
      {"--width", "-5", "a whole number of pixels"},
      {"--width", "1.5", "a whole number of pixels"},
      {"--width", "99999999999999999999", "a whole number of pixels"},
      {"--height", "nan", "a whole number of pixels"},
      {"--scale", "0", "a number above 0"},
      {"--scale", "nan", "a number above 0"},
      {"--scale", "inf", "a number above 0"},
      {"--scale", "-1", "a number above 0"},
      {"--viewport", "0,0,0,10", "x,y,width,height"},
      {"--viewport", "0,0,10", "x,y,width,height"},
      {"--viewport", "0,0,nan,10", "x,y,width,height"},
      {"--window", "0,0,0,10", "x,y,width,height in whole pixels"},
      {"--window", "0,0,1.5,10", "x,y,width,height in whole pixels"},
      {"--window", "-1,0,4,10", "x,y,width,height in whole pixels"},
      {"--method", "magic", "exact|rays|pixels"},
      {"--rays", "0", "from 1 to 4096"},
      {"--rays", "4097", "from 1 to 4096"},
      {"--seed", "-1", "a whole number"},
      {"--tolerance", "0", "user units above 0"},
      {"--tolerance", "nan", "user units above 0"},
      {"--max-area", "0", "a fraction above 0"},
      {"--max-area", "200%", "a fraction above 0"},
      {"--min-angle", "34", "degrees from 0 to 33"},
      {"--min-angle", "nan", "degrees from 0 to 33"},
      {"--max-error", "0", "or off"},
      {"--max-error", "on", "or off"},
      {"--order", "quartic", "linear|quadratic|cubic"},
      {"--background", "#12", "#rrggbb"},
      {"--threads", "0", "from 1 to 1024"},
      {"--max-memory", "0", "MiB"},
      {"--max-time", "0", "seconds above 0, or off"},
      {"--max-time", "forever", "seconds above 0, or off"},
      {"--limit", "curves", "curves= and a whole number from 0 to 3200000"},
      {"--limit", "curves=-1", "curves= and a whole number"},
      {"--limit", "curves=4M", "from 0 to 3200000"},
      {"--limit", "curves=99999999999999999999", "from 0 to 3200000"},
      {"--limit", "curves=3e5", "perhaps with k, M, KiB or MiB"},
      {"--limit", "group-depth=17", "from 0 to 16"},
      {"--limit", "curvs=3", "NAME one of input-bytes, unpack-ratio"},
      {"--limit", "=3", "NAME one of"},
      {"--depth", "12", "8|16"},
  };
  const TemporaryFolder folder;
  for (const BadValue& bad : cases) {
    const CommandResult result = render_with(folder, {bad.option, bad.value});
    const std::string label = std::string(bad.option) + ' ' + bad.value;
    EXPECT_EQ(result.exit_code, 2) << label;
    EXPECT_TRUE(result.err.starts_with("sfumato: error: " + std::string(bad.option) +
                                       ": invalid value \"" + bad.value + "\"; use "))
        << label << "\n"
        << result.err;
    EXPECT_TRUE(contains(result.err, bad.expected)) << label << "\n" << result.err;
    EXPECT_EQ(folder.names(), std::vector<std::string>{"scene.xml"}) << label;
  }
}

TEST(Usage, options_that_do_not_go_together_are_refused) {
  const TemporaryFolder folder;
  const std::vector<std::vector<std::string>> cases = {
      {"--scale", "2", "--width", "10"},
      {"--scale", "2", "--height", "10"},
      {"--dither", "--depth", "16"},
      {"--no-dither", "--depth", "16"},
      {"--dither", "--no-dither"},
      {"--mesh-overlay", "--method", "pixels"},
      {"--stats", folder.path("out.png")},
      {"--width", "10", "--width", "20"},
      {"--device", "gpu", "--window", "0,0,9,9"},
  };
  for (const std::vector<std::string>& options : cases) {
    const CommandResult result = render_with(folder, options);
    EXPECT_EQ(result.exit_code, 2) << options[0];
    EXPECT_TRUE(contains(result.err, options[0])) << result.err;
    EXPECT_EQ(folder.names(), std::vector<std::string>{"scene.xml"});
  }
}

TEST(Usage, stdout_is_given_only_once) {
  const CommandResult result = run_sfumato({"render", "-", "-o", "-", "--stats", "-"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.out, "");
}

TEST(Usage, unknown_options_and_missing_operands_are_named) {
  const CommandResult unknown = run_sfumato({"render", "a.xml", "-o", "b.png", "--fast"});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_TRUE(contains(unknown.err, "--fast"));
  EXPECT_TRUE(contains(unknown.err, "sfumato render --help"));
  EXPECT_EQ(run_sfumato({"render", "a.xml"}).exit_code, 2);
  EXPECT_EQ(run_sfumato({"render", "-o", "b.png"}).exit_code, 2);
  EXPECT_EQ(run_sfumato({"info"}).exit_code, 2);
  EXPECT_EQ(run_sfumato({"compare", "a.png"}).exit_code, 2);
  const CommandResult command = run_sfumato({"paint", "a.xml"});
  EXPECT_EQ(command.exit_code, 2);
  EXPECT_TRUE(
      contains(command.err,
               "unknown command \"paint\"; use render, solve, tiles, info, convert, trace, lint, "
               "compare, init, watch, edit or help"));
}

TEST(Usage, common_mistakes_say_what_to_do) {
  const TemporaryFolder folder;
  const std::string drawing = folder.path("a.svg"), copy = folder.path("b.svg");
  ASSERT_EQ(run_sfumato({"init", drawing}).exit_code, 0);
  ASSERT_EQ(run_sfumato({"init", copy}).exit_code, 0);
  const struct {
    std::vector<std::string> arguments;
    const char* advice;
  } cases[] = {
      {{"render", drawing}, "no output: use -o picture.png or --out-dir DIR"},
      {{"solve", drawing}, "no output: use -o picture.sfp or --out-dir DIR"},
      {{"render", drawing, copy, "-o", "a.png"}, "several drawings given; use --out-dir DIR"},
      {{"render", drawing, "-o", "a.jpg", "--lossless"}, "--lossless: works with WebP only"},
      {{"render", drawing, "-o", "a.png", "--scale", "2", "--width", "9"},
       "--scale: cannot be combined with --width and --height"},
      {{"render", drawing, "-o", drawing}, "would replace the drawing"},
      {{"render", drawing, "-o", folder.path("none/a.png")}, "does not exist; create it first"},
      {{"render", drawing, "-o", folder.path("a.png"), "--width", "99999"},
       "--limit image-side=N goes up to 16384; use a smaller image"},
      {{"init", drawing}, "exists already; use a new name, or replace it with --force"},
  };
  for (const auto& mistake : cases) {
    const CommandResult result = run_sfumato(mistake.arguments);
    EXPECT_NE(result.exit_code, 0) << mistake.advice;
    EXPECT_TRUE(contains(result.err, mistake.advice)) << result.err;
  }
}

TEST(Usage, mistyped_options_get_a_suggestion_in_every_command) {
  const auto message = [](std::vector<std::string> arguments) {
    const CommandResult result = run_sfumato(std::move(arguments));
    EXPECT_EQ(result.exit_code, 2) << result.err;
    return result.err.substr(0, result.err.find('\n'));
  };
  for (const std::string command :
       {"render", "info", "convert", "lint", "compare", "init", "watch"}) {
    EXPECT_EQ(message({command, "--max-tmie", "3"}),
              "sfumato: error: unknown option \"--max-tmie\" for " + command +
                  "; did you mean --max-time?");
    EXPECT_EQ(message({command, "a.svg", "--ful"}),
              "sfumato: error: unknown option \"--ful\" for " + command);
  }
  EXPECT_EQ(message({"render", "a.svg", "--out=b.png"}),
            "sfumato: error: unknown option \"--out\" for render; did you mean --output?");
  EXPECT_EQ(message({"render", "a.svg", "-w", "9"}),
            "sfumato: error: unknown option \"-w\" for render; use --width");
  EXPECT_EQ(
      message({"render", "a.svg", "-o", "b.png", "--method", "exat"}),
      "sfumato: error: --method: invalid value \"exat\"; use one of exact|rays|pixels; did you "
      "mean exact?");
  EXPECT_TRUE(message({"render", "a.svg", "-o", "b.svg", "--svg", "vectr"})
                  .ends_with("; did you mean vector?"));
  EXPECT_TRUE(message({"render", "a.svg", "-o", "b.png", "--ends", "sharp"})
                  .ends_with("; use one of soft|paper"));
  EXPECT_TRUE(message({"--hlep"}).ends_with("; did you mean --help?"));
  EXPECT_TRUE(message({"lint", "a.svg", "--limit", "curvs=3"}).ends_with("; did you mean curves?"));
}

TEST(Usage, mistyped_extensions_get_a_suggestion_in_every_command) {
  const auto message = [](std::vector<std::string> arguments) {
    const CommandResult result = run_sfumato(std::move(arguments));
    EXPECT_EQ(result.exit_code, 2) << result.err;
    return result.err.substr(0, result.err.find('\n'));
  };
  for (const std::string command : {"render", "watch"}) {
    EXPECT_TRUE(message({command, "a.svg", "-o", "b.pgn"}).ends_with("; did you mean b.png?"));
    EXPECT_TRUE(
        message({command, "a.svg", "-o", "c/b.d.HMTL"}).ends_with("; did you mean c/b.d.html?"));
    EXPECT_TRUE(message({command, "a.svg", "-o", "b.jepg"}).ends_with("; did you mean b.jpg?"));
  }
  EXPECT_TRUE(message({"render", "a.svg", "-o", "b.tiff"}).ends_with(".rgba64le, or -"));
  EXPECT_TRUE(message({"watch", "a.svg", "-o", "b"}).ends_with(".ply, .json"));
  EXPECT_EQ(message({"convert", "a.xml", "-o", "b.sgv"}),
            "sfumato: error: --output: cannot tell the format of \"b.sgv\"; use a file name that "
            "ends in .svg, .svgz, "
            "or -; did you mean b.svg?");
  EXPECT_TRUE(message({"convert", "a.xml", "-o", "b.pgn"}).ends_with(".svgz, or -"));
  EXPECT_TRUE(message({"init", "b.sgv"}).ends_with("; did you mean b.svg?"));
  EXPECT_TRUE(
      message({"init", "b.svg", "--template", "spere"}).ends_with("; did you mean sphere?"));
  EXPECT_TRUE(
      message({"compare", "a.png", "b.png", "-o", "c.npg"}).ends_with("; did you mean c.png?"));
  EXPECT_EQ(message({"render", "a.svg", "-o", "-", "--format", "ppng"}),
            "sfumato: error: --format: invalid value \"ppng\"; use one of "
            "png|jpg|jpeg|webp|html|pdf|eps|svg|glb|sfv|npz|ply|json|rgb24|rgba|rgb48le|rgba64le; "
            "did you mean png?");
}

TEST(Usage, unknown_extensions_list_the_known_ones) {
  const TemporaryFolder folder;
  for (const char* name : {"out.gif", "out", "out.png.xml", ".png"}) {
    const CommandResult result = run_sfumato(
        {"render", folder.add("scene.xml", two_curve_scene()), "-o", folder.path(name)});
    EXPECT_EQ(result.exit_code, 2) << name;
    EXPECT_TRUE(contains(result.err, "use a file name that ends in .png")) << result.err;
    EXPECT_EQ(folder.names(), std::vector<std::string>{"scene.xml"});
  }
}

}  // namespace
}  // namespace sfumato::test
