// A pattern with vector content becomes a texture that a painter draws.
#include <gtest/gtest.h>

#include <algorithm>
#include <variant>

#include "sfumato/api/draw_document.hpp"
#include "sfumato/import/import_svg.hpp"

namespace sfumato {
namespace {

const std::string kSquare = "<rect x='10' y='10' width='80' height='80' fill='url(#p)'/>";

bool tells_of_texture(const Diagnostic& warning) {
  return warning.message.find("becomes a texture of ") != std::string::npos;
}

/// Imports a picture of 100 × 100 px, where a texel of a tile of whole pixels is a unit. Removes
/// the warning that each drawn pattern causes.
ImportedSvg patterned(const std::string& content, std::optional<TilePainter> painter,
                      const Limits& limits = {}) {
  Context context{.limits = limits};
  auto result = import_svg(
      context,
      "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'>" + content + "</svg>",
      "pattern.svg", nullptr, painter);
  EXPECT_TRUE(result) << (result ? "" : result.status().message);
  if (result) std::erase_if(result->warnings, tells_of_texture);
  return result ? std::move(*result) : ImportedSvg{};
}

ImportedSvg patterned(const std::string& content) {
  return patterned(content, [](auto&&... tile) { return draw_document(tile...); });
}

std::string pattern_of(const std::string& attributes, const std::string& content,
                       const std::string& id = "p") {
  return "<pattern id='" + id + "' patternUnits='userSpaceOnUse' " + attributes + ">" + content +
         "</pattern>";
}

Texture color_texture(const ImportedSvg& made) {
  if (made.document.layers.empty()) {
    ADD_FAILURE() << "no layer";
    return {};
  }
  const Curve& curve = made.document.layers[0].curves.at(0);
  EXPECT_EQ(curve.right.color.kind, ShaderKind::image_domain);
  return std::get<Texture>(made.document.shaders.at(curve.right.color.shader).paint);
}

/// Returns red, green, blue, alpha.
std::vector<int> texel(const Texture& texture, int x, int y) {
  const auto at = texture.rgba.begin() + 4 * (y * texture.width + x);
  return {at, at + 4};
}

const std::string kBoard =
    "<rect width='8' height='8' fill='#fff'/><rect width='4' height='4' fill='#f00'/>"
    "<rect x='4' y='4' width='9' height='9' fill='#00f'/>";

TEST(ImportPattern, is_a_texture_of_its_tile) {
  const ImportedSvg made = patterned(pattern_of("x='2' width='8' height='8'", kBoard) + kSquare);
  EXPECT_TRUE(made.warnings.empty());
  const Texture texture = color_texture(made);
  ASSERT_EQ(texture.width, 8);
  ASSERT_EQ(texture.height, 8);
  EXPECT_TRUE(texture.repeats);
  EXPECT_EQ(texture.layer_from_texture, (Affine{1, 0, 0, 1, 2, 0}));
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      const std::vector<int> white{255, 255, 255, 255}, red{255, 0, 0, 255}, blue{0, 0, 255, 255};
      EXPECT_EQ(texel(texture, x, y), (x < 4) != (y < 4) ? white : x < 4 ? red : blue);
    }
  }
}

TEST(ImportPattern, clear_parts_are_an_opacity_texture) {
  const ImportedSvg made = patterned(
      pattern_of("width='8' height='8'", "<rect width='4' height='8' fill='#f00'/>") + kSquare);
  const Curve& curve = made.document.layers.at(0).curves.at(0);
  ASSERT_EQ(curve.right.opacity.kind, ShaderKind::image_domain);
  const auto& opacity =
      std::get<Texture>(made.document.shaders.at(curve.right.opacity.shader).paint);
  EXPECT_EQ(texel(opacity, 1, 1), (std::vector<int>{255, 255, 255, 255}));
  EXPECT_EQ(texel(opacity, 6, 1), (std::vector<int>{255, 255, 255, 0}));
}

TEST(ImportPattern, a_warning_says_that_it_is_a_texture) {
  Context context;
  const auto made =
      import_svg(context,
                 "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'>" +
                     pattern_of("width='8' height='4'", kBoard) + kSquare + "</svg>",
                 "pattern.svg", nullptr, [](auto&&... tile) { return draw_document(tile...); });
  ASSERT_TRUE(made);
  ASSERT_EQ(made->warnings.size(), 1u);
  EXPECT_EQ(made->warnings[0].message,
            "the pattern #p becomes a texture of 8 x 4 texels, which is soft where the picture is "
            "enlarged");
}

