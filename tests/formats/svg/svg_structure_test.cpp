// The parts of a document: artboard, layers, groups, background; ignored content and warnings.
#include <gtest/gtest.h>

#include "formats/svg/svg_support.hpp"

namespace sfumato::test {
namespace {

const std::string kCurve = "<path d='M0 0 h9' sf:left='red'/>";
const std::string kLayer = "<g sf:diffuse='true'>" + kCurve + "</g>";
Document document_of(const std::string& content, const std::string& attributes = "") {
  return read(svg(content, attributes)).document;
}

/// Returns "L" for a layer's instance, "S" for a stroke, "(" and ")" for a group, with opacities
/// under 1 and blend modes other than normal.
std::string stack_of(const Document& document) {
  std::string text;
  const auto effects = [](float opacity, BlendMode blend) {
    std::string shown;
    if (opacity != 1) shown += std::to_string(opacity).substr(1, 3);
    if (blend != BlendMode::normal) shown += "b" + std::to_string(static_cast<int>(blend));
    return shown;
  };
  for (const StackItem& item : document.stack) {
    if (const auto* instance = std::get_if<LayerInstance>(&item)) {
      text += "L" + std::to_string(instance->layer) + effects(instance->opacity, instance->blend);
    } else if (std::holds_alternative<LocalStroke>(item)) {
      text += "S";
    } else if (const auto* group = std::get_if<GroupBegin>(&item)) {
      text += "(" + effects(group->opacity, group->blend) + ":";
    } else {
      text += ")";
    }
  }
  return text;
}

std::string stack_of(const std::string& content) {
  return stack_of(document_of(content));
}

Box artboard_of(const std::string& attributes) {
  const std::string text = "<svg xmlns='http://www.w3.org/2000/svg' " + attributes + "/>";
  return read(text).document.artboard;
}

TEST(SvgArtboard, is_the_view_box) {
  EXPECT_EQ(artboard_of("viewBox='-1,2 30 40'"), (Box{{-1, 2}, {29, 42}}));
  EXPECT_EQ(artboard_of("viewBox='-1,2 30 40' width='60' height='80'"), (Box{{-1, 2}, {29, 42}}));
}

TEST(SvgArtboard, without_a_view_box_is_the_size_in_pixels) {
  EXPECT_EQ(artboard_of("width='2in' height='3pc'"), (Box{{0, 0}, {192, 48}}));
}

std::optional<Vec2> size_of(const std::string& attributes) {
  return read("<svg xmlns='http://www.w3.org/2000/svg' " + attributes + "/>").document.size_px;
}

TEST(SvgSize, is_of_width_and_height_beside_the_view_box) {
  const std::string box = "viewBox='0 0 8 6' ";
  EXPECT_EQ(size_of(box), std::nullopt);
  EXPECT_EQ(size_of("width='80' height='60'"), std::nullopt);
  EXPECT_EQ(size_of(box + "width='800' height='600'"), (Vec2{800, 600}));
  EXPECT_EQ(size_of(box + "width='800px' height='450pt'"), (Vec2{800, 600}));
  EXPECT_EQ(size_of(box + "width='2in' height='auto'"), (Vec2{192, 144}));
  EXPECT_EQ(size_of(box + "height='25.4mm'"), (Vec2{128, 96}));
  EXPECT_EQ(size_of(box + "width='100%' height='100%'"), std::nullopt);
  EXPECT_EQ(size_of(box + "width='50%' height='50%'"), (Vec2{4, 3}));
  EXPECT_EQ(size_of(box + "width='100%' height='60'"), (Vec2{80, 60}));
  EXPECT_EQ(size_of(box + "width='50%'"), std::nullopt);
}

TEST(SvgSize, that_cannot_be_read_is_told_and_left_out) {
  const std::vector<std::pair<std::string, std::string>> sides{
      {"-4", " is \"-4\"; use a length above 0"},
      {"0", " is \"0\"; use a length above 0"},
      {"3em", ": \"3em\" has an unknown unit; use px, pt, pc, mm, cm, in or %"},
      {"1e9",
       ": at character 1, before \"1e9\": expected a number of at most 10000000 in magnitude"},
      {"wide", ": at character 1, before \"wide\": expected a number"},
  };
  for (const auto& [side, wrong] : sides) {
    const ReadDocument read_document =
        read("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 8 6' height='60' width='" +
             side + "'/>");
    EXPECT_EQ(read_document.document.size_px, (Vec2{80, 60})) << side;
    ASSERT_FALSE(read_document.warnings.empty()) << side;
    EXPECT_EQ(read_document.warnings[0].message,
              "width of <svg>" + wrong + ": the viewBox says the size");
  }
}

TEST(SvgSize, of_another_aspect_shows_more_of_the_plane_or_less) {
  const std::string square = "viewBox='0 0 8 6' width='400' height='400' ";
  EXPECT_EQ(artboard_of(square), (Box{{0, -1}, {8, 7}}));
  EXPECT_EQ(artboard_of(square + "preserveAspectRatio='xMaxYMin'"), (Box{{0, 0}, {8, 8}}));
  EXPECT_EQ(artboard_of(square + "preserveAspectRatio='xMidYMax meet'"), (Box{{0, -2}, {8, 6}}));
  EXPECT_EQ(artboard_of(square + "preserveAspectRatio='slice'"), (Box{{0, -1}, {8, 7}}));
  EXPECT_EQ(artboard_of(square + "preserveAspectRatio='xMinYMid slice'"), (Box{{0, 0}, {6, 6}}));
  EXPECT_EQ(artboard_of(square + "preserveAspectRatio='none'"), (Box{{0, 0}, {8, 8}}));
  EXPECT_EQ(size_of(square), (Vec2{400, 400}));
  // Millimetres with a matching viewBox, which rounding makes slightly different.
  EXPECT_EQ(artboard_of("viewBox='0 0 210 297' width='210mm' height='297mm'"),
            (Box{{0, 0}, {210, 297}}));
}

TEST(SvgSize, stretches_all_that_is_painted) {
  const Document document =
      read(
          "<svg xmlns='http://www.w3.org/2000/svg' xmlns:sf='urn:sfumato:1' sf:version='1' "
          "viewBox='0 1 8 6' width='800' height='1200' preserveAspectRatio='none'>"
          "<rect y='1' width='100%' height='100%' fill='lime'/>" +
          kLayer + "<g transform='translate(3 4)'>" + kStroke + "</g></svg>")
          .document;
  EXPECT_EQ(document.artboard, (Box{{0, 2}, {8, 14}}));
  EXPECT_EQ(document.background, (Rgb{0, 1, 0}));
  ASSERT_EQ(document.stack.size(), 2u);
  EXPECT_EQ(std::get<LayerInstance>(document.stack[0]).artboard_from_layer,
            (Affine{1, 0, 0, 2, 0, 0}));
  EXPECT_EQ(std::get<LocalStroke>(document.stack[1]).artboard_from_stroke,
            (Affine{1, 0, 0, 2, 3, 8}));
}

TEST(SvgSettings, interpolation_is_code_values_unless_said) {
  EXPECT_EQ(document_of("").interpolation, InterpolationSpace::srgb);
  EXPECT_EQ(document_of("", "sf:interpolation='linear'").interpolation, InterpolationSpace::linear);
  EXPECT_EQ(document_of("", "sf:interpolation='oklab'").interpolation, InterpolationSpace::oklab);
}

TEST(SvgBackground, first_rect_over_the_view_box_is_the_background) {
  EXPECT_EQ(document_of("<rect width='100' height='50' fill='lime'/>").background, (Rgb{0, 1, 0}));
  EXPECT_EQ(document_of("<defs/><g><rect x='-9' y='-9' width='200%' height='200%' "
                        "style='fill:#00f;stroke:none'/></g>")
                .background,
            (Rgb{0, 0, 1}));
  EXPECT_EQ(document_of("<g fill='#f00' transform='scale(100 50)'><rect width='1' height='1'/></g>")
                .background,
            (Rgb{1, 0, 0}));
  EXPECT_EQ(document_of("<rect width='100%' height='100%'/>").background, (Rgb{0, 0, 0}));
}

TEST(SvgBackground, fill_none_is_none) {
  const ReadDocument read_document =
      read(svg("<rect width='100' height='50' fill='none'/>" + kLayer));
  EXPECT_EQ(read_document.document.background, std::nullopt);
  EXPECT_TRUE(read_document.warnings.empty());
}

TEST(SvgBackground, other_rects_are_ignored_with_a_warning) {
  for (const char* rect :
       {"<rect width='99' height='50'/>", "<rect width='100' height='50' opacity='.5'/>",
        "<rect width='100' height='50' fill='#ff000080'/>",
        "<rect width='100' height='50' transform='rotate(1)'/>",
        "<rect width='100' height='50' fill='url(#a)'/>"}) {
    const ReadDocument read_document = read(svg(rect + kLayer));
    EXPECT_EQ(read_document.document.background, std::nullopt) << rect;
    ASSERT_EQ(read_document.warnings.size(), 1u) << rect;
    EXPECT_EQ(to_string(read_document.warnings[0]),
              "a.svg:2:1: <rect> has no attribute of Sfumato and is ignored; put it in a "
              "layer, or a <rect> over the whole viewBox as the background");
  }
  const std::string rect = "<rect width='100' height='50'/>";
  EXPECT_EQ(document_of(kLayer + rect).background, std::nullopt);
  EXPECT_EQ(document_of("<path d='M0 0 h9'/>" + rect + kLayer).background, std::nullopt);
}

TEST(SvgBackground, the_setting_goes_before_the_rect) {
  const std::string rect = "<rect width='100' height='50' fill='lime'/>";
  EXPECT_EQ(document_of(rect, "sf:background='#f00'").background, (Rgb{1, 0, 0}));
  EXPECT_EQ(document_of(rect, "sf:background='none'").background, std::nullopt);
}

TEST(SvgLayers, stand_in_document_order_with_strokes_between) {
  EXPECT_EQ(stack_of(kLayer + kStroke + kLayer), "L0SL1");
}

TEST(SvgLayers, have_ids_opacity_and_blend_mode) {
  const Document document =
      document_of("<g id='a' sf:diffuse='true' opacity='.5' style='mix-blend-mode: multiply'>" +
                  kCurve + "</g>");
  EXPECT_EQ(document.layers[0].id, "a");
  EXPECT_EQ(stack_of(document), "L0.50b1");
}

TEST(SvgLayers, nested_groups_and_links_hold_layers) {
  EXPECT_EQ(stack_of("<g><a><g>" + kLayer + "</g></a>" + kLayer + "</g>"), "L0L1");
}

TEST(SvgLayers, what_is_not_displayed_is_left_out) {
  EXPECT_EQ(stack_of("<g display='none'>" + kLayer + "</g>" + kStroke), "S");
  EXPECT_EQ(stack_of("<g sf:diffuse='true' style='display:none'/>" + kStroke), "S");
  EXPECT_EQ(stack_of("<g visibility='hidden'>" + kLayer +
                     "<path visibility='visible' d='M0 0 h9' sf:left='red' sf:radius='2'/></g>"),
            "S");
  EXPECT_EQ(curves_of(kCurve + "<g display='none'>" + kCurve + "</g>").size(), 1u);
  EXPECT_EQ(curves_of(kCurve + "<path visibility='hidden' d='M0 0 h9'/>").size(), 1u);
}

TEST(SvgLayers, group_that_is_said_not_to_diffuse_is_plain) {
  EXPECT_EQ(stack_of("<g sf:diffuse='false'>" + kLayer + "</g>"), "L0");
}

TEST(SvgGroups, of_several_items_with_opacity_are_composited_as_one) {
  EXPECT_EQ(stack_of("<g opacity='50%'>" + kLayer + kStroke + "</g>" + kLayer), "(.50:L0S)L1");
  EXPECT_EQ(stack_of("<g style='isolation:isolate'>" + kLayer + kLayer + "</g>"), "(:L0L1)");
  EXPECT_EQ(stack_of("<g style='mix-blend-mode:screen'>" + kLayer + kLayer + "</g>"), "(b2:L0L1)");
}

TEST(SvgGroups, plain_ones_are_none) {
  EXPECT_EQ(stack_of("<g opacity='1' style='mix-blend-mode:normal;isolation:auto'>" + kLayer +
                     kLayer + "</g>"),
            "L0L1");
}

TEST(SvgGroups, of_one_layer_are_that_layer) {
  EXPECT_EQ(stack_of("<g opacity='.5'><g opacity='.5'>" + kLayer + "</g></g>"), "L0.25");
  EXPECT_EQ(stack_of("<g style='isolation:isolate'><g sf:diffuse='true' "
                     "style='mix-blend-mode:screen'>" +
                     kCurve + "</g></g>"),
            "L0");
}

TEST(SvgGroups, of_nothing_are_gone) {
  EXPECT_EQ(stack_of("<g opacity='.5'><g opacity='.5'/></g>" + kStroke), "S");
}

TEST(SvgGroups, stroke_with_opacity_is_one) {
  EXPECT_EQ(stack_of("<path d='M0 0 h9' sf:left='red' sf:radius='2' opacity='.5'/>"), "(.50:S)");
}

TEST(SvgStyles, style_goes_before_sheets_and_sheets_before_attributes) {
  const std::string sheet =
      "<style>/* a { } */ .dim, #x { opacity: .5; } g { opacity: .25 } #y { opacity: .75 }</style>";
  const auto opacity = [&](const std::string& attributes) {
    return stack_of(sheet + "<g sf:diffuse='true' opacity='.1' " + attributes + ">" + kCurve +
                    "</g>");
  };
  EXPECT_EQ(opacity(""), "L0.25");
  EXPECT_EQ(opacity("class='bright dim'"), "L0.50");
  EXPECT_EQ(opacity("class='dim' id='y'"), "L0.75");
  EXPECT_EQ(opacity("class='dim' style='opacity:.9'"), "L0.90");
  EXPECT_EQ(opacity("style='opacity:.9 !important;fill:url(a;b)'"), "L0.90");
}

TEST(SvgStyles, rules_that_are_not_read_are_told) {
  const auto warnings =
      warnings_of(svg("<style><![CDATA[ @import 'x'; g > path:nth-child(2) { opacity: 0 } "
                      ".a{opacity:.5}]]></style><g class='a' "
                      "sf:diffuse='true'>" +
                      kCurve + "</g>"));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0],
            "a.svg:2:1: the style rule \"@import 'x'\" is not read; use selectors "
            "of names, classes, ids and attributes");
}

