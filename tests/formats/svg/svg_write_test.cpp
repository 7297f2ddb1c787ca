#include "sfumato/formats/svg/svg_write.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "codecs/data_uri_write.hpp"
#include "formats/svg/write/svg_write_ids.hpp"
#include "formats/written.hpp"
#include "sfumato/base/limits.hpp"
#include "support/drawing.hpp"

namespace sfumato {
namespace {

using test::colored;
using test::kBlue;
using test::kRed;
using test::one_layer;
using test::written;

constexpr const char* kWrittenHead =
    "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:sf=\"urn:sfumato:1\" "
    "viewBox=\"0 0 100 100\"\n"
    "     sf:version=\"1\">\n"
    "  <style>*{stroke-linejoin:round}</style>\n";

/// Returns how often `part` occurs.
std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

Curve short_curve() {
  return {.control_points = {{1, 2}, {3, 4}, {5, 6}, {7.5, 8}}};
}

GradientFill sky() {
  GradientFill fill;
  fill.shape = LinearGradient{{0, 0}, {0, 90}};
  fill.stops = {{0, kRed, 1}, {1, kBlue, 0.5f}};
  return fill;
}

Texture one_texel() {
  Texture texture;
  texture.width = texture.height = 1;
  texture.rgba = {1, 2, 3, 255};
  return texture;
}

TEST(SvgWrite, writes_a_layer_in_its_place) {
  const std::string expected =
      std::string(kWrittenHead) +
      "  <g id=\"layer\" class=\"layer\" sf:diffuse=\"true\" fill=\"none\" stroke-width=\"0.2\">\n"
      "    <path class=\"curve\" d=\"M1 2 C3 4 5 6 7.5 8\" sf:left=\"#ff0000 @0\" "
      "sf:right=\"#0000ff @0\"\n"
      "          stroke=\"#800080\"/>\n"
      "  </g>\n"
      "</svg>\n";
  EXPECT_EQ(written(one_layer({colored(short_curve(), kRed, kBlue)})), expected);
}

TEST(SvgWrite, closes_a_path_that_ends_where_it_begins) {
  Curve loop{.control_points = {{1, 2}, {3, 4}, {5, 6}, {1, 2}}};
  EXPECT_TRUE(contains(written(one_layer({loop})), "d=\"M1 2 C3 4 5 6 1 2 Z\""));
}

TEST(SvgWrite, breaks_long_values_at_100_columns) {
  Curve curve;
  for (int i = 0; i < 301; ++i) curve.control_points.push_back({i / 7.0, i / 3.0});
  for (int i = 0; i <= 100; ++i) curve.left.blur_radius.stops.push_back({double(i), i / 3.0f});
  const std::string text = written(one_layer({curve}));
  std::size_t longest = 0, begin = 0;
  for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', begin)) {
    longest = std::max(longest, end - begin);
    begin = end + 1;
  }
  EXPECT_LE(longest, 100u);
  EXPECT_GT(longest, 80u);
}

TEST(SvgWrite, writes_offsets_of_arc_length_as_percentages_and_leaves_out_the_ends) {
  Curve curve = short_curve();
  curve.left.blur_radius = {StopSpace::arc_length, {{0, 0.0f}, {0.3, 5.5f}, {1, 0.0f}}};
  curve.right.blur_radius = {StopSpace::arc_length, {{0.1, 1.0f}}};
  const std::string text = written(one_layer({curve}));
  EXPECT_TRUE(contains(text, "sf:left-blur=\"0, 5.5 30%, 0\"")) << text;
  EXPECT_TRUE(contains(text, "sf:right-blur=\"1 10%\"")) << text;
}

TEST(SvgWrite, leaves_out_offsets_of_stops_that_are_evenly_spread) {
  Curve curve = short_curve();
  const double third = 1.0 / 3;
  curve.left.blur_radius = {StopSpace::arc_length,
                            {{0, 1.0f}, {third, 2.0f}, {2 * third, 3.0f}, {1, 0.0f}}};
  curve.right.blur_radius = {StopSpace::arc_length,
                             {{0.25, 1.0f}, {0.5, 2.0f}, {0.75, 3.0f}, {0.75, 0.0f}}};
  const std::string text = written(one_layer({curve}));
  EXPECT_TRUE(contains(text, "sf:left-blur=\"1, 2, 3, 0\"")) << text;
  EXPECT_TRUE(contains(text, "sf:right-blur=\"1 25%, 2 50%, 3 75%, 0 75%\"")) << text;
}

TEST(SvgWrite, leaves_out_radii_of_0) {
  Curve curve = short_curve();
  curve.left.blur_radius = {StopSpace::arc_length, {{0, 0.0f}, {1, 0.0f}}};
  EXPECT_FALSE(contains(written(one_layer({curve})), "blur"));
}

TEST(SvgWrite, merges_blur_and_opacity_of_equal_sides) {
  Curve curve = short_curve();
  curve.left.blur_radius = curve.right.blur_radius = {StopSpace::parameter, {{0.5, 2.0f}}};
  curve.left.opacity = {ShaderKind::curve_domain, {StopSpace::arc_length, {{0, 0.25f}}}, 0};
  curve.right.opacity = curve.left.opacity;
  const std::string text = written(one_layer({curve}));
  EXPECT_TRUE(contains(text, "sf:opacity=\"0.25\"")) << text;
  EXPECT_TRUE(contains(text, "sf:blur=\"2 @0.5\"")) << text;
  curve.right.opacity.stops.stops[0].value = 1;
  curve.right.blur_radius = {};
  const std::string two_sided = written(one_layer({curve}));
  EXPECT_TRUE(contains(two_sided, "sf:left-opacity=\"0.25\" sf:right-opacity=\"1\"") ||
              contains(two_sided, "sf:left-opacity=\"0.25\"\n"))
      << two_sided;
  EXPECT_TRUE(contains(two_sided, "sf:left-blur=\"2 @0.5\""));
  EXPECT_FALSE(contains(two_sided, "sf:blur="));
}

TEST(SvgWrite, writes_barriers_weights_and_leaves_out_open_sides) {
  Curve curve = short_curve();
  curve.left.color.kind = ShaderKind::barrier;
  curve.weight = 2.5;
  const std::string text = written(one_layer({curve}));
  EXPECT_TRUE(contains(text, "sf:left=\"none\" sf:weight=\"2.5\"")) << text;
  EXPECT_FALSE(contains(text, "sf:right"));
}

TEST(SvgWrite, mirrors_shaders_in_stroke_and_fill) {
  Document document = one_layer({short_curve()});
  document.shaders = {{"unused", sky()}, {"sky", sky()}, {"", sky()}};
  Curve& curve = document.layers[0].curves[0];
  curve.left.color = {ShaderKind::image_domain, {}, 2};
  curve.right.color = {ShaderKind::image_domain, {}, 1};
  const std::string text = written(document);
  EXPECT_TRUE(contains(text, "sf:left=\"url(#gradient-1)\"")) << text;
  EXPECT_TRUE(contains(text, "stroke=\"url(#gradient-1)\""));
  EXPECT_TRUE(contains(text, "fill=\"url(#sky)\""));
  EXPECT_TRUE(contains(text, "fill-opacity=\"0\""));
  EXPECT_LT(text.find("id=\"gradient-1\""), text.find("id=\"sky\""));
  EXPECT_LT(text.find("id=\"sky\""), text.find("id=\"unused\""));
}

TEST(SvgWrite, writes_gradients_in_user_space) {
  Document document = one_layer({short_curve()});
  GradientFill round;
  round.shape = RadialGradient{{5, 6}, {7, 6}, 10};
  round.spread = SpreadMethod::reflect;
  round.layer_from_gradient = {1, 0, 0, 1, 3, 4};
  round.stops = {{0.25, kRed, 1}};
  document.shaders = {{"sky", sky()}, {"round", round}};
  const std::string text = written(document);
  EXPECT_TRUE(contains(text,
                       "    <linearGradient id=\"sky\" gradientUnits=\"userSpaceOnUse\" x1=\"0\" "
                       "y1=\"0\" x2=\"0\" y2=\"90\">\n"
                       "      <stop offset=\"0\" stop-color=\"#ff0000\"/>\n"
                       "      <stop offset=\"1\" stop-color=\"#0000ff\" stop-opacity=\"0.5\"/>\n"
                       "    </linearGradient>\n"))
      << text;
  EXPECT_TRUE(contains(text, "fx=\"7\"") && contains(text, "spreadMethod=\"reflect\"") &&
              contains(text, "gradientTransform=\"translate(3 4)\""))
      << text;
}

TEST(SvgWrite, embeds_the_file_of_a_texture_or_encodes_its_texels) {
  Document document = one_layer({short_curve()});
  Texture texture = one_texel();
  texture.layer_from_texture = {2, 0, 0, 2, 0, 0};
  document.shaders = {{"grain", texture}};
  const std::string encoded = written(document);
  EXPECT_TRUE(contains(encoded, "href=\"data:image/png;base64,iVBORw0KGgo")) << encoded;
  EXPECT_TRUE(contains(encoded,
                       "<pattern id=\"grain\" patternUnits=\"userSpaceOnUse\" width=\"1\" "
                       "height=\"1\"\n"
                       "             patternTransform=\"matrix(2 0 0 2 0 0)\">"))
      << encoded;
  std::get<Texture>(document.shaders[0].paint).repeats = false;
  EXPECT_TRUE(contains(written(document), "sf:repeats=\"false\""));
  std::get<Texture>(document.shaders[0].paint).repeats = true;
  std::get<Texture>(document.shaders[0].paint).file = {0xff, 0xd8, 0xff, 0xe0};
  EXPECT_TRUE(contains(written(document), "href=\"data:image/jpeg;base64,/9j/4A==\""));
}

TEST(SvgWrite, puts_what_is_painted_more_than_once_or_never_into_defs) {
  Document document = one_layer({colored(short_curve(), kRed, kBlue)});
  document.layers.push_back({"", {}});
  document.stack.push_back(LayerInstance{0, {1, 0, 0, 1, 20, 0}, 0.5f, BlendMode::color_dodge});
  const std::string text = written(document);
  EXPECT_TRUE(
      contains(text,
               "  <use xlink:href=\"#layer\"/>\n"
               "  <use xlink:href=\"#layer\" transform=\"translate(20 0)\" opacity=\"0.5\"\n"
               "       style=\"mix-blend-mode:color-dodge\"/>\n"))
      << text;
  EXPECT_TRUE(contains(text, "xmlns:xlink=\"http://www.w3.org/1999/xlink\""));
  EXPECT_LT(text.find("<g id=\"layer\" class=\"layer\" sf:diffuse=\"true\""), text.find("</defs>"));
  EXPECT_LT(text.find("<g id=\"layer-1\" sf:diffuse=\"true\""), text.find("</defs>"));
}

TEST(SvgWrite, writes_background_groups_and_local_strokes_in_their_order) {
  Document document = one_layer({short_curve()});
  document.background = kRed;
  document.interpolation = InterpolationSpace::oklab;
  LocalStroke stroke;
  stroke.curve = {.id = "shine",
                  .control_points = {{0, 0}, {1, 0}, {2, 0}, {3, 0}},
                  .left_color = {StopSpace::arc_length, {{0, kRed}}},
                  .right_color = {StopSpace::arc_length, {{0, kBlue}}},
                  .blur_radius = {},
                  .influence_radius = {StopSpace::arc_length, {{0, 2.0f}, {1, 4.0f}}},
                  .alpha = 0.75};
  document.stack.push_back(GroupBegin{1, BlendMode::normal});
  document.stack.push_back(GroupBegin{0.5f, BlendMode::multiply});
  document.stack.push_back(stroke);
  document.stack.push_back(GroupEnd{});
  document.stack.push_back(GroupEnd{});
  const std::string text = written(document);
  EXPECT_TRUE(contains(text, "sf:interpolation=\"oklab\""));
  EXPECT_TRUE(contains(text,
                       ">\n  <rect x=\"0\" y=\"0\" width=\"100%\" height=\"100%\" "
                       "fill=\"#ff0000\"/>\n  <g"))
      << text;
  EXPECT_TRUE(contains(text,
                       "  <g style=\"isolation:isolate\">\n"
                       "    <g opacity=\"0.5\" style=\"mix-blend-mode:multiply\">\n"
                       "      <path id=\"shine\""))
      << text;
  EXPECT_TRUE(contains(text, "sf:radius=\"2, 4\"") && contains(text, "sf:alpha=\"0.75\""));
  EXPECT_TRUE(contains(text, "stroke-width=\"3\"")) << text;
  EXPECT_TRUE(text.ends_with("    </g>\n  </g>\n</svg>\n"));
}

TEST(SvgWrite, makes_ids_names_and_unique) {
  Document document = one_layer({short_curve(), short_curve(), short_curve()});
  document.layers[0].id = "a";
  document.layers[0].curves[0].id = "a";
  document.layers[0].curves[1].id = "1 <b\"ü\xff";
  document.layers[0].curves[2].id = "a-2";
  const std::string text = written(document);
  for (const char* id : {"\"a\"", "\"a-2\"", "\"_1__b_ü_\"", "\"a-2-2\""}) {
    EXPECT_EQ(count(text, std::string("id=") + id), 1u) << id << '\n' << text;
  }
}

TEST(SvgWrite, says_what_is_wrong_with_an_invalid_document) {
  Document document = one_layer({short_curve()});
  document.layers[0].curves[0].control_points.pop_back();
  Context context;
  const Result<std::string> text = write_svg(context, document);
  ASSERT_FALSE(text.ok());
  EXPECT_EQ(text.status().code, StatusCode::bad_input);
}

TEST(SvgWrite, refuses_what_could_not_be_read_again) {
  Document document = one_layer({short_curve()});
  Texture texture = one_texel();
  texture.file.assign(limits::kInputBytes, 0);
  std::copy_n("\xff\xd8\xff", 3, texture.file.begin());
  document.shaders = {{"grain", texture}};
  Context context;
  const Result<std::string> text = write_svg(context, document);
  ASSERT_FALSE(text.ok());
  EXPECT_EQ(text.status().code, StatusCode::limit);
}

TEST(SvgWrite, takes_its_room_from_the_budget) {
  Document document = one_layer({short_curve()});
  document.layers[0].curves.resize(10'000, short_curve());
  Context large;
  const Result<std::string> whole = write_svg(large, document);
  ASSERT_TRUE(whole.ok());
  EXPECT_EQ(large.budget.used(), 0u);
  Context context{.budget = Budget(whole->size() - 1)};
  const Result<std::string> text = write_svg(context, document);
  ASSERT_FALSE(text.ok());
  EXPECT_EQ(text.status().code, StatusCode::limit);
  EXPECT_EQ(context.budget.used(), 0u);
}

TEST(DataUri, pads_what_is_no_multiple_of_three) {
  const std::vector<std::uint8_t> bytes{'f', 'o', 'o', 'b', 'a', 'r'};
  const char* expected[] = {"", "Zg==", "Zm8=", "Zm9v", "Zm9vYg==", "Zm9vYmE=", "Zm9vYmFy"};
  const Context context;
  for (std::size_t n = 0; n <= bytes.size(); ++n) {
    OutputBuffer text(context, "a data: URI");
    codecs::append_data_uri(context, "a/b", std::span(bytes).first(n), text);
    const auto uri = text.finish();
    ASSERT_TRUE(uri.ok());
    EXPECT_EQ(std::string(uri->begin(), uri->end()), std::string("data:a/b;base64,") + expected[n]);
  }
}

TEST(IdPool, keeps_characters_of_xml_names_and_replaces_others) {
  svg::IdPool pool;
  EXPECT_EQ(pool.claim("Ärger_1.b-c"), "Ärger_1.b-c");
  EXPECT_EQ(pool.claim("日本"), "日本");
  EXPECT_EQ(pool.claim("a:b"), "a_b");
  EXPECT_EQ(pool.claim("\xc0\xaf"), "__");
  EXPECT_EQ(pool.claim("-x"), "_-x");
  EXPECT_EQ(pool.claim_or_make("", "layer"), "layer-1");
  EXPECT_EQ(pool.claim_or_make("layer-1", "layer"), "layer-1-2");
}

}  // namespace
}  // namespace sfumato
