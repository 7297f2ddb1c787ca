#include <gtest/gtest.h>

#include <filesystem>

#include "cli/run_command.hpp"
#include "cli/scenes.hpp"

namespace sfumato::test {
namespace {

/// Renders `scene` with these extra options and decodes the picture.
Image rendered(const std::string& scene, std::vector<std::string> options = {}) {
  options.insert(options.begin(), {"render", "-", "-o", "-"});
  const CommandResult result = run_sfumato(std::move(options), scene);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  return image_of(result.out);
}

std::vector<int> pixel(const Image& image, int x, int y) {
  const auto channels = static_cast<std::size_t>(channel_count(image.format));
  const std::size_t at =
      image.row_bytes() * static_cast<std::size_t>(y) + channels * static_cast<std::size_t>(x);
  return {image.bytes.begin() + static_cast<std::ptrdiff_t>(at),
          image.bytes.begin() + static_cast<std::ptrdiff_t>(at + channels)};
}

TEST(Render, inside_of_a_closed_curve_has_the_colour_of_its_inner_side) {
  const Image image = rendered(two_curve_scene());
  ASSERT_EQ(image.width, 64);
  ASSERT_EQ(image.height, 48);
  EXPECT_EQ(pixel(image, 20, 24), (std::vector<int>{255, 128, 0}));
}

TEST(Render, every_method_agrees_inside_of_a_closed_curve) {
  for (const char* method : {"exact", "rays", "pixels"}) {
    const Image image = rendered(two_curve_scene(), {"--method", method});
    ASSERT_EQ(image.width, 64) << method;
    EXPECT_EQ(pixel(image, 20, 24), (std::vector<int>{255, 128, 0})) << method;
  }
}

/// Returns the pixels of a part of an image.
std::vector<std::uint8_t> part_of(const Image& image, int x, int y, int width, int height) {
  const std::size_t pixel = image.row_bytes() / static_cast<std::size_t>(image.width);
  std::vector<std::uint8_t> part;
  for (int row = y; row < y + height; ++row) {
    const auto from = image.bytes.begin() + static_cast<std::ptrdiff_t>(
                                                image.row_bytes() * static_cast<std::size_t>(row) +
                                                pixel * static_cast<std::size_t>(x));
    part.insert(part.end(), from,
                from + static_cast<std::ptrdiff_t>(pixel * static_cast<std::size_t>(width)));
  }
  return part;
}

TEST(Render, a_window_has_the_pixels_of_the_whole_image) {
  const std::vector<std::vector<std::string>> ways = {{"--width", "700"},
                                                      {"--scale", "9", "--no-antialias"},
                                                      {"--width", "300", "--method", "pixels"}};
  for (std::vector<std::string> options : ways) {
    const Image whole = rendered(two_curve_scene(), options);
    options.insert(options.end(), {"--window", "101,77,150,90"});
    const Image window = rendered(two_curve_scene(), options);
    ASSERT_EQ(window.width, 150);
    ASSERT_EQ(window.height, 90);
    ASSERT_EQ(window.format, whole.format);
    EXPECT_EQ(window.bytes, part_of(whole, 101, 77, 150, 90)) << options[0];
  }
}

TEST(Render, a_window_may_be_one_of_an_image_that_is_too_large_to_be_drawn) {
  const Image window = rendered(two_curve_scene(), {"--width", "1000000", "--max-error", "off",
                                                    "--window", "312500,375000,40,30"});
  ASSERT_EQ(window.width, 40);
  EXPECT_EQ(pixel(window, 0, 0), (std::vector<int>{255, 128, 0}));
}

TEST(Render, a_window_outside_the_image_is_an_error) {
  const CommandResult result =
      run_sfumato({"render", "-", "-o", "-", "--window", "60,0,5,5"}, two_curve_scene());
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(
      result.err.find("a window of 5 x 5 pixels at (60, 0) that is not inside its image of 64 "
                      "x 48 pixels"),
      std::string::npos)
      << result.err;
}

TEST(Render, viewport_and_size_say_what_the_image_shows) {
  const Image zoomed = rendered(two_curve_scene(), {"--viewport", "18,20,4,3", "--scale", "8"});
  ASSERT_EQ(zoomed.width, 32);
  ASSERT_EQ(zoomed.height, 24);
  for (const int x : {0, 31}) {
    for (const int y : {0, 23}) EXPECT_EQ(pixel(zoomed, x, y), (std::vector<int>{255, 128, 0}));
  }
  const Image wide = rendered(two_curve_scene(), {"--width", "128"});
  EXPECT_EQ(wide.width, 128);
  EXPECT_EQ(wide.height, 96);
}

TEST(Render, depth_16_and_no_background_choose_the_format) {
  EXPECT_EQ(rendered(two_curve_scene()).format, PixelFormat::rgb8);
  EXPECT_EQ(rendered(two_curve_scene(), {"--depth", "16"}).format, PixelFormat::rgb16);
  EXPECT_EQ(rendered(two_curve_scene(), {"--background", "none"}).format, PixelFormat::rgba8);
  EXPECT_EQ(rendered(two_curve_scene(), {"--background", "none", "--depth", "16"}).format,
            PixelFormat::rgba16);
}

TEST(Render, background_is_any_opaque_colour_of_css_or_none_at_all) {
  const std::string empty = "<curve_set image_width='8' image_height='8'></curve_set>";
  const auto first = [&](const std::string& color) {
    return pixel(rendered(empty, {"--quiet", "--background", color}), 3, 3);
  };
  EXPECT_EQ(first("skyblue"), first("#87ceeb"));
  EXPECT_EQ(first("rgb(255 165 0)"), first("ORANGE"));
  EXPECT_EQ(first("hsl(120deg 100% 50%)"), first("lime"));
  EXPECT_EQ(first("oklch(0.7 0.15 250)"), first("#4ba3f7"));
  EXPECT_EQ(first("color(display-p3 0 1 0)"), first("#00fb29"));
  EXPECT_EQ(first("transparent"), first("none"));
  EXPECT_EQ(first("transparent")[3], 0);
}

TEST(Render, background_shows_where_no_curve_is) {
  const std::string empty = scene_xml(8, 8, "");
  EXPECT_EQ(pixel(rendered(empty, {"--quiet"}), 3, 3), (std::vector<int>{0, 0, 0, 0}));
  EXPECT_EQ(pixel(rendered(empty, {"--quiet", "--background", "#204060"}), 3, 3),
            (std::vector<int>{0x20, 0x40, 0x60}));
  EXPECT_EQ(pixel(rendered(empty, {"--quiet", "--background", "none"}), 3, 3)[3], 0);
}

/// Returns red inside a square, nothing outside, in a drawing of 8 × 8 units.
std::string square_svg(const std::string& attributes, const std::string& before = "") {
  return "<svg xmlns='http://www.w3.org/2000/svg' xmlns:sf='urn:sfumato:1' sf:version='1' "
         "viewBox='0 0 8 8' " +
         attributes + ">" + before +
         "<g sf:diffuse='true'><rect x='2' y='2' width='4' height='4' sf:left='none' "
         "sf:right='red'/></g></svg>";
}

TEST(Render, keeps_alpha_unless_a_background_is_asked_for_or_drawn) {
  const std::string bare = square_svg("width='16' height='16'");
  const std::string drawn =
      square_svg("width='16' height='16'", "<rect width='8' height='8' fill='lime'/>");
  const Image kept = rendered(bare);
  ASSERT_EQ(kept.format, PixelFormat::rgba8);
  ASSERT_EQ(kept.width, 16);
  EXPECT_EQ(pixel(kept, 0, 0)[3], 0);
  EXPECT_EQ(pixel(kept, 8, 8), (std::vector<int>{255, 0, 0, 255}));
  EXPECT_EQ(pixel(rendered(bare, {"--background", "blue"}), 0, 0), (std::vector<int>{0, 0, 255}));
  EXPECT_EQ(pixel(rendered(drawn), 0, 0), (std::vector<int>{0, 255, 0}));
  EXPECT_EQ(pixel(rendered(drawn, {"--background", "blue"}), 0, 0), (std::vector<int>{0, 0, 255}));
  const Image none = rendered(drawn, {"--background", "none"});
  ASSERT_EQ(none.format, PixelFormat::rgba8);
  EXPECT_EQ(pixel(none, 0, 0)[3], 0);
  EXPECT_EQ(rendered(bare, {"--depth", "16"}).format, PixelFormat::rgba16);
  EXPECT_EQ(rendered(bare, {"--viewport", "3,3,2,2"}).format, PixelFormat::rgb8);
}

TEST(Render, has_the_size_that_the_drawing_says) {
  EXPECT_EQ(rendered(square_svg("width='32' height='24'")).width, 32);
  EXPECT_EQ(rendered(square_svg("width='32' height='24'")).height, 24);
  EXPECT_EQ(rendered(square_svg("width='1in'")).height, 96);
  EXPECT_EQ(rendered(square_svg("width='1in'"), {"--scale", "2"}).width, 16);
  EXPECT_EQ(
      rendered(square_svg("width='20' height='40' preserveAspectRatio='none'"), {"--width", "10"})
          .height,
      20);
}

TEST(Render, overlay_order_blur_and_dither_options_are_taken) {
  const Image plain = rendered(two_curve_scene(), {"--scale", "4"});
  EXPECT_NE(rendered(two_curve_scene(), {"--scale", "4", "--mesh-overlay"}).bytes, plain.bytes);
  EXPECT_NE(rendered(two_curve_scene(), {"--scale", "4", "--no-antialias"}).bytes, plain.bytes);
  EXPECT_NE(rendered(two_curve_scene(), {"--scale", "4", "--no-dither"}).bytes, plain.bytes);
  EXPECT_EQ(rendered(two_curve_scene(), {"--scale", "4", "--dither"}).bytes, plain.bytes);
  EXPECT_NE(rendered(two_curve_scene(), {"--scale", "4", "--order", "linear"}).bytes, plain.bytes);
  EXPECT_EQ(rendered(two_curve_scene(), {"--scale", "4", "--no-blur"}).bytes, plain.bytes);
}

TEST(Render, sixteen_bits_are_solved_more_finely) {
  const std::string scene = busy_scene(30);
  const Image deep = rendered(scene, {"--depth", "16"});
  EXPECT_EQ(rendered(scene, {"--depth", "16", "--max-error", "0.25"}).bytes, deep.bytes);
  EXPECT_NE(rendered(scene, {"--depth", "16", "--max-error", "1"}).bytes, deep.bytes);
}

TEST(Render, gives_the_same_bytes_for_any_number_of_threads) {
  const std::string scene = busy_scene(30);
  const std::vector<std::vector<std::string>> cases = {{"--method", "exact"},
                                                       {"--method", "rays", "--rays", "16"},
                                                       {"--method", "pixels", "--scale", "0.5"}};
  for (const std::vector<std::string>& options : cases) {
    const auto with_threads = [&](const char* count) {
      std::vector<std::string> arguments = {"render", "-", "-o", "-", "--threads", count};
      arguments.insert(arguments.end(), options.begin(), options.end());
      return run_sfumato(arguments, scene);
    };
    const CommandResult one = with_threads("1");
    ASSERT_EQ(one.exit_code, 0) << one.err;
    for (const char* count : {"2", "3", "8"}) {
      EXPECT_TRUE(with_threads(count).out == one.out) << options[1] << " with " << count;
    }
  }
}

TEST(Render, gives_the_same_bytes_to_a_file_and_to_stdout) {
  const TemporaryFolder folder;
  const std::string input = folder.add("scene.xml", two_curve_scene());
  const CommandResult to_file = run_sfumato({"render", input, "-o", folder.path("out.png")});
  ASSERT_EQ(to_file.exit_code, 0) << to_file.err;
  EXPECT_EQ(to_file.out, "");
  const CommandResult to_stdout = run_sfumato({"render", "-", "-o", "-"}, two_curve_scene());
  EXPECT_TRUE(to_stdout.out == read_whole(folder.path("out.png")));
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"out.png", "scene.xml"}));
}

