#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "cli/run_command.hpp"
#include "cli/scenes.hpp"
#include "support/places.hpp"

namespace sfumato::test {
namespace {

using Arguments = std::vector<std::string>;

/// Returns a canvas of 64 × 48 with a curve of these colours.
std::string frame_scene(const std::string& left, int width = 64) {
  const std::string points =
      point_xml("8", "24") + point_xml("24", "4") + point_xml("40", "44") + point_xml("56", "24");
  return scene_xml(width, 48, curve_xml(points, left, R"(B="32" G="64" R="192")"));
}

/// Three drawings of one size with different pictures.
class Films : public testing::Test {
 protected:
  Films() {
    for (const char* color :
         {R"(B="255" G="0" R="0")", R"(B="0" G="255" R="0")", R"(B="255" G="255" R="255")"}) {
      drawings_.push_back(
          folder_.add("d" + std::to_string(drawings_.size()) + ".xml", frame_scene(color)));
    }
  }

  static Arguments call(const Arguments& drawings, const Arguments& options) {
    Arguments arguments{"render"};
    arguments.insert(arguments.end(), drawings.begin(), drawings.end());
    arguments.insert(arguments.end(), options.begin(), options.end());
    return arguments;
  }
  CommandResult render(const Arguments& options) const {
    return run_sfumato(call(drawings_, options));
  }
  /// Returns the pixels of each drawing's own PNG, one after the other; 16-bit values have the low
  /// byte first.
  std::string pixels(const Arguments& options, PixelFormat format) const {
    std::string all;
    for (const std::string& drawing : drawings_) {
      const std::string png = folder_.path("one.png");
      EXPECT_EQ(run_sfumato(call({drawing, "-o", png}, options)).exit_code, 0);
      const Image image = image_of(read_whole(png));
      EXPECT_EQ(image.format, format);
      all.append(image.bytes.begin(), image.bytes.end());
    }
    return all;
  }
  /// Runs a shell script whose "$@" is the call.
  CommandResult render_by_shell(const std::string& script, const Arguments& options) const {
    Arguments arguments{"/bin/sh", "-c", script, "sh", sfumato_program()};
    const Arguments rest = call(drawings_, options);
    arguments.insert(arguments.end(), rest.begin(), rest.end());
    return run_command(arguments);
  }