TEST(SvgNamespaces, any_prefix_may_stand_for_ours_and_for_svg) {
  const ReadDocument read_document = read(
      "<s:svg xmlns:s='http://www.w3.org/2000/svg' xmlns:q='urn:sfumato:1' "
      "viewBox='0 0 9 9' q:version='1'><s:g q:diffuse='true'><s:path d='M0 0h9' "
      "q:left='red'/></s:g></s:svg>");
  ASSERT_EQ(read_document.document.layers.size(), 1u);
  EXPECT_EQ(read_document.document.layers[0].curves[0].left.color.kind, ShaderKind::curve_domain);
  EXPECT_TRUE(read_document.warnings.empty());
}

TEST(SvgNamespaces, others_are_ignored_silently) {
  const ReadDocument read_document =
      read(svg("<o:g xmlns:o='urn:other' sf:diffuse='true'>" + kCurve + "</o:g>" + kLayer +
               "<html xmlns='http://www.w3.org/1999/xhtml'><path/></html><x:unbound y:z='1'/>"));
  EXPECT_EQ(stack_of(read_document.document), "L0");
  EXPECT_TRUE(read_document.warnings.empty());
}

TEST(SvgNamespaces, our_name_without_its_namespace_is_not_ours) {
  const ReadDocument read_document =
      read(svg_layer("<path d='M0 0 h9' left='red' :left='red' xmlns:z='urn:z' z:left='red'/>"));
  EXPECT_EQ(read_document.document.layers[0].curves[0].left.color.kind, ShaderKind::open);
}

