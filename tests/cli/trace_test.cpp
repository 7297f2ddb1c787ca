// `sfumato trace`: files, options, messages and refusals. The tests of trace() check the quality of
// drawings.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <regex>
#include <string>
#include <thread>

#include "cli/run_command.hpp"
#include "cli/scenes.hpp"
#include "formats/image_files.hpp"
#include "formats/photo_files.hpp"
#include "support/places.hpp"
#include "support/stroke_page.hpp"

namespace sfumato::test {
namespace {

using Names = std::vector<std::string>;

/// Returns a disc on a ground of another colour.
Image disc(int width, int height) {
  Image image{width, height, PixelFormat::rgb8, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int dx = 2 * x - width, dy = 2 * y - height;
      const bool is_inside = dx * dx + dy * dy < width * height / 4;
      for (const int level : is_inside ? std::array{220, 90, 30} : std::array{20, 60, 140}) {
        image.bytes.push_back(static_cast<std::uint8_t>(level));
      }
    }
  }
  return image;
}

std::string disc_png() {
  return png_of(disc(48, 36));
}

/// Traces a picture to out.svg.
CommandResult trace(const TemporaryFolder& folder, const std::string& picture,
                    std::vector<std::string> options = {}) {
  options.insert(options.begin(),
                 {"trace", folder.add("in.png", picture), "-o", folder.path("out.svg")});
  return run_sfumato(std::move(options));
}

/// Expects a drawing of this size that `render` draws.
void expect_drawing(const std::string& path, int width, int height) {
  const CommandResult facts = run_sfumato({"info", path, "--json"});
  EXPECT_EQ(facts.exit_code, 0) << facts.err;
  const std::string size =
      "\"width\":" + std::to_string(width) + ",\"height\":" + std::to_string(height);
  EXPECT_TRUE(contains(facts.out, size)) << facts.out;
  const CommandResult picture = run_sfumato({"render", path, "-o", "-", "--width", "16"});
  EXPECT_EQ(picture.exit_code, 0) << picture.err;
}

TEST(Trace, makes_a_drawing_of_a_picture_and_says_how_near_it_is) {
  const TemporaryFolder folder;
  const CommandResult result = trace(folder, disc_png());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, "");
  const std::regex line(
      ".*/out\\.svg: [0-9,]+ curves?, [0-9,]+ points?, ([0-9]+\\.[0-9] dB|no difference) in "
      "[0-9]+\\.[0-9] s\n");
  EXPECT_TRUE(std::regex_match(result.err, line)) << result.err;
  expect_drawing(folder.path("out.svg"), 48, 36);
  EXPECT_EQ(folder.names(), (Names{"in.png", "out.svg"}));
  EXPECT_EQ(trace(folder, disc_png(), {"--quiet"}).err, "");
}

