// SVG as a text, and in other programs.
#include "sfumato/export/svg/svg.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

#include "codecs/base64.hpp"
#include "export/support.hpp"
#include "raster/pictures.hpp"
#include "sfumato/base/limits.hpp"
#include "sfumato/codecs/png.hpp"
#include "support/drawing.hpp"
#include "support/scenes.hpp"

namespace sfumato {
namespace {

std::string svg_of(const Picture& picture, const SvgOptions& options = {},
                   ExportNotes* notes = nullptr) {
  Context context;
  const auto svg = export_svg(context, picture, options, notes);
  EXPECT_TRUE(svg) << to_string(svg.status());
  EXPECT_EQ(context.budget.used(), 0u);
  return svg ? std::string(svg->begin(), svg->end()) : std::string();
}

SvgOptions vector_options() {
  SvgOptions options;
  options.mode = SvgMode::vector;
  return options;
}

LocalStroke stroke() {
  LocalStroke stroke;
  stroke.curve.control_points = test::straight_curve({20, 30}, {80, 30}).control_points;
  stroke.curve.left_color.stops = {{0, test::kRed}};
  stroke.curve.right_color.stops = {{0, test::kBlue}};
  stroke.curve.influence_radius.stops = {{0, 8.0f}};
  return stroke;
}

/// Compares a program's view of an SVG with our raster. The limits are a third above the measured
/// values.
void expect_shown(const std::string& command, const Document& document, const SvgOptions& options,
                  double mean, int p99) {
  const Picture picture = test::solved(document);
  Context context;
  const auto svg = export_svg(context, picture, options);
  ASSERT_TRUE(svg) << to_string(svg.status());
  const auto image = test::shown_by(*svg, "a.svg", command);
  ASSERT_TRUE(image);
  const auto found =
      test::difference(*image, test::reference(picture, image->width, image->height));
  EXPECT_LE(found.mean, mean) << command;
  EXPECT_LE(found.p99, p99) << command;
}

void expect_shown(const std::string& command, const std::string& example, const SvgOptions& options,
                  double mean, int p99) {
  const auto document = test::example(example);
  ASSERT_TRUE(document);
  expect_shown(command, *document, options, mean, p99);
}

TEST(SvgImage, is_the_raster_in_user_units) {
  Picture picture = test::make_picture(test::flat_layer(test::kWideBox, {0.2f, 0.4f, 0.6f}));
  SvgOptions options;
  options.dpi = 192;
  const std::string text = svg_of(picture, options);
  EXPECT_NE(text.find("width=\"100\" height=\"60\" viewBox=\"0 0 100 60\""), std::string::npos);
  const std::string mark = "xlink:href=\"data:image/png;base64,";
  const std::size_t begin = text.find(mark) + mark.size();
  const std::string coded = text.substr(begin, text.find('"', begin) - begin);
  Context context;
  TableMemory memory("a test");
  std::vector<std::uint8_t> png;
  ASSERT_TRUE(codecs::decode_base64(context, coded, memory, png));
  const auto image = decode_png(context, png, "png");
  ASSERT_TRUE(image);
  EXPECT_EQ(image->width, 200);
  EXPECT_EQ(image->height, 120);
  EXPECT_EQ(image->format, PixelFormat::rgba8);
  EXPECT_EQ(image->bytes[0], 51);
  EXPECT_EQ(image->bytes[3], 255);
}

TEST(SvgImage, has_no_alpha_on_a_background) {
  Picture picture = test::make_picture(test::flat_layer(test::kWideBox, {0.2f, 0.4f, 0.6f}, 0.5f));
  const std::size_t with_alpha = svg_of(picture).size();
  SvgOptions options;
  options.background = Rgb{1, 1, 1};
  EXPECT_NE(svg_of(picture, options), svg_of(picture));
  picture.background = Rgb{1, 1, 1};
  EXPECT_EQ(svg_of(picture), svg_of(picture, options));
  EXPECT_LE(svg_of(picture).size(), with_alpha);
}

TEST(SvgVector, a_flat_layer_has_no_gradients) {
  const Picture picture = test::make_picture(test::flat_layer(test::kWideBox, {0.2f, 0.4f, 0.6f}));
  ExportNotes notes;
  const std::string text = svg_of(picture, vector_options(), &notes);
  EXPECT_EQ(notes.triangle_count, 8u);
  EXPECT_TRUE(notes.lost.empty());
  EXPECT_EQ(test::count(text, "<path"), 3 * 8u);
  EXPECT_EQ(test::count(text, "<linearGradient"), 4u);  // the elements with the stops
}

TEST(SvgVector, each_channel_has_its_own_mesh) {
  const Picture picture = test::make_picture(test::flat_layer(test::kWideBox, {0.2f, 0.4f, 0.8f}));
  const std::string text = svg_of(picture, vector_options());
  EXPECT_EQ(test::count(text, "fill=\"#300\""), 8u);
  EXPECT_EQ(test::count(text, "fill=\"#060\""), 8u);
  EXPECT_EQ(test::count(text, "fill=\"#00c\""), 8u);
  EXPECT_EQ(test::count(text, "<g style=\"mix-blend-mode:screen\">"), 2u);
}

TEST(SvgVector, a_layer_is_stored_once) {
  Picture picture = test::make_picture(test::flat_layer(test::kWideBox, {0.2f, 0.4f, 0.6f}, 0.5f));
  const std::size_t one = svg_of(picture, vector_options()).size();
  for (int i = 0; i < 9; ++i) {
    picture.stack.push_back(PatchInstance{0, {0.5, 0, 0, 0.5, 3.0 * i, 5}, 1, BlendMode::normal});
  }
  const std::string text = svg_of(picture, vector_options());
  EXPECT_EQ(test::count(text, "<use "), 10u);
  EXPECT_LT(text.size(), one + 1000);
}

TEST(SvgVector, composites_as_the_picture_does) {
  Picture picture = test::make_picture(test::flat_layer(test::kWideBox, {0.2f, 0.4f, 0.6f}));
  picture.stack = {PatchInstance{},
                   GroupBegin{0.5f, BlendMode::multiply},
                   PatchInstance{0, {}, 0.25f, BlendMode::color_dodge},
                   GroupEnd{},
                   GroupBegin{},
                   GroupEnd{}};
  picture.background = test::kRed;
  const std::string text = svg_of(picture, vector_options());
  EXPECT_NE(text.find("<g opacity=\"0.5\" style=\"mix-blend-mode:multiply\">\n"
                      "<use xlink:href=\"#L0\" opacity=\"0.25\" "
                      "style=\"mix-blend-mode:color-dodge\"/>\n</g>\n"
                      "<g style=\"isolation:isolate\">\n</g>\n"),
            std::string::npos);
  EXPECT_NE(text.find("<rect x=\"0\" y=\"0\" width=\"100\" height=\"60\" fill=\"#ff0000\"/>"),
            std::string::npos);
}

TEST(SvgVector, strokes_in_a_row_are_one_image) {
  Picture picture = test::make_picture(test::flat_layer(test::kWideBox, {0.2f, 0.4f, 0.6f}));
  picture.stack = {stroke(), stroke(), PatchInstance{}, stroke()};
  ExportNotes notes;
  const std::string text = svg_of(picture, vector_options(), &notes);
  EXPECT_EQ(test::count(text, "<image "), 2u);
  EXPECT_LT(text.find("<image "), text.find("<use "));
  EXPECT_EQ(notes.lost.size(), 1u);
  // Its pixels end at the layer's border.
  EXPECT_NE(text.find("<image x=\"11\" y=\"21\" width=\"78\" height=\"18\""), std::string::npos);
}

TEST(SvgVector, nothing_at_all_is_a_file_too) {
  Picture picture;
  picture.artboard = picture.viewport = test::kWideBox;
  const std::string text = svg_of(picture, vector_options());
  EXPECT_TRUE(text.ends_with("viewBox=\"0 0 100 60\">\n</svg>\n")) << text;
  picture.stack.push_back(PatchInstance{});
  picture.layers.emplace_back();
  picture.layers[0].color.channel_count = 3;
  EXPECT_EQ(svg_of(picture, vector_options()), text);
}

TEST(SvgVector, values_that_are_no_numbers_are_not_written) {
  Picture picture = test::make_picture(test::flat_layer(test::kWideBox, {0.2f, 0.4f, 0.6f}, 0.5f));
  picture.layers[0].color.node_value[4] = std::numeric_limits<float>::quiet_NaN();
  picture.layers[0].color.node_value[7] = std::numeric_limits<float>::infinity();
  picture.layers[0].opacity.node_value[2] = -std::numeric_limits<float>::infinity();
  const std::string text = svg_of(picture, vector_options());
  EXPECT_EQ(text.find("nan"), std::string::npos);
  EXPECT_EQ(text.find("inf"), std::string::npos);
}

TEST(SvgVector, too_many_triangles_are_refused_unless_forced) {
  const test::RegionMesh mesh = test::jittered_grid(test::kWideBox, 40, 3);
  Picture picture = test::make_picture(test::make_layer(mesh, [](int, Vec2) {
    return Rgb{0.2f, 0.4f, 0.6f};
  }));
  picture.stack.assign(limits::kSvgTriangles / 3200 + 1, PatchInstance{});
  Context context;
  const auto refused = export_svg(context, picture, vector_options());
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.status().code, StatusCode::limit);
  EXPECT_NE(refused.status().message.find("40000"), std::string::npos);
  SvgOptions forced = vector_options();
  forced.force = true;
  ExportNotes notes;
  EXPECT_FALSE(svg_of(picture, forced, &notes).empty());
  ASSERT_EQ(notes.lost.size(), 1u);
  EXPECT_NE(notes.lost[0].find("slow"), std::string::npos);
}

TEST(Svg, options_and_pictures_that_mean_nothing_are_errors) {
  Context context;
  Picture picture = test::make_picture(test::flat_layer(test::kWideBox, test::kRed));
  SvgOptions options;
  options.dpi = 0;
  EXPECT_EQ(export_svg(context, picture, options).status().code, StatusCode::bad_input);
  options = {.scale = -1, .dpi = -96};
  EXPECT_EQ(export_svg(context, picture, options).status().code, StatusCode::bad_input);
  options = {};
  options.dpi = 1e9;
  EXPECT_EQ(export_svg(context, picture, options).status().code, StatusCode::limit);
  options = {};
  options.max_error = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(export_svg(context, picture, options).status().code, StatusCode::bad_input);
  picture.viewport = {{0, 0}, {0, 10}};
  EXPECT_EQ(export_svg(context, picture, {}).status().code, StatusCode::bad_input);
  EXPECT_EQ(export_svg(context, Picture{}, vector_options()).status().code, StatusCode::bad_input);
}

TEST(Svg, stops_when_it_is_cancelled_or_out_of_memory) {
  const Picture picture = test::make_picture(test::flat_layer(test::kWideBox, test::kRed));
  for (const SvgMode mode : {SvgMode::image, SvgMode::vector}) {
    SvgOptions options;
    options.mode = mode;
    Context cancelled;
    cancelled.cancel = true;
    EXPECT_EQ(export_svg(cancelled, picture, options).status().code, StatusCode::cancelled);
    Context poor{.budget = Budget(100)};
    EXPECT_EQ(export_svg(poor, picture, options).status().code, StatusCode::limit);
  }
}

TEST(SvgInPrograms, librsvg_shows_triangles_as_we_do) {
  if (!test::has_program("rsvg-convert")) GTEST_SKIP() << "no rsvg-convert here";
  SvgOptions options = vector_options();
  options.dpi = 96;
  options.force = true;
  expect_shown("rsvg-convert IN -o OUT", "apple.svg", options, 0.6, 4);
  expect_shown("rsvg-convert IN -o OUT", "blur.svg", options, 0.8, 6);
  expect_shown("rsvg-convert IN -o OUT", "strokes.svg", options, 0.4, 3);
}

TEST(SvgInPrograms, triangles_of_one_colour_have_no_seams) {
  if (!test::has_program("rsvg-convert")) GTEST_SKIP() << "no rsvg-convert here";
  const test::RegionMesh mesh = test::jittered_grid(test::kWideBox, 12, 5);
  const Picture picture = test::make_picture(test::make_layer(mesh, [](int, Vec2) {
    return Rgb{0.2f, 0.4f, 0.8f};
  }));
  Context context;
  const auto svg = export_svg(context, picture, vector_options());
  ASSERT_TRUE(svg);
  for (const char* zoom : {"1.37", "3.1", "5"}) {
    const std::string command = std::string("rsvg-convert -z ") + zoom + " IN -o OUT";
    const auto image = test::shown_by(*svg, "a.svg", command);
    ASSERT_TRUE(image);
    int largest = 0;
    // Leave out the pixels at the page's border.
    for (int y = 0; y < image->height - 1; ++y) {
      for (int x = 0; x < image->width - 1; ++x) {
        const std::uint8_t* pixel =
            image->bytes.data() + 3 * (static_cast<std::size_t>(y * image->width) + x);
        largest = std::max(
            {largest, std::abs(pixel[0] - 51), std::abs(pixel[1] - 102), std::abs(pixel[2] - 204)});
      }
    }
    EXPECT_LE(largest, 3) << zoom;
  }
}

TEST(SvgInPrograms, librsvg_shows_small_instances_and_thumbnails) {
  if (!test::has_program("rsvg-convert")) GTEST_SKIP() << "no rsvg-convert here";
  const test::RegionMesh mesh = test::jittered_grid(test::kWideBox, 4, 3);
  Picture picture = test::make_picture(test::make_layer(mesh, [](int, Vec2 p) {
    return Rgb{static_cast<float>(p.x / 100), 0, 0};
  }));
  picture.stack.push_back(PatchInstance{0, {0.01, 0, 0, 0.01, 50, 30}, 1, BlendMode::normal});
  Context context;
  const auto svg = export_svg(context, picture, vector_options());
  ASSERT_TRUE(svg);
  for (const char* zoom : {"0.5", "1"}) {
    const std::string command = std::string("rsvg-convert -z ") + zoom + " IN -o OUT";
    const auto image = test::shown_by(*svg, "a.svg", command);
    ASSERT_TRUE(image) << zoom;
    const std::size_t middle = static_cast<std::size_t>(image->height / 2) * image->width;
    EXPECT_NEAR(image->bytes[3 * (middle + image->width * 8 / 10)], 0.85 * 255, 0.06 * 255) << zoom;
  }
}

TEST(SvgInPrograms, librsvg_shows_the_lady_bug_as_we_do) {
  if (!test::has_program("rsvg-convert")) GTEST_SKIP() << "no rsvg-convert here";
  const auto document = test::shared_scene("lady_bug.xml");
  if (!document) GTEST_SKIP() << "no public scene lady_bug.xml";
  expect_shown("rsvg-convert IN -o OUT", *document, vector_options(), 0.5, 4);
}

TEST(SvgInPrograms, librsvg_shows_pixels_as_we_do) {
  if (!test::has_program("rsvg-convert")) GTEST_SKIP() << "no rsvg-convert here";
  SvgOptions options;
  options.dpi = 96;
  for (const char* name : {"apple.svg", "fish.svg", "textures.svg"})
    expect_shown("rsvg-convert IN -o OUT", name, options, 0, 0);
}

TEST(SvgInPrograms, inkscape_shows_triangles_as_we_do) {
  if (!test::has_program("inkscape")) GTEST_SKIP() << "no inkscape here";
  SvgOptions options = vector_options();
  options.dpi = 96;
  options.force = true;
  expect_shown("inkscape IN -o OUT", "apple.svg", options, 0.6, 4);
}

}  // namespace
}  // namespace sfumato