TEST(SvgEditors, file_as_inkscape_saves_it_is_read_without_a_warning) {
  const ReadDocument read_document =
      read(R"svg(<?xml version="1.0" encoding="UTF-8" standalone="no"?>
<!-- Created with Inkscape (http://www.inkscape.org/) -->
<svg width="210mm" height="297mm" viewBox="0 0 210 297" version="1.1" id="svg5"
   inkscape:version="1.2.2 (b0a8486541, 2022-12-01)" sodipodi:docname="drawing.svg"
   xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"
   xmlns:sodipodi="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd"
   xmlns:xlink="http://www.w3.org/1999/xlink" xmlns="http://www.w3.org/2000/svg"
   xmlns:svg="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" sf:version="1">
  <sodipodi:namedview id="namedview7" pagecolor="#ffffff" bordercolor="#666666" showgrid="false" />
  <defs id="defs2">
    <linearGradient inkscape:collect="always" id="linearGradient1">
      <stop style="stop-color:#ff0000;stop-opacity:1;" offset="0" id="stop1" />
      <stop style="stop-color:#0000ff;stop-opacity:0.5;" offset="1" id="stop2" />
    </linearGradient>
    <linearGradient inkscape:collect="always" xlink:href="#linearGradient1" id="linearGradient2"
       x1="10" y1="20" x2="110" y2="20" gradientUnits="userSpaceOnUse"
       gradientTransform="translate(1,2)" />
  </defs>
  <metadata id="metadata1"><rdf:RDF
     xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#"/></metadata>
  <g inkscape:label="Layer 1" inkscape:groupmode="layer" id="layer1" sf:diffuse="true"
     transform="matrix(0.26458333,0,0,0.26458333,0,0)" style="display:inline;opacity:0.8">
    <path id="path1" sodipodi:nodetypes="cc" inkscape:connector-curvature="0"
       style="fill:none;stroke:url(#linearGradient2);stroke-width:0.264583px;stroke-opacity:1"
       d="m 20,30 c 10,0 20,10 30,10" sf:left="url(#linearGradient2)" sf:right="#ffffff" />
    <ellipse id="path2" style="fill:#ff0000;stroke:none" cx="100" cy="100" rx="20" ry="10"
       sf:right="#ff0000 0%, #ff8800 50%, #ff0000" />
  </g>
</svg>)svg");
  EXPECT_TRUE(read_document.warnings.empty()) << to_string(read_document.warnings[0]);
  const Document& document = read_document.document;
  ASSERT_EQ(document.layers.size(), 1u);
  EXPECT_EQ(document.layers[0].curves[0].id, "path1");
  EXPECT_EQ(document.layers[0].curves[1].id, "path2");
  ASSERT_EQ(document.shaders.size(), 1u);
  const auto& gradient = std::get<GradientFill>(document.shaders[0].paint);
  ASSERT_EQ(gradient.stops.size(), 2u);
  EXPECT_EQ(gradient.stops[1].alpha, 0.5f);
  EXPECT_EQ(stack_of(document), "L0.80");
}

TEST(SvgEditors, file_as_illustrator_and_svgo_write_it_is_read) {
  const ReadDocument read_document = read(
      R"svg(<?xml version="1.0"?><!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" "svg11.dtd" [
 <!ENTITY ns_svg "http://www.w3.org/2000/svg"> <!ENTITY ns_xlink "http://www.w3.org/1999/xlink">]>
<svg xmlns="&ns_svg;" )svg"
      R"svg(xmlns:xlink="&ns_xlink;" xmlns:sf="urn:sfumato:1" width="9" height="9" )svg"
      R"svg(sf:version="1"><style>.a{opacity:.5}</style><g class="a" sf:diffuse="true">)svg"
      R"svg(<path d="M0 0l9 9M.5.5.6-1e-1" sf:left="red"/></g></svg>)svg");
  EXPECT_EQ(stack_of(read_document.document), "L0.50");
  EXPECT_EQ(read_document.document.layers[0].curves.size(), 2u);
  EXPECT_TRUE(read_document.warnings.empty());
}