TEST(Trace, with_a_texture_says_how_near_that_is) {
  const TemporaryFolder folder;
  const CommandResult result =
      trace(folder, disc_png(), {"--texture", "--points", "40", "--stats", "-"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(contains(result.err, " (with its texture ")) << result.err;
  EXPECT_TRUE(contains(result.out, ",\"textured_psnr_db\":")) << result.out;
  const CommandResult lint = run_sfumato({"lint", "--strict", folder.path("out.svg")});
  EXPECT_EQ(lint.exit_code, 0) << lint.out;
  const CommandResult refused = trace(folder, disc_png(), {"--texture", "--limit", "texels=2000"});
  EXPECT_EQ(refused.exit_code, 3);
  EXPECT_TRUE(contains(refused.err, "the texture would have")) << refused.err;
}

TEST(Trace, takes_pictures_of_every_kind) {
  const TemporaryFolder folder;
  Image deep = disc(20, 10);
  deep.format = PixelFormat::rgb16;
  deep.bytes.resize(2 * deep.bytes.size(), 70);
  Bytes palette_rows, alpha_rows;
  for (int y = 0; y < 10; ++y) {
    palette_rows.push_back(0), alpha_rows.push_back(0);
    for (int x = 0; x < 20; ++x) {
      palette_rows.push_back(x < 10 ? 0 : 1);
      alpha_rows.insert(alpha_rows.end(), {static_cast<std::uint8_t>(9 * x), 200});
    }
  }
  const std::string pictures[] = {
      png_of(deep),
      text_of(png_of(20, 10, 8, 3, palette_rows, {{"PLTE", {9, 80, 200, 250, 90, 3}}})),
      text_of(png_of(20, 10, 8, 4, alpha_rows)),
      text_of(jpeg_file(20, 10, 1, {90, 0, 0, 0})),
      text_of(jpeg_file(20, 10, 3, {200, 100, 50, 0}, true)),
      text_of(with_profile(jpeg_file(20, 10, 4, {200, 100, 50, 9}), ink_profile())),
      text_of(with_profile(jpeg_file(20, 10, 3, {200, 100, 50, 9}), display_p3_profile()))};
  for (const std::string& picture : pictures) {
    const CommandResult result = trace(folder, picture);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_FALSE(contains(result.err, "warning")) << result.err;
    expect_drawing(folder.path("out.svg"), 20, 10);
  }
}

TEST(Trace, strokes_that_too_few_points_lose_are_a_warning) {
  const TemporaryFolder folder;
  const std::string page = png_of(stroke_page(6, 3));
  const CommandResult lost = trace(folder, page, {"--points", "80", "--stats", "-"});
  EXPECT_EQ(lost.exit_code, 0) << lost.err;
  expect_drawing(folder.path("out.svg"), 144, 72);
  std::smatch needed;
  const std::regex warning(
      "in\\.png: warning: .*trace is for photographs.* about ([0-9]+) control ");
  ASSERT_TRUE(std::regex_search(lost.err, needed, warning)) << lost.err;
  EXPECT_TRUE(contains(lost.out, ",\"points_needed\":" + needed[1].str())) << lost.out;
  const CommandResult all = trace(folder, page, {"--points", needed[1]});
  EXPECT_FALSE(contains(all.err, "warning")) << all.err;
  EXPECT_EQ(trace(folder, page, {"--points", "80", "--quiet"}).err, "");
}

TEST(Trace, photos_stand_upright) {
  const TemporaryFolder folder;
  const std::string photo = text_of(with_exif(jpeg_file(30, 10, 3, {200, 9, 9, 0}), exif_of(6)));
  ASSERT_EQ(trace(folder, photo).exit_code, 0);
  expect_drawing(folder.path("out.svg"), 10, 30);
}

TEST(Trace, pictures_of_odd_sizes_and_of_one_colour_become_drawings) {
  const TemporaryFolder folder;
  for (const auto& [width, height] : {std::pair(1, 1), std::pair(1, 300), std::pair(300, 1),
                                      std::pair(2, 2), std::pair(40, 40)}) {
    Image image{width, height, PixelFormat::rgb8, {}};
    image.bytes.resize(image.row_bytes() * static_cast<std::size_t>(height), 77);
    const CommandResult result = trace(folder, png_of(image));
    ASSERT_EQ(result.exit_code, 0) << width << " × " << height << ": " << result.err;
    expect_drawing(folder.path("out.svg"), width, height);
  }
}

struct BadPicture {
  const char* name;
  std::string bytes;
  int exit_code;
  const char* message;
};

TEST(Trace, what_is_no_picture_is_one_message_and_no_file) {
  const std::string jpeg = text_of(jpeg_file(64, 48, 3, {200, 100, 50, 0}));
  Bytes lying = png_of(1, 1, 8, 2, {0, 1, 2, 3});
  const Bytes huge = png_of(60'000, 60'000, 8, 2, Bytes(1000));
  const Bytes long_one = png_of(1, 20'000, 8, 0, Bytes(40'000));
  const Bytes many = png_of(16'000, 16'000, 8, 2, Bytes(1000));
  const BadPicture cases[] = {
      {"empty", "", 1, "in.png: error: is an empty file; use a PNG, a JPEG or a WebP"},
      {"text", "hello", 1, "in.png: error: is not a picture; use"},
      {"drawing", two_curve_scene(), 1, "in.png: error: is "},
      {"cut PNG", disc_png().substr(0, 100), 1, "in.png: error: the PNG image is damaged"},
      {"cut JPEG", jpeg.substr(0, jpeg.size() / 2), 1, "in.png: error: the JPEG image is damaged"},
      {"huge", text_of(huge), 3, "the limit is 16384 pixels on a side; --limit image-side=N"},
      {"long", text_of(long_one), 3, "an image of 1 × 20000 pixels; the limit is 16384"},
      {"many pixels", text_of(many), 3, "; raise the limit with --limit texels=N"},
  };
  for (const BadPicture& bad : cases) {
    const TemporaryFolder folder;
    const CommandResult result = trace(folder, bad.bytes);
    EXPECT_EQ(result.exit_code, bad.exit_code) << bad.name << result.err;
    EXPECT_TRUE(contains(result.err, bad.message)) << bad.name << ": " << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_EQ(folder.names(), Names{"in.png"}) << bad.name;
  }
}

TEST(Trace, what_is_ignored_of_a_picture_is_a_warning) {
  const TemporaryFolder folder;
  const std::string photo = text_of(with_exif(jpeg_file(16, 16, 3, {200, 9, 9, 0}), {1, 2, 3}));
  const CommandResult result = trace(folder, photo);
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_TRUE(contains(result.err, "in.png: warning: the orientation is ignored")) << result.err;
  EXPECT_EQ(trace(folder, photo, {"--quiet"}).err, "");
}

TEST(Trace, files_that_cannot_be_read_or_written_are_told) {
  const TemporaryFolder folder;
  const std::string out = folder.path("out.svg"), picture = folder.add("in.png", disc_png());
  const CommandResult missing = run_sfumato({"trace", folder.path("none.jpg"), "-o", out});
  EXPECT_EQ(missing.exit_code, 1);
  EXPECT_TRUE(contains(missing.err, "none.jpg: error: cannot be read")) << missing.err;
  EXPECT_EQ(run_sfumato({"trace", folder.path(""), "-o", out}).exit_code, 1);
  EXPECT_EQ(run_sfumato({"trace", picture, "-o", folder.path("no/out.svg")}).exit_code, 3);
  const std::string large = folder.add("large.png", png_of(disc(700, 700)));
  const CommandResult no_room = run_sfumato({"trace", large, "-o", out, "--max-memory", "1"});
  EXPECT_EQ(no_room.exit_code, 3);
  EXPECT_TRUE(contains(no_room.err, "; raise the limit with --max-memory MIB")) << no_room.err;
  EXPECT_EQ(run_sfumato({"trace", picture, "-o", out, "--limit", "image-file-bytes=9"}).exit_code,
            3);
  EXPECT_EQ(folder.names(), (Names{"in.png", "large.png"}));
}

TEST(Trace, reads_standard_input_and_writes_standard_output) {
  const TemporaryFolder folder;
  ASSERT_EQ(trace(folder, disc_png()).exit_code, 0);
  const CommandResult piped = run_sfumato({"trace", "-", "-o", "-"}, disc_png());
  EXPECT_EQ(piped.exit_code, 0) << piped.err;
  EXPECT_EQ(piped.out, read_whole(folder.path("out.svg")));
  EXPECT_TRUE(piped.err.starts_with("<stdout>: ")) << piped.err;
  const CommandResult bad = run_sfumato({"trace", "-", "-o", "-"}, "hello");
  EXPECT_EQ(bad.exit_code, 1);
  EXPECT_TRUE(contains(bad.err, "<stdin>: error: ")) << bad.err;
}

TEST(Trace, writes_svgz) {
  const TemporaryFolder folder;
  ASSERT_EQ(trace(folder, disc_png()).exit_code, 0);
  const std::string packed = folder.path("out.svgz");
  ASSERT_EQ(run_sfumato({"trace", folder.path("in.png"), "-o", packed}).exit_code, 0);
  EXPECT_TRUE(read_whole(packed).starts_with("\x1f\x8b"));
  EXPECT_EQ(run_sfumato({"convert", packed, "-o", "-"}).out,
            run_sfumato({"convert", folder.path("out.svg"), "-o", "-"}).out);
}

TEST(Trace, takes_all_its_options) {
  const TemporaryFolder folder;
  const std::vector<std::vector<std::string>> options{
      {"--points", "60"},    {"--detail", "0"},
      {"--max-curves", "5"}, {"--psnr", "20"},
      {"--blur", "on"},      {"--blur", "off"},
      {"--blur", "fixed"},   {"--smooth", "1.5"},
      {"--smooth", "0"},     {"--stops", "few"},
      {"--stops", "normal"}, {"--stops", "many"},
      {"--max-side", "32"},  {"--seed", "18446744073709551615"},
      {"--threads", "1"},    {"--max-time", "3000"},
      {"--max-time", "off"}, {"--edges-only"},
      {"--no-alpha"},        {"--limit", "texels=2k"}};
  for (const std::vector<std::string>& option : options) {
    const CommandResult result = trace(folder, disc_png(), option);
    EXPECT_EQ(result.exit_code, 0) << option.front() << ": " << result.err;
    expect_drawing(folder.path("out.svg"), 48, 36);
  }
}

struct BadTraceUsage {
  std::vector<std::string> options;
  const char* expected;
};

TEST(Trace, wrong_options_are_told_and_nothing_is_done) {
  const BadTraceUsage cases[] = {
      {{"--points", "0"}, "use a whole number from 1 to 4000000"},
      {{"--detail", "1.5"}, "use a number from 0 to 1"},
      {{"--detail", "nan"}, "use a number from 0 to 1"},
      {{"--points", "9", "--detail", "0.5"}, "excludes"},
      {{"--max-curves", "-1"}, "use a whole number from 1 to 200000"},
      {{"--psnr", "0"}, "use decibels above 0"},
      {{"--psnr", "inf"}, "use decibels above 0"},
      {{"--blur", "maybe"}, "use one of on|off|fixed"},
      {{"--smooth", "-1"}, "use a number of pixels from 0 to 32"},
      {{"--stops", "most"}, "use one of few|normal|many"},
      {{"--max-side", "4"}, "use a whole number of pixels from 16 to 16384"},
      {{"--seed", "-1"}, "use a whole number"},
      {{"--threads", "0"}, "use a whole number from 1 to 1024"},
      {{"--max-time", "0"}, "--max-time"},
      {{"--format", "svg"}, "unknown option \"--format\" for trace"},
      {{"--colors-only", "a.svg", "--points", "9"},
       "--points: cannot be combined with --colors-only"},
      {{"--colors-only", "a.svg", "--no-alpha"},
       "--no-alpha: cannot be combined with --colors-only"},
      {{"--colors-only", "a.svg", "--texture"}, "--texture: cannot be combined with --colors-only"},
      {{"--only", "0:0"}, "--only requires --colors-only"},
      {{"--keep-colors"}, "--keep-colors requires --colors-only"},
      {{"--colors-only", "a.svg", "--keep-colors", "--blur", "off"},
       "--keep-colors: works with --blur on"},
      {{"--colors-only", "a.svg", "--keep-colors", "--blur", "fixed"},
       "--keep-colors: works with --blur on"},
      {{"--colors-only", "a.svg", "--only", "0:0,1;1"},
       "--only: invalid value \"0:0,1;1\"; use LAYER:CURVE, and so on, with commas between"},
      {{"--colors-only", "a.svg", "--only", ""}, "--only: invalid value \"\"; use LAYER:CURVE"},
      {{"--colors-only", "a.svg", "--only", "0:0,"}, "--only: invalid value \"0:0,\"; use"},
      {{"--colors-only", "a.svg", "--only", "0:4294967296"}, "use LAYER:CURVE"},
  };
  for (const BadTraceUsage& bad : cases) {
    const TemporaryFolder folder;
    const CommandResult result = trace(folder, disc_png(), bad.options);
    EXPECT_EQ(result.exit_code, 2) << bad.options.front() << result.err;
    EXPECT_TRUE(contains(result.err, bad.expected)) << result.err;
    EXPECT_EQ(folder.names(), Names{"in.png"});
  }
}

TEST(Trace, files_that_do_not_go_together_are_bad_usage) {
  const TemporaryFolder folder;
  const std::string a = folder.add("a.png", disc_png()), b = folder.add("b.png", disc_png());
  const std::string drawing = folder.add("d.svg", "x"), out = folder.path("o.svg");
  const BadTraceUsage cases[] = {
      {{a}, "no output: use -o drawing.svg or --out-dir DIR"},
      {{a, b, "-o", out}, "several pictures given; use --out-dir DIR for their drawings"},
      {{"-", b, "--out-dir", folder.path("o")}, "stdin has no name; use -o"},
      {{a, "-o", folder.path("o.png")}, "use a file name that ends in .svg, .svgz, or -"},
      {{a, "-o", out, "--out-dir", folder.path("o")}, "excludes"},
      {{a, "-o", "-", "--stats", "-"}, "stdout is taken by the drawing"},
      {{a, "-o", out, "--stats", out}, "would both become"},
      {{a, "-o", drawing, "--colors-only", drawing}, "would replace the drawing of --colors-only"},
      {{"-", "-o", out, "--colors-only", "-"}, "stdin can be read only once"},
      {{folder.add("p.svg", disc_png()), "-o", folder.path("p.svg")},
       "the drawing would replace the picture"},
  };
  const Names before = folder.names();
  for (const BadTraceUsage& bad : cases) {
    std::vector<std::string> arguments = bad.options;
    arguments.insert(arguments.begin(), "trace");
    const CommandResult result = run_sfumato(arguments, disc_png());
    EXPECT_EQ(result.exit_code, 2) << result.err;
    EXPECT_TRUE(contains(result.err, bad.expected)) << result.err;
    EXPECT_EQ(folder.names(), before);
  }
}

TEST(TraceMany, each_becomes_the_drawing_that_it_becomes_alone) {
  const TemporaryFolder folder;
  const std::string a = folder.add("a.png", disc_png());
  const std::string b = folder.add("b.old.jpg", text_of(jpeg_file(30, 20, 3, {9, 90, 200, 0})));
  const std::string alone = folder.path("alone.svg"), out = folder.path("new/drawings");
  ASSERT_EQ(run_sfumato({"trace", a, "-o", alone}).exit_code, 0);
  const CommandResult result = run_sfumato({"trace", a, b, "--out-dir", out});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(result.err.starts_with(out + "/a.svg: ")) << result.err;
  EXPECT_TRUE(contains(result.err, '\n' + out + "/b.old.svg: ")) << result.err;
  EXPECT_EQ(read_whole(out + "/a.svg"), read_whole(alone));
  expect_drawing(out + "/b.old.svg", 30, 20);
}

TEST(TraceMany, a_bad_one_ends_no_other_and_shows_in_the_exit_code) {
  const TemporaryFolder folder;
  const std::string a = folder.add("a.png", disc_png()), bad = folder.add("bad.png", "hello");
  const std::string z = folder.add("z.png", disc_png()), out = folder.path("out");
  const std::string stats = folder.path("stats.json");
  const CommandResult result =
      run_sfumato({"trace", a, bad, z, "--out-dir", out, "--stats", stats, "--quiet"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.err, bad +
                            ": error: is not a picture; use a PNG, a JPEG or a WebP\n"
                            "sfumato: 1 of 3 pictures failed\n");
  EXPECT_TRUE(std::filesystem::exists(out + "/a.svg"));
  EXPECT_FALSE(std::filesystem::exists(out + "/bad.svg"));
  EXPECT_TRUE(std::filesystem::exists(out + "/z.svg"));
  const std::string text = read_whole(stats);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2);
  EXPECT_TRUE(text.starts_with("{\"input\":\"" + a + "\",\"curves\":")) << text;
}

TEST(TraceStatistics, are_one_object_that_tells_of_every_round) {
  const TemporaryFolder folder;
  const CommandResult result = trace(folder, disc_png(), {"--stats", "-", "--quiet"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::string number = "[-+.0-9e]+";
  const std::string state = "\"curves\":" + number + ",\"control_points\":" + number +
                            ",\"stops\":" + number + ",\"psnr_db\":(" + number + "|null)";
  const std::regex line("\\{" + state + ",\"scale\":" + number + ",\"noise\":" + number +
                        ",\"median_length_px\":" + number + ",\"curves_of_nine_tenths\":" + number +
                        ",\"threads\":" + number + ",\"rounds\":\\[(\\{\"round\":" + number + "," +
                        state + ",\"seconds\":" + number +
                        "\\},?)+\\],\"seconds\":\\{\"read\":" + number + ",\"trace\":" + number +
                        ",\"write\":" + number + ",\"total\":" + number + "\\}\\}\n");
  EXPECT_TRUE(std::regex_match(result.out, line)) << result.out;
}

/// Returns the elements of curves in an SVG.
Names curves_of(const std::string& svg) {
  const std::regex curve("<path[^>]*/>");
  return Names(std::sregex_token_iterator(svg.begin(), svg.end(), curve), {});
}

/// Returns the values of an attribute in the order of the text.
Names values_of(const std::string& text, const std::string& attribute) {
  const std::regex value(" " + attribute + "=\"[^\"]*\"");
  return Names(std::sregex_token_iterator(text.begin(), text.end(), value), {});
}

TEST(ColorsOnly, keeps_the_curves_of_a_drawing) {
  const TemporaryFolder folder;
  const std::string drawing = folder.add("scene.xml", two_curve_scene());
  const CommandResult result =
      trace(folder, png_of(disc(64, 48)), {"--colors-only", drawing, "--blur", "off"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::string svg = read_whole(folder.path("out.svg"));
  const std::string before = run_sfumato({"convert", drawing, "-o", "-"}).out;
  EXPECT_EQ(values_of(svg, "d").size(), 2u);
  EXPECT_EQ(values_of(svg, "d"), values_of(before, "d"));
}

TEST(ColorsOnly, the_named_curves_alone_are_fitted) {
  const TemporaryFolder folder;
  const std::string drawing = folder.add("scene.xml", two_curve_scene());
  const Names before = curves_of(run_sfumato({"convert", drawing, "-o", "-"}).out);
  const std::string picture = png_of(disc(64, 48));
  ASSERT_EQ(before.size(), 2u);
  for (const std::size_t chosen : {0u, 1u}) {
    const std::string only = "0:" + std::to_string(chosen);
    const CommandResult result =
        trace(folder, picture, {"--colors-only", drawing, "--only", only, "--blur", "off"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const Names after = curves_of(read_whole(folder.path("out.svg")));
    ASSERT_EQ(after.size(), 2u);
    EXPECT_NE(after[chosen], before[chosen]);
    EXPECT_EQ(after[1 - chosen], before[1 - chosen]);
  }
  ASSERT_EQ(trace(folder, picture, {"--colors-only", drawing, "--only", "0:1,0:0"}).exit_code, 0);
  const std::string both = read_whole(folder.path("out.svg"));
  ASSERT_EQ(trace(folder, picture, {"--colors-only", drawing}).exit_code, 0);
  EXPECT_EQ(both, read_whole(folder.path("out.svg")));
}

TEST(ColorsOnly, colours_can_be_kept_and_blur_alone_fitted) {
  const TemporaryFolder folder;
  const std::string drawing =
      folder.add("scene.svg",
                 "<svg xmlns='http://www.w3.org/2000/svg' xmlns:sf='urn:sfumato:1' "
                 "viewBox='0 0 64 48'><g sf:diffuse='true'><path d='M32 -9V57' "
                 "sf:left='#3c3c3c' sf:right='#bebebe' sf:blur='3'/></g></svg>");
  Image ramp{64, 48, PixelFormat::rgb8, {}};
  for (int i = 0; i < 64 * 48; ++i) {
    ramp.bytes.insert(ramp.bytes.end(), 3,
                      static_cast<std::uint8_t>(std::clamp(i % 64 * 10 - 190, 60, 190)));
  }
  const std::string before = run_sfumato({"convert", drawing, "-o", "-"}).out;
  const CommandResult result =
      trace(folder, png_of(ramp), {"--colors-only", drawing, "--keep-colors", "--only", "0:0"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::string after = read_whole(folder.path("out.svg"));
  for (const std::string kept : {"d", "sf:left", "sf:right"}) {
    EXPECT_FALSE(values_of(before, kept).empty()) << kept;
    EXPECT_EQ(values_of(after, kept), values_of(before, kept)) << kept;
  }
  EXPECT_EQ(values_of(before, "sf:blur"), (Names{" sf:blur=\"3\""}));
  EXPECT_NE(values_of(after, "sf:blur"), values_of(before, "sf:blur"));
}

TEST(ColorsOnly, a_curve_that_is_not_there_is_told_before_any_picture_is_read) {
  const TemporaryFolder folder;
  const std::string drawing = folder.add("scene.xml", two_curve_scene());
  for (const auto& [only, told] :
       {std::pair("0:0,0:2", "curve 2 in layer 0"), std::pair("1:0", "curve 0 in layer 1"),
        std::pair("0:4294967295", "curve 4294967295 in layer 0")}) {
    const CommandResult result =
        trace(folder, "no picture", {"--colors-only", drawing, "--only", only});
    EXPECT_EQ(result.exit_code, 1) << result.err;
    EXPECT_EQ(result.err, drawing + ": error: there is no " + told + " to be fitted\n");
    EXPECT_EQ(folder.names(), (Names{"in.png", "scene.xml"}));
  }
}

TEST(ColorsOnly, reads_the_drawing_from_standard_input) {
  const TemporaryFolder folder;
  const CommandResult result = run_sfumato({"trace", folder.add("in.png", png_of(disc(64, 48))),
                                            "-o", folder.path("out.svg"), "--colors-only", "-"},
                                           two_curve_scene());
  EXPECT_EQ(result.exit_code, 0) << result.err;
  expect_drawing(folder.path("out.svg"), 64, 48);
}

TEST(ColorsOnly, bad_drawings_are_told_before_any_picture_is_read) {
  const TemporaryFolder folder;
  const auto with_drawing = [&](const std::string& drawing) {
    return trace(folder, "no picture", {"--colors-only", drawing});
  };
  const CommandResult bad = with_drawing(folder.add("bad.svg", "<svg"));
  EXPECT_EQ(bad.exit_code, 1);
  EXPECT_TRUE(contains(bad.err, "bad.svg:1:")) << bad.err;
  const CommandResult missing = with_drawing(folder.path("none.svg"));
  EXPECT_EQ(missing.exit_code, 1);
  EXPECT_TRUE(contains(missing.err, "none.svg: error: cannot be read")) << missing.err;
  EXPECT_EQ(folder.names(), (Names{"bad.svg", "in.png"}));
}

TEST(ColorsOnly, a_drawing_without_colours_is_bad_input) {
  const TemporaryFolder folder;
  const std::string empty = folder.add("empty.svg",
                                       "<svg xmlns='http://www.w3.org/2000/svg' "
                                       "xmlns:sf='urn:sfumato:1' viewBox='0 0 9 9'/>");
  const CommandResult result = trace(folder, disc_png(), {"--colors-only", empty, "--quiet"});
  EXPECT_EQ(result.exit_code, 1) << result.err;
  EXPECT_EQ(folder.names(), (Names{"empty.svg", "in.png"}));
}

TEST(Trace, interrupt_ends_it_and_leaves_nothing) {
  if (!std::filesystem::exists("/proc/self/status")) GTEST_SKIP() << "this system has no /proc";
  const TemporaryFolder folder;
  Image noise{900, 900, PixelFormat::rgb8, {}};
  std::uint32_t state = 1;
  for (std::size_t i = 0; i < noise.row_bytes() * 900; ++i) {
    state = state * 1'664'525 + 1'013'904'223;
    noise.bytes.push_back(static_cast<std::uint8_t>(state >> 24));
  }
  const std::string input = folder.add("in.png", png_of(noise));
  RunningCommand command({sfumato_program(), "trace", input, "-o", folder.path("out.svg"),
                          "--points", "20000", "--seed", "99"},
                         "");
  command.wait_until_it_catches(SIGINT);
  std::this_thread::sleep_for(std::chrono::milliseconds(400));
  kill(command.id(), SIGINT);
  const CommandResult result = command.wait();
  EXPECT_EQ(result.exit_code, 130);
  EXPECT_EQ(result.err, "sfumato: interrupted\n");
  EXPECT_EQ(folder.names(), Names{"in.png"});
}

}  // namespace
}  // namespace sfumato::test
