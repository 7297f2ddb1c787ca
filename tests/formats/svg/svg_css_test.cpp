// The values of styles, as in browsers.
#include <gtest/gtest.h>

#include "formats/each_text.hpp"
#include "formats/svg/svg_support.hpp"

namespace sfumato::test {
namespace {

/// Returns the colour and opacity of a gradient's only stop: "#f00", "#f00 .5".
std::string stop_of(const std::string& attributes, const std::string& head = "",
                    std::size_t warnings = 0) {
  const ReadDocument document = read(
      svg(head + "<linearGradient id='a'><stop " + attributes +
          "/></linearGradient><g sf:diffuse='true'><path d='M0 0h9v9' sf:left='url(#a)'/></g>"));
  EXPECT_EQ(document.warnings.size(), warnings)
      << attributes << head << (document.warnings.empty() ? "" : to_string(document.warnings[0]));
  const GradientStop stop =
      std::get<GradientFill>(document.document.shaders.at(0).paint).stops.at(0);
  std::string text = "#";
  for (const float channel : {stop.color.r, stop.color.g, stop.color.b}) {
    text += "0123456789abcdef"[static_cast<int>(channel * 15 + .5f)];
  }
  return stop.alpha == 1 ? text : text + " " + std::to_string(stop.alpha).substr(1, 3);
}

std::string styled(const std::string& style) {
  return stop_of("style=\"" + style + "\"");
}

/// The same for a stop of the class k.
std::string by_sheet(const std::string& sheet, const std::string& attributes = "",
                     std::size_t warnings = 0) {
  return stop_of("class='k' id='i' " + attributes, "<style>" + sheet + "</style>", warnings);
}

std::string sheet_alone(const std::string& sheet) {
  return by_sheet(sheet);
}

std::string sheet_with_warning(const std::string& sheet) {
  return by_sheet(sheet, "", 1);
}

TEST(SvgCss, comments_and_case_change_nothing) {
  expect_of_each(
      {"/* c */stop-color:red", "stop-color:red/* c */", "stop-color/**/:/**/red", "Stop-Color:RED",
       "stop-color:red !IMPORTANT", "st\\6fp-color:r\\65 d",
       "font-family:';stop-color:lime';stop-color:red", "a:url(;stop-color:lime);stop-color:red"},
      styled, "#f00");
}

TEST(SvgCss, sheets_know_comments_strings_escapes_and_markers) {
  expect_of_each(
      {".k/* x */{stop-color:red}", ".j{font-family:\"}\"} .k{stop-color:red}",
       ".j{a:'{';b:url(});c:({[)}]})} .k{stop-color:red}",
       "<![CDATA[<!-- .k{stop-color:red} -->]]>", ".\\6b{stop-color:red}", ".k{stop-color:red"},
      sheet_alone, "#f00");
  EXPECT_EQ(by_sheet(".K{stop-color:red}"), "#000") << "classes have a case";
  EXPECT_EQ(by_sheet("STOP{stop-color:red}"), "#000") << "elements of XML have a case";
  EXPECT_EQ(by_sheet(".k{stop-<![CDATA[color:r]]>ed}"), "#f00") << "the texts are one";
}

TEST(SvgCss, importance_goes_before_the_style_attribute_and_that_before_order) {
  const std::string lime = "style='stop-color:lime'";
  EXPECT_EQ(by_sheet(".k{stop-color:red !important}", lime), "#f00");
  EXPECT_EQ(by_sheet(".k{stop-color:red !important}", "style='stop-color:lime !important'"),
            "#0f0");
  expect_of_each({".k{stop-color:red !important} .k{stop-color:lime}",
                  "*{stop-color:red !important} #i{stop-color:lime}",
                  "#i{stop-color:red !important} .k{stop-color:lime !important}",
                  "stop{stop-color:red} *{stop-color:lime}"},
                 sheet_alone, "#f00");
  EXPECT_EQ(by_sheet(".k{stop-color:lime} .k{stop-color:red}", "stop-color='blue'"), "#f00");
  EXPECT_EQ(styled("stop-color:red !important;stop-color:lime"), "#f00");
  EXPECT_EQ(styled("stop-color:red !important;stop-color:lime!important"), "#0f0");
}

TEST(SvgCss, what_css_drops_says_nothing) {
  EXPECT_EQ(stop_of("style='stop-color:red;stop-color:reddish'", "", 1), "#f00");
  EXPECT_EQ(stop_of("stop-color='red' style='stop-color:'", "", 1), "#f00");
  EXPECT_EQ(styled("stop-color:red;stop-color lime;:blue;stop-color"), "#f00");
  EXPECT_EQ(stop_of("style='stop-opacity:.5;stop-opacity:1px;stop-opacity:1 1'", "", 1),
            "#000 .50");
  EXPECT_EQ(by_sheet("1{} .k{stop-color:red}", "", 1), "#f00");
  EXPECT_EQ(by_sheet(".k{stop-color:red} .k,,b{stop-color:lime}", "", 1), "#f00");
  EXPECT_EQ(by_sheet(".k{stop-color:red} .k,a:b{stop-color:lime}", "", 1), "#0f0")
      << "what is not read leaves the others";
  EXPECT_EQ(by_sheet(".k{stop-color:red} .k{a{stop-color:lime}}"), "#f00");
}

TEST(SvgCss, a_dropped_value_is_told_with_what_was_meant) {
  EXPECT_EQ(warnings_of(svg("<g style='mix-blend-mode:scren'/><g sf:diffuse='true'><path d='M0 "
                            "0h9' sf:left='red'/></g>"))[0],
            "a.svg:2:1: \"mix-blend-mode: scren\" is left out: its value is not understood; did "
            "you mean screen?");
}

TEST(SvgCss, media_and_type_say_which_sheets_count) {
  std::size_t warnings = 0;
  const auto by = [&warnings](const std::string& attributes) {
    return stop_of("class='k'", "<style " + attributes + ">.k{stop-color:red}</style>", warnings);
  };
  expect_of_each({"", "media=''", "media='all'", "media='SCREEN'", "media='print,screen'",
                  "type=''", "type='text/css'", "type='TEXT/CSS'"},
                 by, "#f00");
  expect_of_each({"media='print'", "media='not screen'"}, by, "#000");
  warnings = 1;
  expect_of_each(
      {"media='(min-width: 1px)'", "type='text/x-scss'", "type='text/css;charset=utf-8'"}, by,
      "#000");
}

TEST(SvgCss, at_rules_are_passed_over_but_for_media_of_a_screen) {
  expect_of_each({"@charset 'utf-8';.k{stop-color:red}", "@import url(a;b);.k{stop-color:red}",
                  "@font-face{font-family:'}'}.k{stop-color:red}",
                  "@supports (a:b){.k{stop-color:lime}}.k{stop-color:red}",
                  "@media screen{a} .k{stop-color:red}"},
                 sheet_with_warning, "#f00");
  expect_of_each(
      {"@MEDIA screen{.j{}.k{stop-color:red}}", "@media all{@media screen{.k{stop-color:red}}}",
       "@media print{.k{stop-color:lime}} .k{stop-color:red}",
       ".k{stop-color:red} @media print{@media screen{.k{stop-color:lime}}}",
       ".k{stop-color:red;@media screen{stop-color:lime}}"},
      sheet_alone, "#f00");
}

TEST(SvgCss, words_for_every_property_are_understood) {
  expect_of_each(
      {"stop-color='red' style='stop-color:initial'", "stop-color='red' style='stop-color:UNSET'",
       "stop-color='red' style='stop-color:revert'", "stop-color='red' style='all:initial'",
       "stop-color='inherit'"},
      [](const std::string& attributes) { return stop_of(attributes); }, "#000");
  EXPECT_EQ(stop_of("stop-color='red' style='stop-color:revert-layer'"), "#f00");
  EXPECT_EQ(stop_of("stop-color='red' style='all:red'"), "#f00");
  EXPECT_EQ(stop_of("stop-color='currentColor' color='red'"), "#f00");
  EXPECT_EQ(stop_of("style='stop-color:CurrentColor'", "<style>svg{color:red}</style>"), "#f00");
}

float opacity_of(const std::string& group, const std::string& layer) {
  const ReadDocument document = read(svg("<g " + group + "><g sf:diffuse='true' " + layer +
                                         "><path d='M0 0h9' sf:left='red'/></g></g>"));
  EXPECT_TRUE(document.warnings.empty()) << to_string(document.warnings[0]);
  const auto* instance = std::get_if<LayerInstance>(&document.document.stack.at(0));
  return instance ? instance->opacity : -1;
}

TEST(SvgCss, opacity_is_inherited_only_where_it_says_so) {
  EXPECT_EQ(opacity_of("opacity='.5'", ""), .5f);
  EXPECT_EQ(opacity_of("opacity='.5'", "opacity='inherit'"), .25f);
  EXPECT_EQ(opacity_of("style='opacity:50%'", "style='opacity:INHERIT'"), .25f);
  EXPECT_EQ(opacity_of("", "opacity='inherit'"), 1);
  EXPECT_EQ(opacity_of("opacity='initial'", "opacity='.5' style='opacity:unset'"), 1);
  EXPECT_EQ(opacity_of("", "style='/* note */ opacity:.25'"), .25f);
}

TEST(SvgCss, display_and_visibility_have_any_case) {
  const auto layers = [](const std::string& attributes) {
    return read(svg("<g " + attributes +
                    "><g sf:diffuse='true'><path d='M0 0h9' sf:left='red'/></g></g>"))
        .document.layers.size();
  };
  expect_of_each({"style='DISPLAY:none'", "style='display:None'", "display='NONE'",
                  "style='display:none;display:nonsense'"},
                 layers, 0u);
  EXPECT_EQ(layers("style='display:none;display:inline flow-root'"), 1u);
  EXPECT_EQ(layers("style='Visibility:HIDDEN'"), 0u);
  EXPECT_EQ(layers("visibility='hidden' style='visibility:initial'"), 1u);
}

TEST(SvgCss, display_and_visibility_of_the_document_hold_for_all_of_it) {
  const auto layers = [](const std::string& attributes) {
    const std::string layer = "<g sf:diffuse='true'><path d='M0 0h9' sf:left='red'/></g>";
    return read(svg(layer + "<g visibility='visible'>" + layer + "</g>", attributes))
        .document.stack.size();
  };
  EXPECT_EQ(layers(""), 2u);
  EXPECT_EQ(layers("visibility='hidden'"), 1u);
  EXPECT_EQ(layers("style='visibility:initial' visibility='hidden'"), 2u);
  EXPECT_EQ(layers("display='none'"), 0u);
}

TEST(SvgCss, current_color_of_a_color_is_the_one_around_it) {
  const auto color = [](const std::string& around, const std::string& own) {
    return read(svg("<rect width='100' height='50' fill='currentColor' " + own + "/>", around))
        .document.background;
  };
  EXPECT_EQ(color("color='red'", "color='currentColor'"), color("color='red'", ""));
  EXPECT_EQ(color("color='red'", "style='--c:CURRENTCOLOR;color:var(--c)'"),
            color("color='red'", ""));
  EXPECT_EQ(color("color='currentcolor'", ""), color("", ""));
}

TEST(SvgCss, paint_may_stand_behind_any_number_of_addresses) {
  EXPECT_EQ(styled("fill:url(#a) url(#b) red"), "#000");
  std::string addresses;
  for (int i = 0; i < 300'000; ++i) addresses += "url(#a)";
  EXPECT_EQ(styled("fill:" + addresses + ";stop-color:red"), "#f00");
}

TEST(SvgCss, block_in_a_custom_property_that_is_none_begins_nothing) {
  EXPECT_EQ(sheet_alone("stop{--a:{}--b:{}stop-color:lime;)}"), "#000");
  EXPECT_EQ(sheet_alone("stop{--a:{}--b:{})!;stop-color:lime}"), "#0f0");
  EXPECT_EQ(sheet_alone("stop{--a:{}stop-color:lime;--b:{})}"), "#000");
  std::string blocks;
  for (int i = 0; i < 100'000; ++i) blocks += "--a:{}";
  EXPECT_EQ(sheet_alone("stop{" + blocks + "!;stop-color:lime}"), "#0f0");
}

TEST(SvgCss, fill_of_the_background_is_inherited_as_css_says) {
  const auto background = [](const std::string& group, const std::string& rect) {
    return read(svg("<g " + group + "><rect width='100%' height='100%' " + rect + "/></g>"))
        .document.background;
  };
  const Rgb red{1, 0, 0}, black{0, 0, 0};
  EXPECT_EQ(background("fill='red'", ""), red);
  EXPECT_EQ(background("style='fill:red'", "fill='inherit'"), red);
  EXPECT_EQ(background("fill='red'", "style='fill:unset'"), red);
  EXPECT_EQ(background("fill='red'", "style='fill:initial'"), black);
  EXPECT_EQ(background("color='red'", "fill='currentColor'"), red);
  EXPECT_EQ(background("", "style='FILL:/**/NONE'"), std::nullopt);
}

TEST(SvgCss, lists_of_stops_are_cut_by_the_same_tokens) {
  const auto stops = [](const std::string& list) {
    return curve_of("<path d='M0 0h9' sf:left=\"" + list + "\"/>").left.color.stops.stops;
  };
  EXPECT_EQ(stops("red/* , lime */ 30%,/**/RGB(0 0 255)"), stops("red 30%, blue"));
  EXPECT_EQ(stops("r\\65 d/**/30%"), stops("red 30%"));
  EXPECT_EQ(curve_of("<path d='M0 0h9' sf:left='NONE'/>").left.color.kind, ShaderKind::barrier);
  EXPECT_EQ(status_of(svg_layer("<path d='M0 0h9' sf:left='red blue'/>")).message,
            "sf:left of <path>: the offset \"blue\" is none; use 0% to 100% of the length, or "
            "@ and a segment like @2.5; did you mean \"red, blue\"?");
  EXPECT_EQ(status_of(svg_layer("<path d='M0 0h9' sf:left='red 0.5'/>")).message,
            "sf:left of <path>: the offset \"0.5\" is none; use 0% to 100% of the length, or "
            "@ and a segment like @2.5; did you mean 50%?");
  EXPECT_TRUE(status_of(svg_layer("<path d='M0 0h9' sf:left='red 50, lime'/>"))
                  .message.ends_with("; did you mean 50%?"));
}

}  // namespace
}  // namespace sfumato::test