TEST(SvgWarnings, are_one_for_each_kind_with_line_and_element) {
  const auto warnings =
      warnings_of(svg("<text x='1'>a</text>\n<text>b</text>\n <image href='x.png'/>\n"
                      "<g sf:diffuse='true' clip-path='url(#c)' filter='none'>\n<text/>" +
                      kCurve + "</g>"));
  ASSERT_EQ(warnings.size(), 3u);
  EXPECT_EQ(warnings[0],
            "a.svg:2:1: the text \"a\" is not read; convert text to paths before (in Inkscape: "
            "Path > Object to Path)");
  EXPECT_EQ(warnings[1], "a.svg:4:2: <image> is not read; such elements are ignored");
  EXPECT_EQ(warnings[2], "a.svg:5:1: clip-path of <g> is not read");
}

TEST(SvgWarnings, are_none_of_a_picture_to_trace_over) {
  const std::string image = "<image sf:reference='true' href='x.png' width='9' height='9'/>";
  EXPECT_TRUE(warnings_of(svg(image + "<g sf:diffuse='true'>" + image + kCurve + "</g>")).empty());
  const auto others = warnings_of(
      svg("<image sf:reference='false' href='x.png'/><g sf:diffuse='true'>" + kCurve + "</g>"));
  EXPECT_FALSE(others.empty());
}

