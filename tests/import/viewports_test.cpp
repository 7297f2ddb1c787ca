// Viewports: percentages within them, the root's own properties, overflow.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <variant>

#include "sfumato/import/import_svg.hpp"

namespace sfumato {
namespace {

/// Returns a picture with these attributes of <svg>, and a content.
ImportedSvg viewed(const std::string& content,
                   const std::string& attributes = "viewBox='0 0 100 100'") {
  Context context;
  auto result = import_svg(
      context, "<svg xmlns='http://www.w3.org/2000/svg' " + attributes + ">" + content + "</svg>",
      "a.svg");
  EXPECT_TRUE(result) << (result ? "" : result.status().message);
  return result ? std::move(*result) : ImportedSvg{};
}

/// Returns left, top, right and bottom of all curves in the picture.
std::string box_of_viewed(const ImportedSvg& made) {
  Box box;
  for (const StackItem& item : made.document.stack) {
    const auto* instance = std::get_if<LayerInstance>(&item);
    if (!instance) continue;
    for (const Curve& curve : made.document.layers[instance->layer].curves) {
      for (const Vec2 point : curve.control_points) {
        box.extend(instance->artboard_from_layer(point));
      }
    }
  }
  if (made.document.layers.empty()) return "nothing";
  std::string text;
  for (const double value : {box.min.x, box.min.y, box.max.x, box.max.y}) {
    text += (text.empty() ? "" : " ") + std::to_string(std::lround(value));
  }
  return text;
}

std::string only_warning(const ImportedSvg& made) {
  EXPECT_EQ(made.warnings.size(), 1u);
  return made.warnings.empty() ? "" : made.warnings[0].message;
}

const std::string kHalfRect = "<rect width='50%' height='50%'/>";
const std::string kTwentySquare = "<rect x='20' y='20' width='20' height='20'/>";

TEST(ImportViewports, percentages_are_of_the_nearest_viewport) {
  EXPECT_EQ(
      box_of_viewed(viewed("<svg x='10' y='10' width='40' height='20'>" + kHalfRect + "</svg>")),
      "10 10 30 20");
  EXPECT_EQ(box_of_viewed(
                viewed("<svg width='40' height='40' viewBox='0 0 10 10'>" + kHalfRect + "</svg>")),
            "0 0 20 20");
  EXPECT_EQ(box_of_viewed(viewed("<svg width='40' height='40'><svg viewBox='0 0 10 10'>" +
                                 kHalfRect + "</svg></svg>")),
            "0 0 20 20")
      << "without a size it is as large as the one around it";
  EXPECT_EQ(box_of_viewed(viewed("<symbol id='s'>" + kHalfRect +
                                 "</symbol><use href='#s' width='80' height='40'/>")),
            "0 0 40 20");
  EXPECT_EQ(box_of_viewed(viewed("<svg width='40' height='40'><g id='g'><use href='#r' x='50%'/>"
                                 "</g></svg><defs><rect id='r' width='5' height='5'/></defs>")),
            "20 0 25 5");
  EXPECT_EQ(box_of_viewed(viewed("<svg width='40' height='40'/>" + kHalfRect)), "0 0 50 50");
}

TEST(ImportViewports, percentages_of_strokes_and_gradients_are_of_it_too) {
  EXPECT_EQ(box_of_viewed(viewed("<svg overflow='visible' width='50' height='50'>"
                                 "<path d='M20 20h10' stroke='red' stroke-width='20%'/></svg>")),
            "20 15 30 25");
  const ImportedSvg made = viewed(
      "<linearGradient id='g' gradientUnits='userSpaceOnUse'><stop/><stop offset='1' "
      "stop-color='red'/></linearGradient><rect width='9' height='9' fill='url(#g)'/>"
      "<svg width='40' height='40'><rect y='20' width='9' height='9' fill='url(#g)'/></svg>");
  ASSERT_EQ(made.document.shaders.size(), 2u);
  const auto end_of = [&](std::size_t i) {
    const auto& fill = std::get<GradientFill>(made.document.shaders[i].paint);
    return std::get<LinearGradient>(fill.shape).end.x;
  };
  EXPECT_EQ(end_of(0), 100);
  EXPECT_EQ(end_of(1), 40);
}

TEST(ImportViewports, a_rect_over_a_viewport_within_is_no_background) {
  const ImportedSvg made = viewed(
      "<svg overflow='visible' width='40' height='40'><rect width='100%' height='100%'/></svg>");
  EXPECT_FALSE(made.document.background);
  EXPECT_EQ(box_of_viewed(made), "0 0 40 40");
}

TEST(ImportViewports, overflow_is_hidden_unless_something_else_is_said) {
  const auto cut = [](const std::string& attributes) {
    return box_of_viewed(viewed("<g overflow='hidden'><svg width='9' height='9' " + attributes +
                                "><rect width='20' height='20'/></svg></g>"));
  };
  for (const char* hidden : {"", "overflow='hidden'", "overflow='scroll'", "overflow='inherit'",
                             "style='overflow:revert'", "overflow='much'"}) {
    EXPECT_EQ(cut(hidden), "0 0 9 9") << hidden;
  }
  for (const char* visible :
       {"overflow='visible'", "overflow='auto'", "overflow='initial'", "style='overflow:unset'"}) {
    EXPECT_EQ(cut(visible), "0 0 20 20") << visible;
  }
  EXPECT_EQ(box_of_viewed(viewed("<marker id='m' overflow='inherit'><rect width='20' height='5'/>"
                                 "</marker><path d='M10 10h5' marker-start='url(#m)'/>")),
            "10 10 30 15")
      << "what <svg> has is visible";
}

TEST(ImportViewports, a_symbol_has_a_transform) {
  EXPECT_EQ(box_of_viewed(viewed("<symbol id='s' transform='translate(30)'>" + kTwentySquare +
                                 "</symbol><use href='#s'/>")),
            "50 20 70 40");
}

TEST(ImportViewports, the_roots_transform_is_of_pixels_about_the_middle) {
  const std::string small = "width='200' height='200' viewBox='0 0 100 100' ";
  EXPECT_EQ(box_of_viewed(viewed(kTwentySquare, small + "transform='translate(20 40)'")),
            "30 40 50 60");
  EXPECT_EQ(box_of_viewed(viewed(kTwentySquare, small + "style='transform:rotate(180deg)'")),
            "60 60 80 80");
  EXPECT_EQ(
      box_of_viewed(viewed(kTwentySquare, small + "style='transform:scale(2);transform-origin:0'")),
      "40 -10 80 30")
      << "of one value the other is the middle";
  EXPECT_EQ(box_of_viewed(viewed(kTwentySquare,
                                 "width='200' height='100' viewBox='0 0 100 100' "
                                 "preserveAspectRatio='none' "
                                 "transform='translate(20)'")),
            "30 10 50 20");
  EXPECT_EQ(only_warning(viewed(kTwentySquare, "viewBox='0 0 9 9' transform='scale(x)'"))
                .find("transform of <svg>"),
            0u);
  EXPECT_EQ(only_warning(viewed(kTwentySquare, "viewBox='0 0 9 9' transform='scale(0)'")),
            "transform of <svg> cannot be inverted; use a transform that can; it is ignored");
  EXPECT_EQ(viewed(kTwentySquare, "transform='scale(2)'").warnings.back().message,
            "transform of <svg> is left out: <svg> has no size; add a viewBox");
}

TEST(ImportViewports, the_root_may_be_hidden) {
  for (const char* hidden : {"display='none'", "style='display:none'"}) {
    const ImportedSvg made = viewed(kTwentySquare, std::string("viewBox='0 0 9 9' ") + hidden);
    EXPECT_EQ(box_of_viewed(made), "nothing");
    EXPECT_EQ(only_warning(made), "the picture is empty: display of <svg> is none");
  }
}

TEST(ImportViewports, the_root_has_a_background) {
  const auto background = [](const std::string& attributes,
                             const std::string& content = kTwentySquare) {
    return viewed(content, "viewBox='0 0 100 100' " + attributes).document.background;
  };
  for (const char* style :
       {"background:#0f0", "background-color:#0f0", "background:red;background-color:lime",
        "background-color:currentColor;color:lime", "background:lime;background:url(a.png)"}) {
    EXPECT_EQ(background("style='" + std::string(style) + "'"), (Rgb{0, 1, 0})) << style;
  }
  EXPECT_FALSE(background("background-color='red'")) << "no attribute";
  EXPECT_FALSE(background("style='background:none'"));
  EXPECT_FALSE(background("style='background:transparent'"));
  EXPECT_FALSE(background("", "<g style='background:red'>" + kTwentySquare + "</g>"));
  EXPECT_EQ(background("style='background:red'", "<rect width='100' height='100' fill='#0f0'/>"),
            (Rgb{0, 1, 0}))
      << "what is painted lies over it";
}

TEST(ImportViewports, a_background_that_shines_through_is_a_shape_below_all) {
  const ImportedSvg made = viewed(kTwentySquare,
                                  "width='200' height='100' viewBox='0 0 100 100' "
                                  "style='background:#ff000080' opacity='.5'");
  EXPECT_FALSE(made.document.background);
  EXPECT_EQ(box_of_viewed(made), "-50 0 150 100");
  const auto& lowest = std::get<LayerInstance>(made.document.stack.at(0));
  EXPECT_NEAR(lowest.opacity, 128 / 255.0, 1e-6) << "the opacity of <svg> is not its own";
  EXPECT_EQ(viewed(kTwentySquare, "style='background:#ff000080'").warnings.back().message,
            "background of <svg> is left out: it is not opaque, and <svg> has no size");
}

TEST(ImportViewports, context_paints_are_those_of_the_use) {
  const auto colors = [](const std::string& content) {
    const ImportedSvg made =
        viewed("<defs><circle id='c' r='9' fill='context-stroke' stroke='none'/></defs>" + content);
    EXPECT_TRUE(made.warnings.empty());
    std::string text;
    for (const Layer& layer : made.document.layers) {
      for (const Curve& curve : layer.curves) {
        const Rgb color = curve.right.color.stops.stops.at(0).value;
        text += color.r > 0 ? "red " : color.g > 0 ? "green " : "blue ";
      }
    }
    return text;
  };
  EXPECT_EQ(colors("<use href='#c' stroke='red'/>"), "red ");
  EXPECT_EQ(colors("<g stroke='lime'><use href='#c'/></g>"), "green ");
  EXPECT_EQ(colors("<use href='#c'/>"), "") << "no stroke";
  EXPECT_EQ(colors("<defs><circle id='d' r='9' fill='url(#none) Context-Stroke' stroke='none'/>"
                   "</defs><use href='#d' stroke='red'/>"),
            "red ")
      << "as a fallback";
  EXPECT_EQ(colors("<circle r='9' fill='context-fill'/>"), "") << "no context";
  EXPECT_EQ(colors("<use id='u' href='#c' stroke='context-fill'/><use href='#u' fill='red' "
                   "stroke='blue' x='30'/>"),
            "red ")
      << "the inner <use> asks the outer one";
  EXPECT_EQ(colors("<marker id='m' overflow='visible'><use href='#c' stroke='context-fill'/>"
                   "</marker><path d='M20 20h9' fill='blue' marker-start='url(#m)'/>"),
            "blue ");
}

TEST(ImportViewports, a_gradient_of_the_context_spans_the_use) {
  const ImportedSvg made = viewed(
      "<linearGradient id='g'><stop/><stop offset='1' stop-color='red'/></linearGradient>"
      "<defs><g id='two'><rect width='10' height='10' fill='context-fill'/><rect x='30' "
      "width='10' height='10' fill='context-fill'/></g></defs><use href='#two' x='20' "
      "fill='url(#g)'/>");
  ASSERT_EQ(made.document.shaders.size(), 1u);
  EXPECT_EQ(std::get<GradientFill>(made.document.shaders[0].paint).layer_from_gradient,
            (Affine{40, 0, 0, 10, 20, 0}));
}

}  // namespace
}  // namespace sfumato
