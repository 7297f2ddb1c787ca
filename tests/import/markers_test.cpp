// Markers of ordinary SVG: shapes on the vertices of others.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sfumato/import/import_svg.hpp"

namespace sfumato {
namespace {

const std::string kMarkersRoot = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'>";

ImportedSvg with_markers(const std::string& content, const Limits& limits = {}) {
  Context context{.limits = limits};
  auto result = import_svg(context, kMarkersRoot + content + "</svg>", "markers.svg");
  EXPECT_TRUE(result) << (result ? "" : result.status().message);
  EXPECT_EQ(context.budget.used(), 0u);
  return result ? std::move(*result) : ImportedSvg{};
}

/// Returns a marker of a square from (0, 0) to (2, 1).
std::string square_marker(const std::string& attributes, const std::string& fill = "red") {
  return "<marker id='m' " + attributes + "><path d='M0 0H2V1H0z' fill='" + fill + "'/></marker>";
}

struct DrawnCurve {
  Rgb color;
  Box box;
};

/// Returns all curves, the lowest first.
std::vector<DrawnCurve> drawn_curves(const ImportedSvg& made) {
  std::vector<DrawnCurve> drawn;
  for (const StackItem& item : made.document.stack) {
    const auto* instance = std::get_if<LayerInstance>(&item);
    if (!instance) continue;
    for (const Curve& curve : made.document.layers[instance->layer].curves) {
      DrawnCurve& one = drawn.emplace_back();
      one.color = curve.right.color.stops.stops.front().value;
      for (const Vec2 point : curve.control_points) one.box.extend(point);
    }
  }
  return drawn;
}

void expect_box(const Box& box, const Box& expected) {
  EXPECT_NEAR(box.min.x, expected.min.x, 1e-6);
  EXPECT_NEAR(box.min.y, expected.min.y, 1e-6);
  EXPECT_NEAR(box.max.x, expected.max.x, 1e-6);
  EXPECT_NEAR(box.max.y, expected.max.y, 1e-6);
}

/// Returns the boxes of the markers of a shape that paints nothing else.
std::vector<Box> marker_boxes(const std::string& marker, const std::string& shape) {
  const auto made = with_markers(marker + shape);
  EXPECT_TRUE(made.warnings.empty()) << made.warnings[0].message;
  std::vector<Box> boxes;
  for (const DrawnCurve& curve : drawn_curves(made)) boxes.push_back(curve.box);
  return boxes;
}

Box only_box(const std::string& marker, const std::string& shape) {
  const std::vector<Box> boxes = marker_boxes(marker, shape);
  EXPECT_EQ(boxes.size(), 1u);
  return boxes.empty() ? Box{} : boxes[0];
}

const std::string kMarkedLine = "<path d='M20 20V60' fill='none' marker-end='url(#m)'/>";

TEST(ImportMarkers, the_reference_point_lies_on_the_vertex) {
  expect_box(only_box(square_marker(""), kMarkedLine), {{20, 60}, {22, 61}});
  expect_box(only_box(square_marker("refX='1' refY='.5'"), kMarkedLine), {{19, 59.5}, {21, 60.5}});
  expect_box(only_box(square_marker("viewBox='0 0 2 1' markerWidth='4' markerHeight='2' "
                                    "refX='right' refY='center'"),
                      kMarkedLine),
             {{16, 59}, {20, 61}});
}

TEST(ImportMarkers, lengths_are_in_widths_of_the_stroke_or_in_user_units) {
  const std::string wide =
      "<path d='M20 20V60' fill='none' stroke-width='4' marker-end='url(#m)'/>";
  expect_box(only_box(square_marker(""), wide), {{20, 60}, {28, 64}});
  expect_box(only_box(square_marker("markerUnits='userSpaceOnUse'"), wide), {{20, 60}, {22, 61}});
  EXPECT_TRUE(marker_boxes(square_marker(""),
                           "<path d='M20 20V60' fill='none' stroke-width='0' "
                           "marker-end='url(#m)'/>")
                  .empty());
}

TEST(ImportMarkers, the_view_box_fits_into_the_size) {
  const std::string view = "viewBox='0 0 2 1' markerWidth='4' markerHeight='4' ";
  expect_box(only_box(square_marker(view), kMarkedLine), {{20, 60}, {24, 62}});
  expect_box(only_box(square_marker(view + "preserveAspectRatio='none'"), kMarkedLine),
             {{20, 60}, {24, 64}});
  EXPECT_TRUE(marker_boxes(square_marker("markerWidth='0'"), kMarkedLine).empty());
}

TEST(ImportMarkers, they_turn_with_the_path_or_by_an_angle) {
  expect_box(only_box(square_marker("orient='auto'"), kMarkedLine), {{19, 60}, {20, 62}});
  for (const char* angle : {"90", "90deg", "100grad", ".25turn", "450"}) {
    expect_box(only_box(square_marker("orient='" + std::string(angle) + "'"), kMarkedLine),
               {{19, 60}, {20, 62}});
  }
  const std::string start = "<path d='M20 20V60' fill='none' marker-start='url(#m)'/>";
  expect_box(only_box(square_marker("orient='auto'"), start), {{19, 20}, {20, 22}});
  expect_box(only_box(square_marker("orient='auto-start-reverse'"), start), {{20, 18}, {21, 20}});
  expect_box(only_box(square_marker("orient='auto-start-reverse'"), kMarkedLine),
             {{19, 60}, {20, 62}});
}

/// Returns the direction of a marker that turns with the path, from its box.
std::string directions(const std::string& data, const std::string& which) {
  const std::string marker =
      "<marker id='m' orient='auto' overflow='visible'><path d='M1 -.1h1v.2h-1z'/></marker>";
  std::string all;
  for (const Box& box :
       marker_boxes(marker, "<path d='" + data + "' fill='none' " + which + "='url(#m)'/>")) {
    // Vertices are multiples of 10; the marker's middle is 1.5 away.
    const Vec2 middle = box.center();
    const Vec2 vertex{10 * std::round(middle.x / 10), 10 * std::round(middle.y / 10)};
    const Vec2 way = (middle - vertex) / 1.5;
    const double degrees = std::atan2(way.y, way.x) * 180 / 3.14159265358979;
    all += (all.empty() ? "" : " ") + std::to_string(std::lround(degrees));
  }
  return all;
}

TEST(ImportMarkers, directions_are_half_way_between_segments_that_meet) {
  EXPECT_EQ(directions("M10 10H40V40", "marker-mid"), "45");
  EXPECT_EQ(directions("M10 10H40V40", "marker-start"), "0");
  EXPECT_EQ(directions("M10 10H40V40", "marker-end"), "90");
  EXPECT_EQ(directions("M10 10H40H10", "marker-mid"), "-90") << "as Chromium has it";
  EXPECT_EQ(directions("M40 10H10H40", "marker-mid"), "90");
  EXPECT_EQ(directions("M10 10V40V10", "marker-mid"), "0");
  EXPECT_EQ(directions("M10 10H40z", "marker-end"), "90");
  EXPECT_EQ(directions("M10 10H40V40H10z", "marker-start"), "-45");
  EXPECT_EQ(directions("M10 10H40V40H10z", "marker-end"), "-45");
  EXPECT_EQ(directions("M10 10H40V40H10V10z", "marker-end"), "-45");
}

TEST(ImportMarkers, directions_of_curves_are_those_of_their_tangents) {
  EXPECT_EQ(directions("M10 10C40 10 40 10 40 40", "marker-start"), "0");
  EXPECT_EQ(directions("M10 10C40 10 40 10 40 40", "marker-end"), "90");
  EXPECT_EQ(directions("M10 10C10 10 40 10 40 40", "marker-start"), "0");
  EXPECT_EQ(directions("M10 10C10 10 40 40 40 40", "marker-end"), "45");
  EXPECT_EQ(directions("M20 40A20 20 0 0 1 60 40", "marker-end"), "90");
}

TEST(ImportMarkers, a_segment_of_no_length_has_the_direction_of_its_neighbour) {
  EXPECT_EQ(directions("M10 10V40V40", "marker-end"), "90");
  EXPECT_EQ(directions("M10 10H10V40", "marker-start"), "90");
  EXPECT_EQ(directions("M10 10L10 10", "marker-end"), "0");
}

TEST(ImportMarkers, all_vertices_but_the_first_and_the_last_have_the_one_of_the_middle) {
  const auto count = [](const std::string& shape) {
    return marker_boxes(square_marker(""), shape).size();
  };
  EXPECT_EQ(count("<path d='M10 10H40V40M10 60H40V90' fill='none' marker-mid='url(#m)'/>"), 4u);
  EXPECT_EQ(count("<polygon points='10 10 40 10 40 40' fill='none' marker-mid='url(#m)'/>"), 2u);
  EXPECT_EQ(count("<polyline points='10 10 40 10 40 40' fill='none' marker-mid='url(#m)'/>"), 1u);
  EXPECT_EQ(count("<path d='M20 40A20 20 0 1 1 60 41' fill='none' marker-mid='url(#m)'/>"), 0u);
  EXPECT_EQ(count("<line x2='40' style='marker:url(#m)'/>"), 2u);
  EXPECT_EQ(count("<g style='marker:url(#m)'><line x2='40' style='marker-end:none'/></g>"), 1u);
  EXPECT_EQ(count("<line x2='40' marker='url(#m)'/>"), 0u);
  EXPECT_EQ(count("<line x2='40' visibility='hidden' style='marker:url(#m)'/>"), 0u);
}

TEST(ImportMarkers, properties_are_inherited_from_the_marker) {
  const auto made = with_markers(
      "<g fill='blue'><marker id='m'><path d='M0 0H2V1H0z'/></marker></g>"
      "<g fill='red' stroke='lime'>" +
      std::string("<path d='M20 20V60' fill='none' stroke='none' marker-end='url(#m)'/></g>"));
  const auto drawn = drawn_curves(made);
  ASSERT_EQ(drawn.size(), 1u);
  EXPECT_EQ(drawn[0].color, (Rgb{0, 0, 1}));
}

TEST(ImportMarkers, the_paints_of_the_shape_are_those_of_its_context) {
  const auto color = [](const std::string& fill) {
    const auto drawn = drawn_curves(
        with_markers(square_marker("", fill) +
                     "<path d='M20 20V60' fill='blue' stroke='lime' marker-end='url(#m)'/>"));
    return drawn.empty() ? Rgb{-1, -1, -1} : drawn.back().color;
  };
  EXPECT_EQ(color("context-stroke"), (Rgb{0, 1, 0}));
  EXPECT_EQ(color("context-fill"), (Rgb{0, 0, 1}));
}

TEST(ImportMarkers, paint_order_says_where_they_lie) {
  const auto first_color = [](const std::string& order) {
    const auto drawn =
        drawn_curves(with_markers(square_marker("") +
                                  "<path d='M19 20h8v40h-8z' fill='blue' marker-start='url(#m)' "
                                  "paint-order='" +
                                  order + "'/>"));
    return drawn.empty() ? Rgb{-1, -1, -1} : drawn.front().color;
  };
  EXPECT_EQ(first_color("markers"), (Rgb{1, 0, 0}));
  EXPECT_EQ(first_color("normal"), (Rgb{0, 0, 1}));
}

TEST(ImportMarkers, markers_have_markers_but_never_go_round) {
  const std::string marked = "<path d='M0 0H1' fill='none' marker-end='url(#";
  const auto made = with_markers("<marker id='a' overflow='visible'>" + marked + "m)'/>" + marked +
                                 "a)'/></marker>" + square_marker("") +
                                 "<path d='M20 20V60' fill='none' marker-end='url(#a)'/>");
  const auto drawn = drawn_curves(made);
  ASSERT_EQ(drawn.size(), 1u);
  expect_box(drawn[0].box, {{21, 60}, {23, 61}});
}

TEST(ImportMarkers, groups_and_uses_in_them_are_followed) {
  const auto made = with_markers(
      "<path id='p' d='M0 0H2V1H0z' fill='red'/><marker id='m'><g transform='translate(1 0)' "
      "opacity='.5'><use href='#p'/><use href='#p' x='-1' fill='lime'/></g></marker>" +
      kMarkedLine);
  EXPECT_TRUE(made.warnings.empty());
  EXPECT_EQ(drawn_curves(made).size(), 3u);
}

TEST(ImportMarkers, what_cannot_be_drawn_is_named_in_a_warning) {
  const auto warning = [](const std::string& content) {
    const auto made = with_markers(content + kMarkedLine);
    return made.warnings.size() == 1 ? made.warnings[0].message : "";
  };
  EXPECT_NE(warning("").find("marker-end of <path> is left out"), std::string::npos);
  EXPECT_NE(warning("<g id='m'/>").find("#m is <g>; use a <marker>"), std::string::npos);
  EXPECT_NE(warning(square_marker("") + "<circle r='9' style='marker:url(#m)'/>")
                .find("markers of <circle> are not drawn"),
            std::string::npos);
  EXPECT_NE(warning(square_marker("markerWidth='-1'")).find("is negative"), std::string::npos);
  EXPECT_NE(warning(square_marker("orient='up'")).find("0 is used"), std::string::npos);
}

TEST(ImportMarkers, they_are_clipped_to_their_viewports) {
  expect_box(only_box(square_marker("markerWidth='1'"), kMarkedLine), {{20, 60}, {21, 61}});
  expect_box(only_box(square_marker("markerWidth='1' orient='90'"), kMarkedLine),
             {{19, 60}, {20, 61}});
  expect_box(only_box(square_marker("markerWidth='1' overflow='visible'"), kMarkedLine),
             {{20, 60}, {22, 61}});
  EXPECT_TRUE(
      marker_boxes(square_marker("markerWidth='1' viewBox='5 5 1 1'"), kMarkedLine).empty());
}

TEST(ImportMarkers, a_shape_whose_markers_exceed_the_limit_is_drawn_without_them) {
  const auto made = with_markers(square_marker("") +
                                     "<path d='M20 20V60H60V80' style='marker:url(#m)' fill='none' "
                                     "stroke='blue'/>" +
                                     kMarkedLine,
                                 {.markers = 3});
  EXPECT_EQ(drawn_curves(made).size(), 2u);
  ASSERT_EQ(made.warnings.size(), 1u);
  EXPECT_EQ(made.warnings[0].message,
            "markers of <path> are left out: more than the limit of 3 markers in all; raise the "
            "limit markers");
}

}  // namespace
}  // namespace sfumato