TEST(ImportPattern, its_resolution_is_that_of_the_picture) {
  const auto size_of = [](const std::string& attributes) {
    const Texture texture = color_texture(patterned(pattern_of(attributes, kBoard) + kSquare));
    return std::pair(texture.width, texture.height);
  };
  EXPECT_EQ(size_of("width='8' height='4'"), std::pair(8, 4)) << "whole pixels";
  EXPECT_EQ(size_of("width='8' height='4.4'"), std::pair(16, 9));
  EXPECT_EQ(size_of("width='8' height='4' patternTransform='rotate(9)scale(2 3)'"),
            std::pair(32, 24));
  EXPECT_EQ(size_of("width='9000' height='.001'"), std::pair(1024, 1));
}

TEST(ImportPattern, where_there_is_no_room_the_tile_is_coarser) {
  const auto side_of_last = [](int count) {
    std::string content;
    for (int i = 0; i < count; ++i) {
      content += pattern_of("width='" + std::to_string(500 + i) + ".25' height='500.25'", kBoard,
                            "p" + std::to_string(i)) +
                 "<rect width='9' height='9' fill='url(#p" + std::to_string(i) + ")'/>";
    }
    const ImportedSvg made = patterned(content, [](auto&&, auto&&, int width, int height) {
      return Result<Image>(
          Image{.width = width,
                .height = height,
                .bytes = std::vector<std::uint8_t>(std::size_t(4) * width * height, 255)});
    });
    return std::get<Texture>(made.document.shaders.back().paint).height;
  };
  EXPECT_EQ(side_of_last(3), 1001);
  EXPECT_EQ(side_of_last(4), 500);
}

TEST(ImportPattern, a_view_box_and_the_box_of_the_shape_place_the_content) {
  const std::string half = "<rect width='.1' height='.2' fill='#0f0'/>";
  const ImportedSvg made =
      patterned("<pattern id='p' width='.2' height='.2' patternContentUnits='objectBoundingBox'>" +
                half + "</pattern>" + kSquare);
  const Texture of_box = color_texture(made);
  EXPECT_EQ(of_box.width, 16);
  EXPECT_EQ(texel(of_box, 7, 15)[3], 255);
  EXPECT_EQ(texel(of_box, 8, 0)[3], 0);
  const Texture of_view = color_texture(
      patterned(pattern_of("width='20' height='20' viewBox='0 0 .2 .2'", half) + kSquare));
  EXPECT_EQ(texel(of_view, 9, 19)[3], 255);
  EXPECT_EQ(texel(of_view, 10, 19)[3], 0);
}

TEST(ImportPattern, content_inherits_from_the_pattern) {
  const Texture texture = color_texture(patterned("<g fill='#0f0'>" +
                                                  pattern_of("width='8' height='8'",
                                                             "<rect width='8' "
                                                             "height='8'/>") +
                                                  "</g>" + kSquare));
  EXPECT_EQ(texel(texture, 3, 3), (std::vector<int>{0, 255, 0, 255}));
}

TEST(ImportPattern, patterns_may_stand_in_patterns) {
  const Texture texture = color_texture(patterned(
      pattern_of("width='4' height='4'", "<rect width='2' height='4' fill='#f00'/>", "inner") +
      pattern_of("width='16' height='16'", "<rect width='16' height='8' fill='url(#inner)'/>") +
      kSquare));
  EXPECT_EQ(texel(texture, 4, 4), (std::vector<int>{255, 0, 0, 255}));
  EXPECT_EQ(texel(texture, 6, 4)[3], 0);
  EXPECT_EQ(texel(texture, 4, 12)[3], 0);
}

TEST(ImportPattern, one_that_paints_itself_lacks_that_part) {
  const ImportedSvg made =
      patterned(pattern_of("width='8' height='8'", kBoard + kSquare) + kSquare);
  ASSERT_EQ(made.warnings.size(), 1u);
  EXPECT_NE(made.warnings[0].message.find("is painted with itself"), std::string::npos);
  EXPECT_EQ(texel(color_texture(made), 1, 1), (std::vector<int>{255, 0, 0, 255}));
}