TEST(SvgWarnings, tell_of_what_means_nothing) {
  EXPECT_EQ(warnings_of("<svg viewBox='0 0 9 9'/>"),
            (std::vector<std::string>{
                "a.svg:1:1: <svg> has no sf:version; it is read as version 1",
                "a.svg:1:1: the document has no layer and no local curve: the picture is empty; it "
                "contains no curves of Sfumato; add curves with sf:left and sf:right in <g "
                "sf:diffuse=\"true\">"}));
  EXPECT_EQ(warnings_of(svg_layer("<g opacity='.5'>" + kCurve + "</g>"))[0],
            "a.svg:3:1: opacity and mix-blend-mode of <g> mean nothing within a layer; put them on "
            "the layer, or sf:opacity on its curves");
  EXPECT_EQ(warnings_of(svg_layer(""))[0], "a.svg:2:1: the layer has no curves and paints nothing");
  EXPECT_EQ(warnings_of(svg("<g id='a'/><g id='a'/>" + kLayer))[0],
            "a.svg:2:12: the id \"a\" was given before; the first one counts");
  EXPECT_EQ(
      warnings_of(svg("<g sf:diffuse='true' mix-blend-mode='scren'>" + kCurve + "</g>"))[0],
      "a.svg:2:1: mix-blend-mode \"scren\" is not known; normal is used; did you mean screen?");
}

}  // namespace
}  // namespace sfumato::test
