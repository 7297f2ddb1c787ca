// Style sheets for ordinary shapes.
#include <gtest/gtest.h>

#include <cmath>

#include "sfumato/import/import_svg.hpp"

namespace sfumato {
namespace {

/// Returns a picture of 100 × 100 units with these attributes.
ImportedSvg styled_import(const std::string& content, const std::string& attributes = "") {
  Context context;
  auto result = import_svg(context,
                           "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100' " +
                               attributes + ">" + content + "</svg>",
                           "icon.svg");
  EXPECT_TRUE(result) << (result ? "" : result.status().message);
  return result ? std::move(*result) : ImportedSvg{};
}

std::string hex_of(const Rgb& color) {
  std::string text = "#";
  for (const float channel : {color.r, color.g, color.b}) {
    text += "0123456789abcdef"[static_cast<int>(channel * 15 + .5f)];
  }
  return text;
}

/// Returns the colours inside the curves, in order.
std::string fills_of(const std::string& content) {
  const ImportedSvg made = styled_import(content);
  EXPECT_TRUE(made.warnings.empty()) << made.warnings[0].message;
  std::string text;
  for (const Layer& layer : made.document.layers) {
    for (const Curve& curve : layer.curves) {
      text += hex_of(curve.right.color.stops.stops.at(0).value) + " ";
    }
  }
  return text;
}

TEST(ImportStyles, what_groups_give_to_one_shape_is_not_given_to_another) {
  const std::string square = "<rect width='9' height='9'/>";
  const std::string far = "<rect x='50' y='50' width='9' height='9'/>";
  EXPECT_EQ(fills_of("<g fill='#f00'><g>" + square + "</g><g fill='#0f0'>" + far + "</g></g>"),
            "#f00 #0f0 ");
  EXPECT_EQ(fills_of("<g fill='#f00'><g fill='initial'>" + square + "</g>" + far + "</g>"),
            "#000 #f00 ");
  EXPECT_EQ(
      fills_of("<g fill='#f00'><g fill='#00f'><g>" + square + "</g></g><g>" + far + "</g></g>"),
      "#00f #f00 ");
  // One group, drawn twice: its value depends on the elements around it.
  const std::string used = "<defs><g id='a'><g fill='var(--c)'>" + square + "</g></g></defs>";
  EXPECT_EQ(fills_of(used + "<g style='--c:#f00'><use href='#a'/></g>"
                            "<g style='--c:#0f0'><use href='#a' x='50'/></g>"),
            "#f00 #0f0 ");
}

/// Returns left, top, right and bottom of all curves, in hundredths, and their number.
std::string extent_of(const std::string& content, const std::string& attributes = "") {
  const ImportedSvg made = styled_import(content, attributes);
  EXPECT_TRUE(made.warnings.empty()) << made.warnings[0].message;
  Box box;
  std::size_t count = 0;
  for (const Layer& layer : made.document.layers) {
    count += layer.curves.size();
    for (const Curve& curve : layer.curves) {
      for (const Vec2 point : curve.control_points) box.extend(point);
    }
  }
  if (count == 0) return "nothing";
  std::string text;
  for (const double value : {box.min.x, box.min.y, box.max.x, box.max.y}) {
    text += std::to_string(std::lround(value * 100)) + " ";
  }
  return text + std::to_string(count);
}

TEST(ImportStyles, variables_and_selectors_paint_shapes) {
  const std::string circle = "<circle cx='50' cy='50' r='9' ";
  EXPECT_EQ(fills_of("<style>:root{--m:#f00} .v{fill:var(--m)}</style>" + circle + "class='v'/>"),
            "#f00 ");
  EXPECT_EQ(fills_of(circle + "fill='var(--not-set, #f00)'/>"), "#f00 ");
  EXPECT_EQ(fills_of("<g fill='#00f'>" + circle + "style='fill:var(--not-set)'/></g>"), "#00f ")
      << "invalid at computed-value time: inherited";
  EXPECT_EQ(
      fills_of("<style>.p circle, .p rect{fill:#f00}</style><g class='p'>" + circle + "/></g>"),
      "#f00 ");
}

TEST(ImportStyles, variables_are_inherited_through_use) {
  EXPECT_EQ(fills_of("<defs><g id='i' style='--c:#0f0'><circle cx='20' cy='50' r='9' "
                     "fill='var(--b,#00f)'/></g><circle id='k' cx='20' cy='80' r='9' "
                     "style='fill:var(--b)'/></defs><use href='#i' style='--b:#f00'/>"
                     "<use href='#i' x='50'/><use href='#k' style='--b:#f0f'/>"),
            "#f00 #00f #f0f ");
}

TEST(ImportStyles, lengths_of_strokes_follow_the_font_size) {
  const std::string line = "<line x1='20' x2='80' y1='50' y2='50' stroke='#000' ";
  EXPECT_EQ(extent_of("<g font-size='10'>" + line + "stroke-width='.8em'/></g>"),
            "2000 4600 8000 5400 1");
  EXPECT_EQ(extent_of(line + "style='font-size:5px;stroke-width:2em;stroke-dasharray:2em 200em'/>"),
            "2000 4500 3000 5500 1");
  EXPECT_EQ(extent_of("<g font-size='10'><rect x='2em' y='2em' width='6em' height='4em'/></g>"),
            "2000 2000 8000 6000 1");
  EXPECT_EQ(extent_of("<defs><rect id='r' x='1em' y='1em' width='1em' height='1em'/></defs>"
                      "<use href='#r' font-size='20'/>"),
            "2000 2000 4000 4000 1");
}

TEST(ImportStyles, negative_dashes_are_no_dashes) {
  const std::string line = "<line x1='20' x2='80' y1='50' y2='50' stroke='#000' stroke-width='4' ";
  for (const std::string dashes :
       {"stroke-dasharray='5 -5'", "style='stroke-dasharray:-1'", "stroke-dasharray='5 null'"}) {
    const ImportedSvg made = styled_import(line + dashes + "/>");
    ASSERT_EQ(made.document.layers.size(), 1u) << dashes;
    EXPECT_EQ(made.document.layers[0].curves.size(), 1u) << dashes;
    EXPECT_EQ(made.warnings.size(), 1u) << dashes;
  }
  EXPECT_EQ(extent_of(line + "stroke-dasharray='10,10'/>"), "2000 4800 7000 5200 3");
}

TEST(ImportStyles, path_length_is_the_unit_of_dashes) {
  const std::string line = "<path d='M20 50H70' stroke='#0f0' stroke-width='4' ";
  const std::string dashes = "stroke-dasharray='20 80' ";
  EXPECT_EQ(extent_of(line + dashes + "pathLength='100'/>"), "2000 4800 3000 5200 1");
  EXPECT_EQ(extent_of(line + dashes + "stroke-dashoffset='-40' pathLength=' 100 '/>"),
            "4000 4800 5000 5200 1");
  const std::string two = "<path d='M20 50H60M20 60H40' stroke='#0f0' stroke-width='4' ";
  EXPECT_EQ(extent_of(two + "stroke-dasharray='5 95' pathLength='60'/>"),
            extent_of(two + "stroke-dasharray='5 95'/>"))
      << "of all subpaths together";
  EXPECT_EQ(extent_of("<circle cx='50' cy='50' r='20' fill='none' stroke='#0f0' stroke-width='4' "
                      "stroke-dasharray='25 75' pathLength='100'/>"),
            extent_of("<path d='M70 50A20 20 0 0 1 50 70' fill='none' stroke='#0f0' "
                      "stroke-width='4'/>"));
  for (const std::string odd : {"0", "-5", "long"}) {
    const ImportedSvg made = styled_import(line + dashes + "pathLength='" + odd + "'/>");
    EXPECT_EQ(made.warnings.size(), 1u) << odd;
  }
  EXPECT_TRUE(styled_import(line + "pathLength='-5'/>").warnings.empty()) << "without dashes";
}

TEST(ImportStyles, css_translates_turns_and_scales_before_the_transform) {
  const auto placed = [](const std::string& style) {
    return extent_of("<rect x='40' y='40' width='20' height='10' style='" + style + "'/>");
  };
  EXPECT_EQ(placed("translate:10px"), placed("transform:translate(10px)"));
  EXPECT_EQ(placed("translate:10px 20%"), placed("transform:translate(10px,20px)"));
  EXPECT_EQ(placed("scale:50% .25"), placed("transform:scale(.5,.25)"));
  EXPECT_EQ(placed("scale:2"), placed("transform:scale(2)"));
  EXPECT_EQ(placed("rotate:z 90deg"), placed("transform:rotate(90deg)"));
  const std::string box = ";transform-box:fill-box;transform-origin:center";
  EXPECT_EQ(placed("rotate:.25turn" + box), placed("transform:rotate(90deg)" + box));
  EXPECT_EQ(placed("scale:.5;rotate:90deg;translate:9px;transform:translate(8px)" + box),
            placed("transform:translate(9px)rotate(90deg)scale(.5)translate(8px)" + box));
  EXPECT_EQ(placed("translate:none;rotate:none;scale:none"), placed(""));
  for (const std::string odd : {"rotate:x 20deg", "rotate:20", "scale:2px", "translate:1 2 3 4"}) {
    const ImportedSvg made = styled_import("<rect width='9' height='9' style='" + odd + "'/>");
    EXPECT_EQ(made.warnings.size(), 1u) << odd;
  }
  EXPECT_EQ(extent_of("<rect rotate='20' scale='2' translate='5' width='9' height='9'/>"),
            extent_of("<rect width='9' height='9'/>"))
      << "none of the three is an attribute";
}

TEST(ImportStyles, dashes_meet_in_a_join_where_a_closed_subpath_begins) {
  // The last ten and the first ten of the 60 · 4 units form one dash around the upper
  // left corner.
  const std::string rect =
      "<rect x='20' y='20' width='60' height='60' fill='none' stroke='#000' "
      "stroke-width='8' stroke-dasharray='20 220' ";
  EXPECT_EQ(extent_of(rect + "stroke-dashoffset='10'/>"), "1600 1600 3000 3000 1");
  EXPECT_EQ(extent_of(rect + "stroke-dashoffset='0'/>"), "2000 1600 4000 2400 1");
}

TEST(ImportStyles, a_stroke_may_keep_its_width_where_the_shape_is_scaled) {
  const std::string line =
      "<g transform='scale(4 2)'><line x1='5' x2='20' y1='25' y2='25' stroke='#000' "
      "stroke-width='10' ";
  EXPECT_EQ(extent_of(line + "/></g>"), "2000 4000 8000 6000 1");
  EXPECT_EQ(extent_of(line + "vector-effect='non-scaling-stroke'/></g>"), "2000 4500 8000 5500 1");
  EXPECT_EQ(extent_of(line + "style='vector-effect:non-scaling-stroke;stroke-dasharray:20 200'/>"
                             "</g>"),
            "2000 4500 4000 5500 1");
  EXPECT_EQ(
      extent_of(line + "vector-effect='non-scaling-stroke'/></g>", "width='200' height='200'"),
      "2000 4750 8000 5250 1")
      << "px of the picture";
  EXPECT_EQ(extent_of("<g vector-effect='non-scaling-stroke'>" + line + "/></g></g>"),
            "2000 4000 8000 6000 1")
      << "not inherited";
  EXPECT_EQ(styled_import(line + "vector-effect='fixed-position'/></g>").warnings.size(), 1u);
}

TEST(ImportStyles, blend_modes_are_read_from_styles_alone) {
  const auto blend = [](const std::string& attributes) {
    const ImportedSvg made = styled_import("<circle cx='50' cy='50' r='9' " + attributes + "/>");
    return std::get<LayerInstance>(made.document.stack.at(0)).blend;
  };
  EXPECT_EQ(blend("style='mix-blend-mode:screen'"), BlendMode::screen);
  EXPECT_EQ(blend("mix-blend-mode='screen'"), BlendMode::normal);
  const ImportedSvg own = styled_import(
      "<g sf:diffuse='true' mix-blend-mode='screen'><path d='M9 9h50' sf:left='red'/></g>",
      "xmlns:sf='urn:sfumato:1'");
  EXPECT_EQ(std::get<LayerInstance>(own.document.stack.at(0)).blend, BlendMode::screen)
      << "a layer of Sfumato";
}

TEST(ImportStyles, shapes_turn_about_the_origin_of_their_style) {
  EXPECT_EQ(extent_of("<rect x='40' y='20' width='20' height='60' style='transform:rotate(90deg);"
                      "transform-origin:50px 50px'/>"),
            "2000 4000 8000 6000 1");
  EXPECT_EQ(extent_of("<style>rect{transform:rotate(.25turn);transform-box:fill-box;"
                      "transform-origin:50% 50%}</style><rect x='40' y='20' width='20' "
                      "height='60'/>"),
            "2000 4000 8000 6000 1");
}

TEST(ImportStyles, a_path_that_ends_where_it_begins_is_open_until_it_is_closed) {
  const auto stroked = [](const std::string& data, const std::string& more = "") {
    return extent_of("<path fill='none' stroke='red' stroke-width='8' " + more + " d='" + data +
                     "'/>");
  };
  const std::string open = "M50 20L80 80H20L50 20", nearly = "M50 20L80 80H20L50 20.00001";
  EXPECT_EQ(stroked(open), stroked(nearly));
  EXPECT_NE(stroked(open), stroked(open + "z"));
  EXPECT_EQ(stroked("M9 9h9" + open), stroked("M9 9h9" + nearly)) << "each subpath by itself";
  const std::string dashes = "stroke-dasharray='60 12'";
  EXPECT_NE(stroked(open, dashes), stroked(open + "z", dashes))
      << "the last dash of a closed path goes on in the first one";
}

TEST(ImportStyles, hard_edges_are_named) {
  const auto warning = [](const std::string& attributes) -> std::string {
    const ImportedSvg made = styled_import("<g " + attributes + "><circle r='9'/></g>");
    return made.warnings.empty() ? "" : made.warnings[0].message;
  };
  EXPECT_EQ(warning("shape-rendering='crispEdges'"),
            "shape-rendering of <circle> is not followed: what should be hard is smooth");
  EXPECT_NE(warning("style='shape-rendering:optimizeSpeed'"), "");
  EXPECT_EQ(warning("shape-rendering='geometricPrecision'"), "");
  EXPECT_EQ(warning("image-rendering='pixelated'"), "") << "there is no image";
}

TEST(ImportStyles, custom_properties_reach_symbols_strokes_and_transforms) {
  EXPECT_EQ(fills_of("<symbol id='s' viewBox='0 0 9 9'>"
                     "<path d='M1 1h7v7h-7z' fill='var(--i,#f00)'/></symbol>"
                     "<use href='#s' width='40' height='40' style='--i:#0f0'/>"
                     "<use href='#s' x='50' width='40' height='40'/>"),
            "#0f0 #f00 ");
  EXPECT_EQ(fills_of("<g style='color:#0f0;--k:currentColor'>"
                     "<path d='M9 9h9v9h-9z' style='color:#f00;fill:var(--k)'/></g>"),
            "#f00 ");
  const std::string root = "style='--x:10px;--w:6;--d:12 6'", line = "<path d='M10 50h60' ";
  EXPECT_EQ(extent_of(line + "style='transform:translate(var(--x),var(--y,5px))'/>" +
                          "<path d='M0 0h9v9h-9z' style='transform:translate(var(--x),0px)'/>",
                      root),
            extent_of("<path d='M10 0h9v9h-9z'/>"));
  const std::string stroke = "stroke='#000' fill='none' style='stroke-width:";
  EXPECT_EQ(extent_of(line + stroke + "var(--w,1);stroke-dasharray:var(--d,none)'/>", root),
            extent_of(line + stroke + "6;stroke-dasharray:12 6'/>"));
}

}  // namespace
}  // namespace sfumato