TEST(Render, seed_changes_random_rays_and_nothing_else) {
  const auto with_seed = [](const char* method, const char* seed) {
    return run_sfumato({"render", "-", "-o", "-", "--method", method, "--rays", "16", "--max-error",
                        "off", "--seed", seed},
                       busy_scene(20))
        .out;
  };
  EXPECT_TRUE(with_seed("rays", "1") == with_seed("rays", "1"));
  EXPECT_FALSE(with_seed("rays", "1") == with_seed("rays", "2"));
  EXPECT_TRUE(with_seed("exact", "1") == with_seed("exact", "2"));
}

TEST(Render, refinement_makes_more_triangles_and_is_the_same_for_rays) {
  const auto triangle_count = [](std::vector<std::string> options) {
    const TemporaryFolder folder;
    // With 8 bits exact pictures have a mesh of their own.
    options.insert(options.begin(),
                   {"render", "-", "-o", folder.path("out.png"), "--stats", "-", "--depth", "16"});
    return number_after(run_sfumato(options, two_curve_scene()).out, "triangles");
  };
  const double refined = triangle_count({});
  EXPECT_GT(refined, triangle_count({"--max-error", "off"}));
  EXPECT_EQ(refined, triangle_count({"--method", "rays"}));
}

TEST(Stats, have_every_member_and_add_up) {
  const TemporaryFolder folder;
  const CommandResult result = run_sfumato({"render", "-", "-o", folder.path("out.png"), "--stats",
                                            folder.path("stats.json"), "--threads", "3"},
                                           two_curve_scene());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::string json = read_whole(folder.path("stats.json"));
  EXPECT_EQ(number_after(json, "curves"), 2);
  EXPECT_EQ(number_after(json, "threads"), 3);
  EXPECT_GE(number_after(json, "segments"), 3);
  for (const char* key : {"triangles", "vertices", "nodes"}) EXPECT_GT(number_after(json, key), 0);
  double sum = 0;
  for (const char* key : {"read", "geometry", "triangulation", "gather", "rasterise", "write"}) {
    EXPECT_GE(number_after(json, key), 0) << key;
    sum += number_after(json, key);
  }
  EXPECT_LE(sum, number_after(json, "total") + 1e-8);  // each is rounded to a nanosecond
}

TEST(Stats, go_to_stdout_for_a_dash) {
  const TemporaryFolder folder;
  const CommandResult result =
      run_sfumato({"render", "-", "-o", folder.path("out.png"), "--stats", "-"}, two_curve_scene());
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(result.out.starts_with("{\"curves\":2,"));
  EXPECT_TRUE(result.out.ends_with("}}\n"));
}

TEST(TextWarnings, name_their_place_and_are_silenced_by_quiet) {
  const std::string scene = scene_xml(64, 48, "<banana/>\n");
  const CommandResult loud = run_sfumato({"render", "-", "-o", "-"}, scene);
  EXPECT_EQ(loud.exit_code, 0);
  EXPECT_TRUE(loud.err.starts_with("<stdin>:3:1: warning: ")) << loud.err;
  EXPECT_NE(loud.err.find("banana"), std::string::npos);
  const CommandResult quiet = run_sfumato({"render", "-", "-o", "-", "--quiet"}, scene);
  EXPECT_EQ(quiet.err, "");
  EXPECT_TRUE(quiet.out == loud.out);
}

}  // namespace
}  // namespace sfumato::test
