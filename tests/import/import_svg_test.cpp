#include "sfumato/import/import_svg.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <variant>

#include "formats/each_text.hpp"
#include "import/boundary.hpp"
#include "import/stroke_outline.hpp"
#include "sfumato/formats/svg/svg_write.hpp"
#include "support/flattened.hpp"

namespace sfumato {
namespace {

std::string icon(const std::string& content) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
         "viewBox=\"0 0 100 100\">" +
         content + "</svg>";
}

ImportedSvg imported_text(const std::string& text) {
  Context context;
  auto result = import_svg(context, text, "icon.svg");
  EXPECT_TRUE(result) << (result ? "" : result.status().message);
  return result ? std::move(*result) : ImportedSvg{};
}

ImportedSvg imported(const std::string& content) {
  return imported_text(icon(content));
}

Rgb color_of(const SideShader<Rgb>& side) {
  return side.kind == ShaderKind::curve_domain ? side.stops.stops.front().value : Rgb{-1, -1, -1};
}

TEST(ImportSvg, a_filled_shape_is_a_curve_with_its_colour_inside_and_nothing_outside) {
  const ImportedSvg made = imported(R"x(<circle id="dot" cx="50" cy="50" r="20" fill="#f00"/>)x");
  ASSERT_EQ(made.document.layers.size(), 1u);
  ASSERT_EQ(made.document.layers[0].curves.size(), 1u);
  const Curve& curve = made.document.layers[0].curves[0];
  EXPECT_EQ(curve.id, "dot");
  EXPECT_EQ(color_of(curve.right.color), (Rgb{1, 0, 0}));
  EXPECT_EQ(curve.right.opacity.stops.stops.front().value, 1);
  EXPECT_EQ(curve.left.opacity.stops.stops.front().value, 0);
}

TEST(ImportSvg, colours_outside_srgb_are_mapped_with_one_warning) {
  const ImportedSvg made =
      imported(R"x(<circle cx="50" cy="50" r="20" fill="color(display-p3 0 1 0)"/>)x"
               R"x(<circle cx="20" cy="20" r="9" style="fill:oklch(0.9 0.4 150)"/>)x");
  ASSERT_EQ(made.warnings.size(), 1u);
  EXPECT_TRUE(made.warnings[0].message.starts_with("fill of <circle>: the colour \"color(display-"))
      << made.warnings[0].message;
  const Rgb color = color_of(made.document.layers.at(0).curves.at(0).right.color);
  EXPECT_NEAR(color.g, 0.985764, 1e-5);
  EXPECT_NEAR(color.b, 0.159742, 1e-5);
}

TEST(ImportSvg, reports_its_progress_and_can_be_cancelled) {
  struct Fractions final : Progress {
    void report(std::string_view stage, double fraction) override {
      EXPECT_EQ(stage, "import");
      seen.push_back(fraction);
      if (context && seen.size() == 3) context->cancel = true;
    }
    std::vector<double> seen;
    Context* context = nullptr;
  };
  std::string dots;
  for (int i = 0; i < 10; ++i)
    dots += "<circle cx=\"50\" cy=\"50\" r=\"" + std::to_string(40 - i) + "\"/>";
  Fractions all;
  Context context;
  context.progress = &all;
  EXPECT_TRUE(import_svg(context, icon(dots), "dots.svg"));
  EXPECT_EQ(all.seen.size(), 10u);
  EXPECT_TRUE(std::ranges::is_sorted(all.seen));
  EXPECT_LE(all.seen.back(), 1);
  Fractions some;
  Context cancelled;
  some.context = &cancelled;
  cancelled.progress = &some;
  EXPECT_EQ(import_svg(cancelled, icon(dots), "dots.svg").status().code, StatusCode::cancelled);
  EXPECT_EQ(some.seen.size(), 3u);
}

TEST(ImportSvg, a_gradient_that_is_a_cone_is_clear_outside_of_it) {
  const auto made_of = [](const std::string& focus) {
    return imported("<radialGradient id=\"g\" r=\".3\" " + focus +
                    "><stop stop-color=\"red\"/><stop offset=\"1\"/></radialGradient>"
                    "<circle cx=\"50\" cy=\"50\" r=\"20\" fill=\"url(#g)\"/>");
  };
  const ImportedSvg cone = made_of("fx=\"0\"");
  EXPECT_EQ(cone.document.shaders.size(), 2u);
  EXPECT_EQ(cone.document.layers[0].curves[0].right.opacity.kind, ShaderKind::image_domain);
  EXPECT_EQ(made_of("fx=\".4\" fr=\".1\"").document.shaders.size(), 1u);
}

TEST(ImportSvg, a_shape_on_another_has_its_colour_outside) {
  const ImportedSvg made = imported(
      R"x(<rect x="10" y="10" width="80" height="80" fill="#00f"/><circle cx="50" cy="50")x"
      R"x( r="20" fill="#f00"/>)x");
  ASSERT_EQ(made.document.layers.size(), 1u);
  ASSERT_EQ(made.document.layers[0].curves.size(), 2u);
  const Curve& circle = made.document.layers[0].curves[1];
  EXPECT_EQ(color_of(circle.right.color), (Rgb{1, 0, 0}));
  EXPECT_EQ(color_of(circle.left.color), (Rgb{0, 0, 1}));
  EXPECT_EQ(circle.left.opacity.kind, ShaderKind::open);
}

TEST(ImportSvg, shapes_that_cross_have_layers_of_their_own) {
  const ImportedSvg made = imported(
      R"x(<rect x="10" y="10" width="50" height="50" fill="#00f"/><circle cx="60" cy="60")x"
      R"x( r="20" fill="#f00"/>)x");
  EXPECT_EQ(made.document.layers.size(), 2u);
}

TEST(ImportSvg, a_rectangle_over_everything_is_the_background) {
  const ImportedSvg made = imported(R"x(<rect width="100" height="100" fill="#0f0"/>)x");
  EXPECT_EQ(made.document.background, (Rgb{0, 1, 0}));
}

/// Returns a square that fills a viewBox of 100 × 100, with more attributes of <svg>.
ImportedSvg framed(const std::string& attributes) {
  return imported_text("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 100 100\" " +
                       attributes + "><circle cx=\"50\" cy=\"50\" r=\"40\" fill=\"#f00\"/></svg>");
}

TEST(ImportSvg, width_and_height_are_kept) {
  EXPECT_EQ(framed("").document.size_px, std::nullopt);
  const ImportedSvg large = framed("width=\"400\" height=\"400\"");
  EXPECT_EQ(large.document.size_px, (Vec2{400, 400}));
  EXPECT_EQ(large.document.artboard, (Box{{0, 0}, {100, 100}}));
  const ImportedSvg wide = framed("width=\"400\" height=\"200\"");
  EXPECT_EQ(wide.document.size_px, (Vec2{400, 200}));
  EXPECT_EQ(wide.document.artboard, (Box{{-50, 0}, {150, 100}}));
  const ImportedSvg stretched = framed("width=\"400\" height=\"200\" preserveAspectRatio=\"none\"");
  EXPECT_EQ(stretched.document.size_px, (Vec2{400, 200}));
  const Box& board = stretched.document.artboard;
  const Affine& map = std::get<LayerInstance>(stretched.document.stack.at(0)).artboard_from_layer;
  EXPECT_EQ(map({0, 0}), board.min);
  EXPECT_EQ(map({100, 100}), board.max);
  EXPECT_EQ(board.width(), 2 * board.height());
}

TEST(ImportSvg, use_and_groups_inherit_as_they_are_drawn) {
  const ImportedSvg made = imported(
      R"x(<defs><circle id="c" cx="9" cy="9" r="5"/></defs><g fill="#f00" color="#00f"><use)x"
      R"x( xlink:href="#c"/></g>)x"
      R"x(<g color="#00f"><use xlink:href="#c" x="40" fill="currentColor"/></g>)x");
  ASSERT_EQ(made.document.layers.size(), 1u);
  ASSERT_EQ(made.document.layers[0].curves.size(), 2u);
  EXPECT_EQ(color_of(made.document.layers[0].curves[0].right.color), (Rgb{1, 0, 0}));
  EXPECT_EQ(color_of(made.document.layers[0].curves[1].right.color), (Rgb{0, 0, 1}));
}

TEST(ImportSvg, gradients_become_paints_and_their_alpha_opacity) {
  const ImportedSvg made =
      imported(R"x(<linearGradient id="g"><stop stop-color="#f00"/><stop offset="1")x"
               R"x( stop-color="#00f" stop-opacity="0"/></linearGradient>)x"
               R"x(<circle cx="50" cy="50" r="20" fill="url(#g)"/>)x");
  ASSERT_EQ(made.document.layers.size(), 1u);
  const Curve& curve = made.document.layers[0].curves[0];
  EXPECT_EQ(curve.right.color.kind, ShaderKind::image_domain);
  EXPECT_EQ(curve.right.opacity.kind, ShaderKind::image_domain);
  EXPECT_NE(curve.right.color.shader, curve.right.opacity.shader);
}

TEST(ImportSvg, opacity_of_a_shape_with_fill_and_stroke_is_that_of_a_group) {
  const ImportedSvg made =
      imported(R"x(<rect x="20" y="20" width="40" height="40" fill="#f00" stroke="#00f")x"
               R"x( stroke-width="4" opacity=".5"/>)x");
  ASSERT_EQ(made.document.stack.size(), 4u);
  EXPECT_EQ(std::get<GroupBegin>(made.document.stack[0]).opacity, 0.5F);
}

/// Returns the colours of the layers, bottom first, of a red shape with a blue stroke.
std::string painted(const std::string& attributes, const std::string& around = "") {
  const ImportedSvg made =
      imported("<g " + around + "><rect x='20' y='20' width='40' height='40' fill='#f00'" +
               " stroke='#00f' stroke-width='4' " + attributes + "/></g>");
  std::string colors;
  for (const StackItem& item : made.document.stack) {
    const auto* instance = std::get_if<LayerInstance>(&item);
    if (!instance) continue;
    const Curve& curve = made.document.layers[instance->layer].curves.at(0);
    colors += color_of(curve.right.color) == Rgb{1, 0, 0} ? "fill " : "stroke ";
  }
  return colors + std::to_string(made.warnings.size());
}

TEST(ImportSvg, paint_order_says_whether_the_stroke_lies_below_the_fill) {
  const auto by_attribute = [](const std::string& order) {
    return painted("paint-order='" + order + "'");
  };
  const auto by_style = [](const std::string& order) {
    return painted("style='paint-order:" + order + "'");
  };
  const auto inherited = [](const std::string& order) {
    return painted("", "paint-order='" + order + "'");
  };
  const std::initializer_list<std::string> below{"stroke", "stroke fill markers", "markers stroke",
                                                 " Stroke  MARKERS", "stroke/**/fill"};
  const std::initializer_list<std::string> above{"normal", "fill", "fill stroke", "markers",
                                                 "markers fill stroke"};
  for (const auto& of :
       {std::function(by_attribute), std::function(by_style), std::function(inherited)}) {
    test::expect_of_each(below, of, "stroke fill 0");
    test::expect_of_each(above, of, "fill stroke 0");
  }
  EXPECT_EQ(painted("paint-order='normal'", "paint-order='stroke'"), "fill stroke 0");
  EXPECT_EQ(painted("style='paint-order:inherit'", "style='paint-order:stroke'"), "stroke fill 0");
  EXPECT_EQ(painted("opacity='.5' paint-order='stroke'"), "stroke fill 0");
  // An invalid order causes a warning, and changes nothing.
  test::expect_of_each({"stroke stroke", "stroke normal", "stroke,fill", "stoke", "1"},
                       by_attribute, "fill stroke 1");
  test::expect_of_each({"stroke stroke", "stroke normal", "stroke,fill", "stoke", "1"}, by_style,
                       "fill stroke 1");
}

/// Returns the box of the only curve of a stroke of width 10; empty if it makes no curve.
Box stroked(const std::string& shape) {
  const ImportedSvg made =
      imported("<g fill='none' stroke='#000' stroke-width='10'>" + shape + "</g>");
  EXPECT_LE(made.document.layers.size(), 1u) << shape;
  Box box;
  for (const Layer& layer : made.document.layers) {
    EXPECT_EQ(layer.curves.size(), 1u) << shape;
    for (const Vec2 point : layer.curves.at(0).control_points) box.extend(point);
  }
  return box;
}

/// Returns the extent of a stroked dot: left, top, right and bottom, in thousandths.
std::string dot_of(const std::string& shape) {
  const Box box = stroked(shape);
  if (box.empty()) return "nothing";
  std::string text;
  for (const double value : {box.min.x, box.min.y, box.max.x, box.max.y}) {
    text += std::to_string(std::lround(value * 1000)) + ' ';
  }
  return text;
}

TEST(ImportSvg, a_subpath_of_no_length_is_a_dot_where_caps_make_one) {
  const std::initializer_list<std::string> shapes{"<path d='M20 50z'",
                                                  "<path d='M20 50h0'",
                                                  "<path d='M20 50l0 0'",
                                                  "<path d='M20 50h0z'",
                                                  "<path d='M20 50c0 0 0 0 0 0zz'",
                                                  "<path d='M20 50a5 5 0 0 1 0 0'",
                                                  "<path d='M9 9M20 50zM8 8'",
                                                  "<line x1='20' y1='50' x2='20' y2='50'",
                                                  "<polygon points='20,50'",
                                                  "<polyline points='20,50 20,50'",
                                                  "<path stroke-dasharray='3 4' d='M20 50z'"};
  const auto capped = [](const std::string& cap) {
    return [cap](const std::string& shape) {
      return dot_of(shape + " stroke-linecap='" + cap + "'/>");
    };
  };
  test::expect_of_each(shapes, capped("round"), "15000 45000 25000 55000 ");
  test::expect_of_each(shapes, capped("square"), "15000 45000 25000 55000 ");
  test::expect_of_each(shapes, capped("butt"), "nothing");
  test::expect_of_each({"<path d='M20 50'", "<path d='M20 50M20 50'", "<polyline points='20,50'",
                        "<path stroke-dasharray='3 4' stroke-dashoffset='4' d='M20 50z'"},
                       capped("round"), "nothing");
  // Half of the square's diagonal.
  EXPECT_EQ(dot_of("<path d='M50 50z' stroke-linecap='square' transform='rotate(45 50 50)'/>"),
            "42929 42929 57071 57071 ");
}

TEST(ImportSvg, what_cannot_be_brought_over_is_told_once_with_its_place) {
  const ImportedSvg made = imported(
      "<text>a</text><text>b</text><circle r=\"9\" cx=\"20\" cy=\"20\" filter=\"url(#f)\"/>"
      "<path d=\"M0 0 L x\"/><rect width=\"9\" height=\"9\" fill=\"url(#nothing)\"/>");
  EXPECT_EQ(made.warnings.size(), 4u);
  for (const Diagnostic& warning : made.warnings) {
    EXPECT_GT(warning.where.line, 0) << warning.message;
  }
  EXPECT_EQ(made.document.layers.size(), 1u);
}

TEST(ImportSvg, a_star_that_crosses_itself_is_filled_by_its_rule) {
  const std::string star = R"x(d="M50 5 L78 90 L5 37 L95 37 L22 90 Z")x";
  const ImportedSvg nonzero = imported("<path " + star + "/>");
  const ImportedSvg even_odd = imported("<path fill-rule=\"evenodd\" " + star + "/>");
  // An outline of ten corners, or five tips around a hole.
  ASSERT_EQ(nonzero.document.layers[0].curves.size(), 1u);
  std::size_t pieces = 0;
  for (const Curve& curve : even_odd.document.layers[0].curves) pieces += curve.piece_count();
  EXPECT_EQ(pieces, 15u);
}

TEST(ImportSvg, what_it_makes_can_be_written) {
  Context context;
  const ImportedSvg made =
      imported(R"x(<path id="a&lt;" d="M10 10 C90 10 10 90 90 90" fill="none" stroke="red")x"
               R"x( stroke-width="6" stroke-linecap="round" stroke-dasharray="9 12"/>)x");
  EXPECT_TRUE(write_svg(context, made.document));
}

TEST(ImportSvg, limits_and_cancelling_hold) {
  Context context;
  context.cancel = true;
  const auto cancelled = import_svg(context, icon("<circle r=\"9\"/>"), "icon.svg");
  ASSERT_FALSE(cancelled);
  EXPECT_EQ(cancelled.status().code, StatusCode::cancelled);
}

TEST(ImportSvg, a_stroke_of_too_many_dashes_is_left_out) {
  const std::string stroke =
      R"x(<path d="M0 0 L90 0" stroke="red" stroke-width="3" stroke-dasharray="1"/>)x";
  Context context{.limits = {.dashes = 44}};
  const auto few = import_svg(context, icon(stroke), "i.svg");
  ASSERT_TRUE(few);
  EXPECT_TRUE(few->document.layers.empty());
  ASSERT_EQ(few->warnings.size(), 1u);
  EXPECT_EQ(few->warnings[0].message,
            "the shape is left out: more than the limit of 44 dashes in one stroke; raise the "
            "limit dashes");
  EXPECT_EQ(imported(stroke).document.layers.at(0).curves.size(), 45u);
}

double area(const svg_import::Contours& contours) {
  double sum = 0;
  for (const auto& contour : contours) {
    const auto polygon = test::flattened(contour, 1e-4);
    for (std::size_t i = 1; i < polygon.size(); ++i) sum += cross(polygon[i - 1], polygon[i]) / 2;
  }
  return sum;
}

double stroked_area(const svg_import::Contours& subpaths, const svg::StrokeStyle& style) {
  Context context;
  const auto outline = svg_import::stroke_outline(context, subpaths, style, 1e-3);
  const auto boundary = svg_import::fill_boundary(context, *outline, false, 1e-3);
  return area(*boundary);
}

const svg_import::Contours kLine{{{10, 10}, {20, 10}, {30, 10}, {40, 10}}};

TEST(StrokeOutline, caps_have_their_areas) {
  EXPECT_NEAR(stroked_area(kLine, {.width = 6}), 180, 1e-6);
  EXPECT_NEAR(stroked_area(kLine, {.width = 6, .cap = svg::StrokeCap::square}), 216, 1e-6);
  EXPECT_NEAR(stroked_area(kLine, {.width = 6, .cap = svg::StrokeCap::round}), 180 + 9 * 3.14159,
              0.02);
}

TEST(StrokeOutline, dashes_leave_gaps) {
  EXPECT_NEAR(stroked_area(kLine, {.width = 2, .dashes = {5, 5}}), 30, 1e-6);
  EXPECT_NEAR(stroked_area(kLine, {.width = 2, .dashes = {5, 5}, .dash_offset = 5}), 30, 1e-6);
}

TEST(StrokeOutline, dashes_of_no_length_are_dots) {
  const double disk = 3.14159;
  const auto dotted = [](svg::StrokeCap cap, double offset = 0) {
    return stroked_area(kLine, {.width = 2, .cap = cap, .dashes = {0, 10}, .dash_offset = offset});
  };
  EXPECT_NEAR(dotted(svg::StrokeCap::round), 4 * disk, 0.01);
  EXPECT_NEAR(dotted(svg::StrokeCap::square), 16, 1e-3);
  EXPECT_NEAR(dotted(svg::StrokeCap::butt), 0, 1e-3);
  EXPECT_NEAR(dotted(svg::StrokeCap::round, 5), 3 * disk, 0.01);
  EXPECT_NEAR(
      stroked_area(kLine, {.width = 2, .cap = svg::StrokeCap::square, .dashes = {4, 5, 0, 6}}),
      2 * (6 * 2 + 2 * 2), 1e-3);
}

TEST(StrokeOutline, squares_of_dots_stand_along_the_curve) {
  const svg_import::Contours slanted{{{100, 100}, {110, 110}, {120, 120}, {130, 130}}};
  Context context;
  const svg::StrokeStyle style{.width = 2, .cap = svg::StrokeCap::square, .dashes = {0, 100}};
  const auto outline = svg_import::stroke_outline(context, slanted, style, 1e-3);
  Box box;
  for (const Vec2 point : outline->at(0)) box.extend(point);
  EXPECT_NEAR(box.width(), 2 * std::sqrt(2), 1e-4);
}

TEST(StrokeOutline, joins_have_their_areas) {
  const svg_import::Contours corner{
      {{0, 0}, {10, 0}, {20, 0}, {30, 0}, {30, 10}, {30, 20}, {30, 30}}};
  const double arms = 2 * 30 * 4 - 4;  // the inner corner counts once
  EXPECT_NEAR(stroked_area(corner, {.width = 4, .join = svg::StrokeJoin::bevel}), arms + 2, 1e-3);
  EXPECT_NEAR(stroked_area(corner, {.width = 4, .join = svg::StrokeJoin::miter}), arms + 4, 1e-3);
  EXPECT_NEAR(stroked_area(corner, {.width = 4, .join = svg::StrokeJoin::round}), arms + 3.14159,
              1e-2);
}

TEST(FillBoundary, overlapping_contours_are_one_region_with_its_inside_right) {
  Context context;
  const auto square = [](double x, double y) {
    std::vector<Vec2> points{{x, y}};
    const std::vector<Vec2> corners{{x + 10, y}, {x + 10, y + 10}, {x, y + 10}, {x, y}};
    for (const Vec2 to : corners) {
      const Vec2 from = points.back();
      points.insert(points.end(), {lerp(from, to, 1.0 / 3), lerp(from, to, 2.0 / 3), to});
    }
    return points;
  };
  auto reversed = square(5, 5);
  std::ranges::reverse(reversed);
  EXPECT_NEAR(area(*svg_import::fill_boundary(context, {square(0, 0), square(5, 5)}, false, 1e-3)),
              175, 1e-9);
  EXPECT_NEAR(area(*svg_import::fill_boundary(context, {square(0, 0), square(5, 5)}, true, 1e-3)),
              150, 1e-9);
  EXPECT_NEAR(area(*svg_import::fill_boundary(context, {square(0, 0), reversed}, false, 1e-3)), 150,
              1e-9);
}

}  // namespace
}  // namespace sfumato