TEST(ImportPattern, shapes_in_one_place_share_a_texture) {
  const ImportedSvg made = patterned(pattern_of("width='8' height='8'", kBoard) + kSquare +
                                     "<circle cx='50' cy='50' r='9' fill='url(#p)'/>");
  EXPECT_EQ(made.document.shaders.size(), 1u);
}

TEST(ImportPattern, tiles_of_other_sizes_have_textures_of_their_own) {
  const ImportedSvg made = patterned(
      "<pattern id='p' width='1' height='1'><rect width='4' height='4'/></pattern>"
      "<rect width='20' height='9' fill='url(#p)'/><rect width='30' height='9' fill='url(#p)'/>");
  const auto& shaders = made.document.shaders;
  const auto has = [&](int width) {
    return std::ranges::any_of(shaders, [=](const Shader& shader) {
      return std::get<Texture>(shader.paint).width == width;
    });
  };
  EXPECT_TRUE(has(20));
  EXPECT_TRUE(has(30));
}

/// Returns the message of the only warning of a drawing under a limit.
std::string warning_under(std::size_t Limits::*limit, std::size_t value,
                          const std::string& content) {
  Limits limits;
  limits.*limit = value;
  const ImportedSvg made = patterned(
      content, [](auto&&... tile) { return draw_document(tile...); }, limits);
  EXPECT_EQ(made.warnings.size(), 1u);
  return made.warnings.empty() ? "" : made.warnings[0].message;
}

TEST(ImportPattern, its_limits_are_named_in_warnings) {
  const std::string tile = "width='8' height='8'";
  const std::string board = pattern_of(tile, kBoard) + kSquare;
  const std::string nested =
      pattern_of(tile, "<circle r='4' fill='url(#q)'/>") + pattern_of(tile, kBoard, "q") + kSquare;
  EXPECT_EQ(warning_under(&Limits::pattern_tiles, 0, board),
            "fill of <rect> is left out: there are more than the limit of 0 tiles of patterns "
            "and masks; raise the limit pattern-tiles");
  EXPECT_EQ(warning_under(&Limits::pattern_texels, 15, board),
            "fill of <rect> is left out: there are more than the limit of 15 texels in tiles of "
            "patterns and masks; raise the limit pattern-texels");
  EXPECT_EQ(warning_under(&Limits::pattern_shapes, 2, board),
            "there are more than the limit of 2 shapes in patterns and masks; <pattern> #p stays "
            "clear; raise the limit pattern-shapes");
  EXPECT_EQ(
      warning_under(&Limits::pattern_depth, 1, nested),
      "fill of <circle> is left out: there are more than the limit of 1 patterns and masks within "
      "each other; raise the limit pattern-depth");
  EXPECT_EQ(warning_under(&Limits::pattern_side, 3, board),
            "the pattern #p is drawn more coarsely than the picture: 3 texels are the limit for a "
            "side; raise the limit pattern-side");
}

TEST(ImportPattern, its_limits_can_be_raised) {
  Limits limits;
  limits.pattern_side = 2000;
  const ImportedSvg made = patterned(
      pattern_of("width='2000' height='8'", kBoard) + kSquare,
      [](auto&&... tile) { return draw_document(tile...); }, limits);
  EXPECT_TRUE(made.warnings.empty());
  EXPECT_EQ(color_texture(made).width, 2000);
}

TEST(ImportPattern, without_a_painter_it_is_left_out) {
  const ImportedSvg made =
      patterned(pattern_of("width='8' height='8'", kBoard) + kSquare, std::nullopt);
  EXPECT_EQ(made.warnings.size(), 1u);
  EXPECT_TRUE(made.document.layers.empty());
}

TEST(ImportPattern, the_painter_may_fail) {
  const std::string text = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 9 9'>" +
                           pattern_of("width='8' height='8'", kBoard) + kSquare + "</svg>";
  Context context;
  const auto failed = import_svg(context, text, "", nullptr,
                                 [](Context&, const Document&, int, int) -> Result<Image> {
                                   return make_error(StatusCode::cancelled, "no");
                                 });
  EXPECT_EQ(failed.status().code, StatusCode::cancelled);
  const auto odd =
      import_svg(context, text, "", nullptr,
                 [](Context&, const Document&, int, int) -> Result<Image> { return Image{}; });
  EXPECT_EQ(odd.status().code, StatusCode::bad_input);
}

}  // namespace
}  // namespace sfumato
