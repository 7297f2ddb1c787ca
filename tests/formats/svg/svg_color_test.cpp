// CSS Color 4 colours in all places where a document has a colour.
#include <gtest/gtest.h>

#include "formats/each_text.hpp"
#include "formats/svg/svg_support.hpp"

namespace sfumato::test {
namespace {

constexpr const char* kMappedWarning =
    ": the colour \"color(display-p3 0 1 0)\" lies outside sRGB; such colours become the nearest "
    "ones of sRGB, as CSS Color 4 maps them";

std::string colored_curve(const std::string& attributes) {
  return svg_layer("<path d='M0 0h9' " + attributes + "/>");
}

std::string gradient_of_stop(const std::string& stop, const std::string& head = "") {
  return svg(
      head + "<linearGradient id='a'><stop " + stop +
      "/></linearGradient>\n<g sf:diffuse='true'><path d='M0 0h9v9' sf:left='url(#a)'/></g>");
}

/// Returns "#rrggbb" of a colour.
std::string hex_of(const Rgb& color) {
  std::string text = "#";
  for (const float channel : {color.r, color.g, color.b}) {
    const int code = static_cast<int>(channel * 255 + .5f);
    text += "0123456789abcdef"[code / 16];
    text += "0123456789abcdef"[code % 16];
  }
  return text;
}

std::string left_color_of(const std::string& colors) {
  const ReadDocument document = read(colored_curve("sf:left='" + colors + "'"));
  EXPECT_TRUE(document.warnings.empty()) << to_string(document.warnings[0]);
  const Curve& curve = document.document.layers.at(0).curves.at(0);
  return hex_of(curve.left.color.stops.stops.at(0).value);
}

std::string stop_color_of(const std::string& text) {
  const ReadDocument document = read(text);
  EXPECT_TRUE(document.warnings.empty()) << to_string(document.warnings[0]);
  return hex_of(std::get<GradientFill>(document.document.shaders.at(0).paint).stops.at(0).color);
}

TEST(SvgColor, curves_take_every_notation) {
  expect_of_each({"oklch(0.7 0.15 250)", "oklch(70% 37.5% 250deg), red", "OKLCH(.7 .15 -110)",
                  "oklch(/**/.7 .15 250) 0%, red 50%"},
                 left_color_of, "#4ba3f7");
  expect_of_each({"lab(50 40 -60)", "color(srgb 0.549240 0.370440 0.874380)"}, left_color_of,
                 "#8c5edf");
}

TEST(SvgColor, stops_of_gradients_take_them_in_attributes_styles_and_sheets) {
  expect_of_each(
      {gradient_of_stop("stop-color='oklch(0.7 0.15 250)'"),
       gradient_of_stop("style='stop-color:oklch(0.7 0.15 250)'"),
       gradient_of_stop("style='color:oklch(0.7 0.15 250);stop-color:currentColor'"),
       gradient_of_stop("class='k'", "<style>.k{stop-color:oklch(0.7 0.15 250)}</style>")},
      stop_color_of, "#4ba3f7");
}

TEST(SvgColor, backgrounds_take_them) {
  const std::string layer = "<g sf:diffuse='true'><path d='M0 0h9' sf:left='red'/></g>";
  const auto background = [&](const std::string& content, const std::string& attributes) {
    return hex_of(read(svg(content + layer, attributes)).document.background.value_or(Rgb{}));
  };
  EXPECT_EQ(background("", "sf:background='oklab(0.5 0.1 -0.1)'"), "#81459a");
  EXPECT_EQ(background("<rect width='100' height='50' fill='lch(60 60 130)'/>", ""), "#58a137");
}

TEST(SvgColor, those_outside_srgb_are_mapped_with_one_warning) {
  const ReadDocument document =
      read(colored_curve("sf:left='red, color(display-p3 0 1 0)' sf:right='color(rec2020 0 1 0)'"));
  ASSERT_EQ(document.warnings.size(), 1u);
  EXPECT_EQ(to_string(document.warnings[0]),
            std::string("a.svg:3:1: sf:left of <path>") + kMappedWarning);
  const Curve& curve = document.document.layers.at(0).curves.at(0);
  EXPECT_EQ(hex_of(curve.left.color.stops.stops.at(1).value), "#00fb29");
}

TEST(SvgColor, the_warning_names_the_attribute_of_each_place) {
  const std::string color = "color(display-p3 0 1 0)";
  const auto warning = [](const std::string& text) {
    const ReadDocument document = read(text);
    EXPECT_EQ(document.warnings.size(), 1u);
    return document.warnings.empty() ? "" : to_string(document.warnings[0]);
  };
  EXPECT_EQ(warning(gradient_of_stop("style='stop-color:" + color + "'")),
            std::string("a.svg:2:24: stop-color of <stop>") + kMappedWarning);
  EXPECT_EQ(warning(svg("<g sf:diffuse='true'><path d='M0 0h9' sf:left='red'/></g>",
                        "sf:background='" + color + "'")),
            std::string("a.svg:1:1: sf:background of <svg>") + kMappedWarning);
  EXPECT_EQ(warning(svg("<path d='M0 0h9' sf:radius='2' sf:left='" + color + "'/>")),
            std::string("a.svg:2:1: sf:left of <path>") + kMappedWarning);
}

TEST(SvgColor, errors_say_what_is_wrong_within_a_colour) {
  const auto error = [](const std::string& color) {
    return status_of(colored_curve("sf:left='" + color + "'")).message;
  };
  EXPECT_EQ(error("lab(1, 2, 3)"),
            "sf:left of <path>: \"lab(1, 2, 3)\" is not a colour: lab() takes no commas; use "
            "lab(50 40 -60), or lab(50 40 -60 / 50%) with an alpha");
  EXPECT_EQ(error("color(p3 1 0 0)"),
            "sf:left of <path>: \"color(p3 1 0 0)\" is not a colour: \"p3\" is not a colour space; "
            "use one of srgb, srgb-linear, display-p3, display-p3-linear, a98-rgb, "
            "prophoto-rgb, rec2020, xyz, xyz-d50, xyz-d65");
  EXPECT_EQ(error("oklch(0.7 0.1 20%)"),
            "sf:left of <path>: \"oklch(0.7 0.1 20%)\" is not a colour: \"20%\" is not valid here; "
            "use a hue: a number of degrees, or an angle in deg, grad, rad or turn");
}

TEST(SvgColor, a_dropped_colour_is_told_with_its_cause) {
  const ReadDocument document = read(gradient_of_stop("style='stop-color:lab(1, 2, 3)'"));
  ASSERT_EQ(document.warnings.size(), 1u);
  EXPECT_EQ(document.warnings[0].message,
            "\"stop-color: lab(1, 2, 3)\" is left out: its value is not understood; \"lab(1, 2, "
            "3)\" is not a colour: lab() takes no commas; use lab(50 40 -60), or lab(50 40 -60 / "
            "50%) with an alpha");
}

}  // namespace
}  // namespace sfumato::test
