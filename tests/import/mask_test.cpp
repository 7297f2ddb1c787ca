// Masks become clips and opacities of shapes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "sfumato/api/draw_document.hpp"
#include "sfumato/import/import_svg.hpp"

namespace sfumato {
namespace {

ImportedSvg masked_drawing(const std::string& content,
                           std::optional<TilePainter> painter = std::nullopt) {
  Context context;
  auto result = import_svg(
      context,
      "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'>" + content + "</svg>",
      "mask.svg", nullptr, painter);
  EXPECT_TRUE(result) << (result ? "" : result.status().message);
  return result ? std::move(*result) : ImportedSvg{};
}

ImportedSvg painted_drawing(const std::string& content) {
  return masked_drawing(content, [](auto&&... tile) { return draw_document(tile...); });
}

/// Returns the alpha of the drawing at points (x, y) of a picture of 100 × 100 pixels.
std::vector<int> alphas_at(const ImportedSvg& made,
                           const std::vector<std::pair<int, int>>& points) {
  Context context;
  const Result<Image> image = draw_document(context, made.document, 100, 100);
  std::vector<int> alphas;
  for (const auto& [x, y] : points) {
    alphas.push_back(image ? image->bytes[4 * static_cast<std::size_t>(y * 100 + x) + 3] : -1);
  }
  return alphas;
}

std::string mask_of(const std::string& content, const std::string& attributes = "") {
  return "<mask id='m' maskUnits='userSpaceOnUse' x='0' y='0' width='100' height='100' " +
         attributes + ">" + content + "</mask>";
}

const std::string kFade =
    "<linearGradient id='f'><stop stop-color='#fff'/><stop offset='1' stop-color='#000'/>"
    "</linearGradient>";
const std::string kDown =
    "<linearGradient id='v' y2='1' x2='0'><stop stop-color='#fff'/>"
    "<stop offset='1' stop-color='#fff' stop-opacity='0'/></linearGradient>";
const std::string kFadeRect = "<rect width='100' height='100' fill='url(#f)'/>";
const std::string kMaskedSquare =
    "<rect x='10' y='10' width='80' height='80' fill='#06c' mask='url(#m)'/>";

void expect_near(const std::vector<int>& actual, const std::vector<int>& expected, int most = 2) {
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t i = 0; i < actual.size(); ++i) EXPECT_NEAR(actual[i], expected[i], most) << i;
}

TEST(ImportMask, a_gradient_is_the_opacity_of_the_shape) {
  const ImportedSvg made = masked_drawing(kFade + mask_of(kFadeRect) + kMaskedSquare);
  EXPECT_TRUE(made.warnings.empty());
  ASSERT_EQ(made.document.layers.size(), 1u);
  const Curve& curve = made.document.layers[0].curves.at(0);
  ASSERT_EQ(curve.right.opacity.kind, ShaderKind::image_domain);
  EXPECT_EQ(curve.right.color.kind, ShaderKind::curve_domain);
  const Shader& shader = made.document.shaders.at(curve.right.opacity.shader);
  EXPECT_TRUE(std::holds_alternative<GradientFill>(shader.paint));
  expect_near(alphas_at(made, {{25, 50}, {50, 50}, {75, 50}, {5, 50}}), {190, 126, 62, 0});
}

TEST(ImportMask, a_gradient_masks_a_gradient_exactly) {
  const ImportedSvg made = masked_drawing(
      kFade +
      "<linearGradient id='c'><stop stop-color='red'/><stop offset='1' stop-color='blue'/>" +
      "</linearGradient>" + mask_of(kFadeRect) +
      "<rect width='100' height='100' fill='url(#c)' mask='url(#m)'/>");
  EXPECT_TRUE(made.warnings.empty());
  const Curve& curve = made.document.layers.at(0).curves.at(0);
  EXPECT_EQ(curve.right.color.kind, ShaderKind::image_domain);
  EXPECT_EQ(curve.right.opacity.kind, ShaderKind::image_domain);
  EXPECT_NE(curve.right.color.shader, curve.right.opacity.shader);
}

TEST(ImportMask, white_shapes_cut_and_black_ones_cut_out) {
  const std::string white = "<rect width='100' height='100' fill='#fff'/>";
  const std::string hole = "<circle cx='50' cy='50' r='20'/>";
  const std::string line = "<path d='M0 20H100' stroke='#000' stroke-width='4'/>";
  const ImportedSvg made = masked_drawing(mask_of(white + hole + line) + kMaskedSquare);
  EXPECT_TRUE(made.warnings.empty());
  EXPECT_TRUE(made.document.shaders.empty());
  expect_near(alphas_at(made, {{50, 50}, {50, 20}, {50, 15}, {15, 50}}), {0, 0, 255, 255}, 0);
  const std::string stroke = "<path d='M0 50H100' stroke='#fff' stroke-width='20'/>";
  expect_near(
      alphas_at(masked_drawing(mask_of(stroke) + kMaskedSquare), {{50, 30}, {50, 55}, {5, 55}}),
      {0, 255, 0}, 0);
}

TEST(ImportMask, a_flat_grey_is_the_opacity_of_the_group) {
  const std::string grey = "<rect width='50' height='100' fill='#808080'/>";
  const ImportedSvg made = masked_drawing(
      mask_of(grey) + "<g mask='url(#m)'><rect x='10' y='10' width='60' height='60'/>" +
      "<rect x='30' y='30' width='60' height='60' fill='red'/></g>");
  EXPECT_TRUE(made.warnings.empty());
  expect_near(alphas_at(made, {{20, 20}, {40, 40}, {60, 60}}), {128, 128, 0}, 1);
  const ImportedSvg clear = masked_drawing(mask_of("<rect width='9' height='9'/>") + kMaskedSquare);
  EXPECT_TRUE(clear.document.stack.empty());
}

TEST(ImportMask, alpha_masks_take_any_colour) {
  const std::string red = "<circle cx='50' cy='50' r='20' fill='#d9d9d9'/>";
  for (const char* type : {"mask-type='alpha'", "style='mask-type:alpha'"}) {
    const ImportedSvg made = masked_drawing(mask_of(red, type) + kMaskedSquare);
    expect_near(alphas_at(made, {{50, 50}, {50, 20}}), {255, 0}, 0);
  }
  const ImportedSvg by_mode =
      masked_drawing(mask_of(red) + "<rect width='100' height='100' style='mask:url(#m) alpha'/>");
  expect_near(alphas_at(by_mode, {{50, 50}, {50, 20}}), {255, 0}, 0);
  const ImportedSvg faded =
      masked_drawing(kFade + mask_of(kFadeRect, "mask-type='alpha'") + kMaskedSquare);
  expect_near(alphas_at(faded, {{25, 50}, {75, 50}}), {255, 255}, 0);
}

TEST(ImportMask, units_and_region_count) {
  const std::string half = "<rect width='.5' height='1' fill='#fff'/>";
  const ImportedSvg of_box = masked_drawing("<mask id='m' maskContentUnits='objectBoundingBox'>" +
                                            half + "</mask>" + kMaskedSquare);
  expect_near(alphas_at(of_box, {{30, 50}, {60, 50}}), {255, 0}, 0);
  const std::string white = "<rect width='100' height='100' fill='#fff'/>";
  const ImportedSvg region =
      masked_drawing("<mask id='m' x='.5' width='.25'>" + white + "</mask>" + kMaskedSquare);
  expect_near(alphas_at(region, {{40, 50}, {60, 50}, {80, 50}}), {0, 255, 0}, 0);
  const ImportedSvg wide = masked_drawing("<mask id='m'>" + white + "</mask>" + kMaskedSquare);
  EXPECT_EQ(alphas_at(wide, {{12, 12}, {88, 88}}), (std::vector<int>{255, 255}));
  // The box of a line has no area.
  const ImportedSvg line =
      masked_drawing("<mask id='m'>" + white +
                     "</mask><path d='M0 50H90' stroke='red' stroke-width='9' mask='url(#m)'/>");
  EXPECT_TRUE(line.document.stack.empty());
}

TEST(ImportMask, parts_that_overlap_become_one_texture) {
  const std::string group =
      "<g mask='url(#m)'><rect x='10' y='10' width='60' height='60'/>"
      "<rect x='30' y='30' width='60' height='60' fill='red'/></g>";
  const ImportedSvg made = painted_drawing(kFade + mask_of(kFadeRect) + group);
  EXPECT_TRUE(made.warnings.empty());
  EXPECT_EQ(made.document.layers.size(), 1u);
  expect_near(alphas_at(made, {{20, 20}, {50, 50}, {80, 80}, {80, 20}}), {203, 126, 50, 0});
  const ImportedSvg bare = masked_drawing(kFade + mask_of(kFadeRect) + group);
  ASSERT_EQ(bare.warnings.size(), 1u);
  EXPECT_NE(bare.warnings[0].message.find("mask of <g>: parts that overlap"), std::string::npos);
}

TEST(ImportMask, parts_apart_stay_curves) {
  const ImportedSvg made =
      painted_drawing(kFade + mask_of(kFadeRect) +
                      "<g mask='url(#m)'><rect x='10' y='10' width='30' height='60'/>"
                      "<rect x='50' y='10' width='30' height='60' fill='red'/></g>");
  EXPECT_TRUE(made.warnings.empty());
  EXPECT_EQ(made.document.shaders.size(), 1u);
  EXPECT_EQ(made.document.layers.at(0).curves.size(), 2u);
}

TEST(ImportMask, other_content_is_drawn) {
  const std::string levels =
      "<rect width='100' height='100' fill='#fff'/><circle cx='50' cy='50' r='30' fill='#808080'/>"
      "<circle cx='50' cy='50' r='10' fill='#404040'/>";
  const ImportedSvg made = painted_drawing(mask_of(levels) + kMaskedSquare);
  EXPECT_TRUE(made.warnings.empty());
  expect_near(alphas_at(made, {{15, 15}, {50, 30}, {50, 50}}), {255, 128, 64}, 1);
  const ImportedSvg bare = masked_drawing(mask_of(levels) + kMaskedSquare);
  ASSERT_EQ(bare.warnings.size(), 1u);
  EXPECT_NE(bare.warnings[0].message.find("mask of <rect> is left out: the content of #m"),
            std::string::npos);
  EXPECT_EQ(alphas_at(bare, {{50, 50}}), (std::vector<int>{255}));
}

TEST(ImportMask, opacities_multiply) {
  const std::string clear_paint = "<rect x='10' y='10' width='80' height='80' fill='url(#v)' ";
  const ImportedSvg made =
      painted_drawing(kFade + kDown + mask_of(kFadeRect) + clear_paint + "mask='url(#m)'/>");
  EXPECT_TRUE(made.warnings.empty());
  expect_near(alphas_at(made, {{50, 50}, {25, 30}, {75, 70}}), {63, 141, 15}, 3);
  const std::string outer = "<mask id='n'><rect width='100' height='100' fill='url(#v)'/></mask>";
  const ImportedSvg nested = painted_drawing(kFade + kDown + outer + mask_of(kFadeRect) +
                                             "<g mask='url(#n)'>" + kMaskedSquare + "</g>");
  EXPECT_TRUE(nested.warnings.empty());
  expect_near(alphas_at(nested, {{50, 50}, {25, 25}}), {63, 141}, 3);
  const ImportedSvg bare =
      masked_drawing(kFade + kDown + mask_of(kFadeRect) + clear_paint + "id='a' mask='url(#m)'/>");
  ASSERT_EQ(bare.warnings.size(), 1u);
  EXPECT_NE(bare.warnings[0].message.find("the mask of the shape #a is left out"),
            std::string::npos);
}

TEST(ImportMask, masks_of_masks_and_in_masks_multiply) {
  const std::string grey = "<mask id='n'><rect width='99' height='99' fill='#808080'/></mask>";
  const ImportedSvg inside = masked_drawing(
      grey + kFade + mask_of("<rect width='100' height='100' fill='url(#f)' mask='url(#n)'/>") +
      kMaskedSquare);
  EXPECT_TRUE(inside.warnings.empty());
  expect_near(alphas_at(inside, {{25, 50}, {75, 50}}), {95, 31});
  const ImportedSvg on_itself =
      masked_drawing(grey + kFade + mask_of(kFadeRect, "mask='url(#n)'") + kMaskedSquare);
  EXPECT_TRUE(on_itself.warnings.empty());
  expect_near(alphas_at(on_itself, {{25, 50}, {75, 50}}), {95, 31});
}

TEST(ImportMask, circles_of_masks_end) {
  const std::string itself = mask_of("<rect width='100' height='100' fill='#fff' mask='url(#m)'/>");
  const std::string two =
      "<mask id='n'><rect width='99' height='99' fill='#fff' mask='url(#m)'/></mask>" +
      mask_of("<rect width='100' height='100' fill='#fff'/>", "mask='url(#n)'");
  const std::string own = mask_of("<rect width='100' height='100' fill='#fff'/>", "mask='url(#m)'");
  for (const std::string& mask : {itself, two, own}) {
    const ImportedSvg made = painted_drawing(mask + kMaskedSquare);
    ASSERT_EQ(made.warnings.size(), 1u) << mask;
    EXPECT_NE(made.warnings[0].message.find("#m masks itself"), std::string::npos);
    EXPECT_EQ(alphas_at(made, {{50, 50}}), (std::vector<int>{255})) << mask;
  }
  std::string deep;
  for (int i = 0; i < 9; ++i) {
    deep += "<mask id='m" + std::to_string(i) +
            "'><rect width='99' height='99' fill='#fff' mask='url(#m" + std::to_string(i + 1) +
            ")'/></mask>";
  }
  const ImportedSvg made = painted_drawing(deep + "<rect width='50' height='50' mask='url(#m0)'/>");
  ASSERT_GE(made.warnings.size(), 1u);
  EXPECT_NE(made.warnings[0].message.find("the limit of 4 levels"), std::string::npos);
}

TEST(ImportMask, circles_through_use_end) {
  const std::string mask = "<mask id='m'><use href='#a'/></mask>";
  const std::string group =
      "<g id='a' mask='url(#m)'><rect width='50' height='50' fill='#fff'/><use href='#a'/></g>";
  const ImportedSvg made = painted_drawing(mask + group);
  EXPECT_EQ(alphas_at(made, {{40, 40}, {60, 60}}), (std::vector<int>{255, 0}));
  EXPECT_GE(made.warnings.size(), 1u);
}

TEST(ImportMask, many_shapes_are_one_clip) {
  std::string shapes;
  for (int i = 0; i < 400; ++i) {
    // Every other one runs in the other direction.
    const std::string x = std::to_string(i % 20 * 5), y = std::to_string(i / 20 * 5);
    shapes += "<path fill='#fff' d='M" + x + " " + y + (i % 2 == 0 ? "h6v6h-6z'/>" : "v6h6v-6z'/>");
  }
  const ImportedSvg made = masked_drawing(mask_of(shapes) + kMaskedSquare);
  EXPECT_TRUE(made.warnings.empty());
  expect_near(alphas_at(made, {{12, 12}, {50, 50}, {57, 33}, {5, 50}}), {255, 255, 255, 0}, 0);
}

TEST(ImportMask, black_and_white_in_many_turns_are_drawn) {
  std::string turns;
  for (int i = 49; i > 0; --i) {
    turns += "<circle cx='50' cy='50' r='" + std::to_string(i) + "' fill='" +
             (i % 2 == 0 ? "#000" : "#fff") + "'/>";
  }
  const ImportedSvg made = painted_drawing(mask_of(turns + turns) + kMaskedSquare);
  EXPECT_TRUE(made.warnings.empty());
  EXPECT_EQ(made.document.shaders.size(), 1u);
  EXPECT_EQ(masked_drawing(mask_of(turns + turns) + kMaskedSquare).warnings.size(), 1u);
}

TEST(ImportMask, tiles_are_limited) {
  std::string shapes = kFade + mask_of(kFadeRect + kFadeRect);
  for (int i = 0; i < 70; ++i) {
    shapes += "<rect x='" + std::to_string(i) + "' width='1' height='9' mask='url(#m)'/>";
  }
  const ImportedSvg made = painted_drawing(shapes);
  ASSERT_EQ(made.warnings.size(), 1u);
  EXPECT_NE(made.warnings[0].message.find("the limit of 64 tiles of patterns and masks"),
            std::string::npos);
  std::string many = "<mask id='m'>";
  for (int i = 0; i < 1001; ++i) many += "<rect width='9' height='9' fill='url(#f)'/>";
  const ImportedSvg crowded = painted_drawing(kFade + many + "</mask>" + kMaskedSquare);
  ASSERT_EQ(crowded.warnings.size(), 1u);
  EXPECT_NE(crowded.warnings[0].message.find("the mask #m is left out"), std::string::npos);
  EXPECT_EQ(alphas_at(crowded, {{50, 50}}), (std::vector<int>{255}));
}

TEST(ImportMask, a_cancelled_import_ends) {
  Context context;
  context.cancel = true;
  const auto result = import_svg(context,
                                 "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'>" +
                                     kFade + mask_of(kFadeRect) + kMaskedSquare + "</svg>",
                                 "mask.svg");
  ASSERT_FALSE(result);
  EXPECT_EQ(result.status().code, StatusCode::cancelled);
}

TEST(ImportMask, mistakes_mask_nothing_and_are_named) {
  for (const char* mask : {"", "<rect id='m'/>", "<mask id='m' width='much'/>",
                           "<mask id='m'><text>abc</text></mask>"}) {
    const ImportedSvg made = masked_drawing(mask + kMaskedSquare);
    EXPECT_EQ(alphas_at(made, {{50, 50}}), (std::vector<int>{255})) << mask;
    ASSERT_EQ(made.warnings.size(), 1u) << mask;
    EXPECT_NE(made.warnings[0].message.find("mask of <rect>"), std::string::npos);
  }
  const ImportedSvg image =
      masked_drawing("<rect width='50' height='50' style='mask:linear-gradient(red,blue)'/>");
  ASSERT_EQ(image.warnings.size(), 1u);
}

TEST(ImportMask, a_hidden_mask_hides_and_a_fill_with_a_stroke_is_one) {
  EXPECT_TRUE(
      masked_drawing(mask_of("<rect width='99' height='99' fill='#fff'/>", "visibility='hidden'") +
                     kMaskedSquare)
          .document.stack.empty());
  const ImportedSvg made = painted_drawing(
      kFade + mask_of(kFadeRect) +
      "<rect x='20' y='20' width='60' height='60' stroke='red' stroke-width='20' mask='url(#m)'/>");
  EXPECT_TRUE(made.warnings.empty());
  expect_near(alphas_at(made, {{25, 50}, {50, 50}, {75, 50}}), {190, 126, 62});
}

TEST(ImportMask, layers_of_sfumato_are_not_masked) {
  const ImportedSvg made =
      masked_drawing(mask_of("<rect width='50' height='100' fill='#fff'/>") +
                     "<g xmlns:sf='urn:sfumato:1' sf:diffuse='true' mask='url(#m)'>"
                     "<path d='M20 20H80' sf:left='red' sf:right='blue'/></g>");
  ASSERT_GE(made.warnings.size(), 1u);
  EXPECT_TRUE(std::ranges::any_of(made.warnings, [](const Diagnostic& warning) {
    return warning.message.find("do not cut it") != std::string::npos;
  }));
}

TEST(ImportMask, a_symbol_may_have_one) {
  const ImportedSvg made = masked_drawing(
      mask_of("<rect width='50' height='100' fill='#fff'/>") +
      "<symbol id='s' viewBox='0 0 10 10' mask='url(#m)'><rect width='10' height='10'/></symbol>"
      "<use href='#s' width='80' height='80'/>");
  EXPECT_TRUE(made.warnings.empty());
  expect_near(alphas_at(made, {{40, 40}, {60, 40}}), {255, 0}, 0);
}

TEST(ImportMask, what_is_under_a_mask_or_in_a_transparent_group_is_no_background) {
  const std::string rect = "<rect width='100' height='100' fill='#06c' ";
  const ImportedSvg masked = masked_drawing(kFade + mask_of(kFadeRect) + rect + "mask='url(#m)'/>");
  EXPECT_FALSE(masked.document.background);
  const ImportedSvg grouped = masked_drawing("<g opacity='.5'>" + rect + "/></g>");
  EXPECT_FALSE(grouped.document.background);
  EXPECT_EQ(alphas_at(grouped, {{50, 50}}), (std::vector<int>{128}));
}

/// Returns a mask as Illustrator writes it.
std::string filtered_mask(const std::string& filter, const std::string& content) {
  return "<filter id='o' filterUnits='userSpaceOnUse' x='0' y='0' width='100' height='100'>" +
         filter + "</filter>" + mask_of("<g filter='url(#o)'>" + content + "</g>");
}

TEST(ImportMask, filters_of_illustrator_are_read) {
  const std::string grey = "<rect width='50' height='100' fill='#404040'/>";
  const std::string flood =
      "<feFlood style='flood-color:white;flood-opacity:1' result='back'/>"
      "<feBlend in='SourceGraphic' in2='back' mode='normal'/>";
  const ImportedSvg laid = painted_drawing(filtered_mask(flood, grey) + kMaskedSquare);
  EXPECT_TRUE(laid.warnings.empty());
  expect_near(alphas_at(laid, {{30, 50}, {70, 50}}), {64, 255}, 1);
  const ImportedSvg same = masked_drawing(
      filtered_mask("<feColorMatrix values='1 0 0 0 0 0 1 0 0 0 0 0 1 0 0 0 0 0 1 0'/>", grey) +
      kMaskedSquare);
  EXPECT_TRUE(same.warnings.empty());
  expect_near(alphas_at(same, {{30, 50}, {70, 50}}), {64, 0}, 1);
  const std::string inverse =
      "<feColorMatrix color-interpolation-filters='sRGB' "
      "values='-1 0 0 0 1, 0 -1 0 0 1, 0 0 -1 0 1, 0 0 0 1 0'/>";
  const ImportedSvg inverted = masked_drawing(filtered_mask(inverse, grey) + kMaskedSquare);
  EXPECT_TRUE(inverted.warnings.empty());
  expect_near(alphas_at(inverted, {{30, 50}, {70, 50}}), {191, 0}, 1);
  const ImportedSvg faded =
      masked_drawing(kFade + filtered_mask(inverse, kFadeRect) + kMaskedSquare);
  EXPECT_TRUE(faded.warnings.empty());
  expect_near(alphas_at(faded, {{25, 50}, {75, 50}}), {65, 193});
  const ImportedSvg drawn =
      painted_drawing(kFade + filtered_mask(inverse, kFadeRect + grey) + kMaskedSquare);
  EXPECT_TRUE(drawn.warnings.empty());
  expect_near(alphas_at(drawn, {{30, 50}, {75, 50}}), {191, 193});
  const ImportedSvg other = masked_drawing(
      filtered_mask("<feColorMatrix type='saturate' values='.5'/>", grey) + kMaskedSquare);
  EXPECT_EQ(other.warnings.size(), 1u);
}

TEST(ImportMask, linear_light_is_darker) {
  const std::string grey = "<rect width='100' height='100' fill='#808080'/>";
  const ImportedSvg made =
      masked_drawing(mask_of(grey, "color-interpolation='linearRGB'") + kMaskedSquare);
  expect_near(alphas_at(made, {{50, 50}}), {55}, 1);
  const ImportedSvg faded = painted_drawing(
      kFade + mask_of(kFadeRect, "color-interpolation='linearRGB'") + kMaskedSquare);
  expect_near(alphas_at(faded, {{50, 50}}), {54}, 2);
}

}  // namespace
}  // namespace sfumato