  TemporaryFolder folder_;
  Arguments drawings_;
};

TEST_F(Films, frames_are_the_pixels_of_the_pictures_in_the_order_given) {
  const CommandResult piped = render({"-o", "-", "--format", "rgb24", "--background", "white"});
  EXPECT_EQ(piped.exit_code, 0);
  EXPECT_EQ(piped.err,
            "sfumato: note: for ffmpeg: -f rawvideo -pixel_format rgb24 -video_size 64x48\n");
  EXPECT_EQ(piped.out.size(), 3u * 64 * 48 * 3);
  EXPECT_EQ(piped.out, pixels({"--background", "white"}, PixelFormat::rgb8));
  const std::string file = folder_.path("film.RGB24");
  const CommandResult quiet = render({"-o", file, "--background", "white", "--quiet"});
  EXPECT_EQ(quiet.err, "");
  EXPECT_EQ(read_whole(file), piped.out);
}

TEST_F(Films, frames_of_16_bits_have_their_low_byte_first) {
  const std::string file = folder_.path("film.rgb48le");
  ASSERT_EQ(render({"-o", file, "--background", "#102030"}).exit_code, 0);
  EXPECT_EQ(read_whole(file),
            pixels({"--background", "#102030", "--depth", "16"}, PixelFormat::rgb16));
}

TEST_F(Films, frames_without_alpha_stand_on_white_and_others_always_have_it) {
  drawings_.front() = folder_.add(
      "half.svg",
      R"(<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 64 48"
 sf:version="1"><g sf:diffuse="true"><path d="M8 24 L56 24" sf:left="#f00" sf:right="#00f"
 sf:opacity=".5"/></g></svg>)");
  const CommandResult white = render({"-o", "-", "--format", "rgb24"});
  EXPECT_EQ(white.out, render({"-o", "-", "--format", "rgb24", "--background", "white"}).out);
  for (const auto& [format, bytes] : {std::pair("rgba", 4u), std::pair("rgba64le", 8u)}) {
    const CommandResult opaque = render({"-o", "-", "--format", format, "--background", "white"});
    ASSERT_EQ(opaque.out.size(), std::size_t{3} * 64 * 48 * bytes) << format;
    for (std::size_t i = bytes - 1; i < opaque.out.size(); i += bytes)
      ASSERT_EQ(opaque.out[i], '\xff') << format;
    const std::string half = render({"-o", "-", "--format", format}).out;
    ASSERT_EQ(half.size(), opaque.out.size());
    EXPECT_NEAR(static_cast<unsigned char>(half[bytes - 1]), 128, 1) << "of the first drawing";
  }
}

TEST_F(Films, shards_are_runs_that_make_the_film_one_behind_the_other) {
  const std::string whole = render({"-o", "-", "--format", "rgba"}).out;
  std::string parts;
  for (int i = 0; i < 4; ++i) {
    const std::string part = folder_.path("part.rgba");
    const CommandResult result = render({"-o", part, "--shard", std::to_string(i) + "/4"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    parts += read_whole(part);  // empty if fewer than three drawings suffice
  }
  EXPECT_EQ(parts, whole);
}

TEST_F(Films, a_frame_of_another_size_ends_the_film) {
  drawings_.insert(drawings_.begin() + 2,
                   folder_.add("wide.xml", frame_scene(R"(B="0" G="255" R="0")", 70)));
  const std::string file = folder_.path("film.rgba");
  const CommandResult result = render({"-o", file});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_TRUE(contains(result.err, drawings_[2] +
                                       ": error: the frame has 70x48 pixels, but the "
                                       "first, " +
                                       drawings_[0] + ", 64x48"))
      << result.err;
  EXPECT_TRUE(contains(result.err, "sfumato: the film ends after 2 of 4 frames\n")) << result.err;
  EXPECT_EQ(std::filesystem::file_size(file), 2u * 64 * 48 * 4);
  EXPECT_EQ(render({"-o", file, "--width", "64", "--height", "48"}).exit_code, 0);
  EXPECT_EQ(std::filesystem::file_size(file), 4u * 64 * 48 * 4);
}

TEST_F(Films, a_drawing_that_fails_ends_the_film_after_the_frames_before_it) {
  drawings_[1] = folder_.add("bad.xml", "<curve_set");
  const std::string file = folder_.path("film.rgb24");
  const CommandResult result = render({"-o", file});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_TRUE(contains(result.err, drawings_[1] + ":1:")) << result.err;
  EXPECT_TRUE(contains(result.err, "the film ends after 1 of 3 frames")) << result.err;
  EXPECT_EQ(std::filesystem::file_size(file), 64u * 48 * 3);
}

TEST_F(Films, a_reader_that_goes_away_is_an_error_of_the_pipe) {
  const CommandResult result = render_by_shell("{ \"$@\"; echo $? >&2; } | head -c 10",
                                               {"-o", "-", "--format", "rgb24", "--width", "640"});
  EXPECT_TRUE(contains(result.err, "standard output: error: cannot be written: Broken pipe\n"))
      << result.err;
  EXPECT_TRUE(contains(result.err, "frames\n3\n")) << result.err;
  EXPECT_EQ(result.out.size(), 10u);
}

TEST_F(Films, a_full_disk_leaves_whole_frames) {
  const std::string file = folder_.path("film.rgb24");
  // Blocks of 512 bytes: a frame has 18 of them.
  const CommandResult result = render_by_shell("ulimit -f 40; exec \"$@\"", {"-o", file});
  EXPECT_EQ(result.exit_code, 3) << result.err;
  EXPECT_TRUE(contains(result.err, "the film ends after 2 of 3 frames")) << result.err;
  EXPECT_EQ(std::filesystem::file_size(file), 2u * 64 * 48 * 3);
}

TEST_F(Films, go_through_a_named_pipe) {
  const std::string pipe = folder_.path("film.rgba"), out = folder_.path("out");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  RunningCommand reader({"/bin/sh", "-c", "cat '" + pipe + "' >'" + out + "'"}, {});
  EXPECT_EQ(render({"-o", pipe}).exit_code, 0);
  EXPECT_EQ(reader.wait().exit_code, 0);
  EXPECT_EQ(read_whole(out), render({"-o", "-", "--format", "rgba"}).out);
}

TEST_F(Films, options_that_have_no_place_are_named) {
  const std::string file = folder_.path("film.rgb24");
  const std::pair<Arguments, const char*> cases[] = {
      {{"-o", file, "--depth", "16"}, "rgb48le and rgba64le only"},
      {{"-o", file, "--background", "none"}, "use an opaque colour, or rgba or rgba64le"},
      {{"-o", file, "--newer-only"}, "--out-dir only"},
      {{"-o", file, "--quality", "80"}, "JPEG and lossy WebP only"},
      {{"-o", file, "--format", "rgb24"}, "the extension of OUT sets the format"},
      {{"-o", drawings_[0]}, "use a file name that ends in"},
      {{"-o", folder_.path("film.rgb48le"), "--dither"}, "--depth 8 only"},
      {{"-o", "-", "--format", "rgb24", "--stats", "-"}, "stdout is taken"},
  };
  for (const auto& [options, expected] : cases) {
    const CommandResult result = render(options);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_TRUE(contains(result.err, expected)) << result.err;
  }
  EXPECT_FALSE(std::filesystem::exists(file));
  const CommandResult watched = run_sfumato({"watch", drawings_[0], "-o", file});
  EXPECT_EQ(watched.exit_code, 2);
}

TEST_F(Films, in_a_folder_each_frame_is_a_file) {
  const std::string out = folder_.path("out");
  ASSERT_EQ(render({"--out-dir", out, "--format", "rgba"}).exit_code, 0);
  const std::string all =
      read_whole(out + "/d0.rgba") + read_whole(out + "/d1.rgba") + read_whole(out + "/d2.rgba");
  EXPECT_EQ(all, render({"-o", "-", "--format", "rgba"}).out);
}

/// Returns a circle that moves above a still house, with an enclosed pond.
std::string moving_scene(int frame) {
  const std::string x = std::to_string(10 + 4 * frame);
  return R"(<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 64 48"
 sf:version="1"><g sf:diffuse="true"><rect x="1" y="1" width="62" height="46" sf:left="#246"
 sf:right="#fda"/><circle cx="20" cy="32" r="9" sf:left="#264" sf:right="#28c, #8df, #28c"/>
<circle cx=")" +
         x + R"(" cy="12" r="5" sf:left="#fff" sf:right="#f80" sf:blur="1"/></g></svg>)";
}

class CoherentFilms : public Films {
 protected:
  CoherentFilms() {
    drawings_.clear();
    for (int i = 0; i < 6; ++i) {
      drawings_.push_back(folder_.add("f" + std::to_string(i) + ".svg", moving_scene(i)));
    }
  }
  /// Returns how the layers of the frames were made, from the statistics.
  Arguments layers(const Arguments& options) const {
    const std::string stats = folder_.path("stats.json");
    Arguments given = options;
    given.insert(given.end(), {"--coherent", "--stats", stats, "--quiet"});
    const CommandResult result = render(given);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    Arguments found;
    const std::string text = read_whole(stats), key = "\"layers\":";
    for (std::size_t at = 0; (at = text.find(key, at)) != std::string::npos;) {
      at += key.size();
      found.push_back(text.substr(at, text.find('}', at) + 1 - at));
    }
    return found;
  }
};

constexpr const char* kBegun = R"({"kept":0,"continued":0,"begun":1})";
constexpr const char* kContinued = R"({"kept":0,"continued":1,"begun":0})";
constexpr const char* kKept = R"({"kept":1,"continued":0,"begun":0})";

TEST_F(CoherentFilms, keep_the_pixels_of_what_does_not_move) {
  const std::string file = folder_.path("film.rgb24");
  EXPECT_EQ(layers({"-o", file}),
            (Arguments{kBegun, kContinued, kContinued, kContinued, kContinued, kContinued}));
  const std::string film = read_whole(file);
  const std::size_t frame = 64 * 48 * 3;
  ASSERT_EQ(film.size(), 6 * frame);
  for (std::size_t f = 1; f < 6; ++f) {
    int within = 0, anywhere = 0;
    for (std::size_t i = 0; i < frame; ++i) {
      const int difference = std::abs(static_cast<unsigned char>(film[f * frame + i]) -
                                      static_cast<unsigned char>(film[i]));
      const double x = static_cast<double>(i / 3 % 64) + 0.5 - 20,
                   y = static_cast<double>(i / 3 / 64) + 0.5 - 32;
      anywhere = std::max(anywhere, difference);
      if (x * x + y * y < 8 * 8) within = std::max(within, difference);
    }
    EXPECT_LE(within, 1) << f;
    EXPECT_GT(anywhere, 20) << f;
  }
}

TEST_F(CoherentFilms, of_files_have_the_same_pixels_and_shards_are_runs) {
  const std::string out = folder_.path("out"), film = folder_.path("film.rgba");
  layers({"-o", film});
  EXPECT_EQ(layers({"--out-dir", out, "--format", "rgba"}).size(), 6u);
  std::string all;
  for (int i = 0; i < 6; ++i) all += read_whole(out + "/f" + std::to_string(i) + ".rgba");
  EXPECT_EQ(all, read_whole(film));
  EXPECT_EQ(layers({"--out-dir", folder_.path("part"), "--shard", "1/2"}),
            (Arguments{kBegun, kContinued, kContinued}));
  EXPECT_EQ(names_in(folder_.path("part")), (Arguments{"f3.png", "f4.png", "f5.png"}));
}

TEST_F(CoherentFilms, begin_anew_where_a_drawing_has_other_curves) {
  drawings_[1] = drawings_[0] + ".copy.svg";
  folder_.add("f0.svg.copy.svg", moving_scene(0));
  folder_.add("f3.svg", R"(<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1"
 viewBox="0 0 64 48" sf:version="1"><g sf:diffuse="true"><circle cx="20" cy="32" r="9"
 sf:left="#264" sf:right="#28c"/></g></svg>)");
  EXPECT_EQ(layers({"-o", folder_.path("film.rgb24")}),
            (Arguments{kBegun, kKept, kContinued, kBegun, kBegun, kContinued}));
}

TEST_F(CoherentFilms, that_fail_in_the_middle_go_on_after_that) {
  folder_.add("f2.svg", "<svg");
  const std::string stats = folder_.path("stats.json"), out = folder_.path("out");
  const CommandResult result = render({"--out-dir", out, "--coherent", "--stats", stats});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_TRUE(contains(result.err, "sfumato: 1 of 6 drawings failed")) << result.err;
  EXPECT_TRUE(std::filesystem::exists(out + "/f5.png"));
}

TEST_F(CoherentFilms, need_many_drawings_and_a_mesh) {
  const std::pair<Arguments, const char*> cases[] = {
      {{"-o", folder_.path("a.png")}, "--out-dir"},
      {{"-o", folder_.path("a.rgba"), "--method", "pixels"}, "--coherent: works with"},
      {{"-o", folder_.path("a.rgba"), "--method", "rays"}, "--coherent: works with"},
  };
  for (const auto& [options, expected] : cases) {
    Arguments given = options;
    given.push_back("--coherent");
    const CommandResult result = render(given);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_TRUE(contains(result.err, expected)) << result.err;
  }
  EXPECT_EQ(
      run_sfumato({"render", drawings_[0], "-o", folder_.path("a.png"), "--coherent"}).exit_code,
      2);
}

}  // namespace
}  // namespace sfumato::test
