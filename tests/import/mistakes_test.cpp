// Mistakes in single attributes: as in browsers, the rest of the element counts.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>
#include <variant>

#include "sfumato/import/import_svg.hpp"

namespace sfumato {
namespace {

ImportedSvg mistaken(const std::string& content) {
  Context context;
  auto result = import_svg(
      context,
      "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'>" + content + "</svg>",
      "a.svg");
  EXPECT_TRUE(result) << (result ? "" : result.status().message);
  return result ? std::move(*result) : ImportedSvg{};
}

/// Returns the first warning, with its place.
std::string warning_of(const ImportedSvg& made) {
  return made.warnings.empty() ? "" : to_string(made.warnings[0]);
}

/// Returns the corners of the box of all curves.
std::string extent_of_mistaken(const ImportedSvg& made) {
  Box box;
  for (const Layer& layer : made.document.layers) {
    for (const Curve& curve : layer.curves) {
      for (const Vec2 point : curve.control_points) box.extend(point);
    }
  }
  std::string text;
  for (const double value : {box.min.x, box.min.y, box.max.x, box.max.y}) {
    text += std::to_string(std::lround(value)) + " ";
  }
  return made.document.layers.empty() ? "nothing" : text;
}

/// Returns the gradient of the only shape that has one.
GradientFill gradient_of(const ImportedSvg& made) {
  for (const Shader& shader : made.document.shaders) {
    if (const auto* fill = std::get_if<GradientFill>(&shader.paint)) return *fill;
  }
  ADD_FAILURE() << "no gradient; " << warning_of(made);
  return {};
}

/// Returns all properties of its gradient, as text.
std::string facts_of(const ImportedSvg& made) {
  const GradientFill fill = gradient_of(made);
  std::ostringstream text;
  const Affine& map = fill.layer_from_gradient;
  text << static_cast<int>(fill.spread) << " " << map.a << " " << map.d << " " << map.e << ":";
  if (const auto* line = std::get_if<LinearGradient>(&fill.shape)) {
    text << line->start.x << " " << line->start.y << " " << line->end.x << " " << line->end.y;
  } else {
    const auto& circle = std::get<RadialGradient>(fill.shape);
    text << circle.radius << " " << circle.focal_radius << " " << circle.focus.x;
  }
  for (const GradientStop& stop : fill.stops) {
    text << ", " << stop.offset << " " << stop.color.r << " " << stop.alpha;
  }
  return text.str();
}

const std::string kStops = "<stop stop-color='red'/><stop offset='1' stop-color='blue'/>";
const std::string kPainted = "<rect width='80' height='80' fill='url(#g)'/>";

/// Returns a square that a gradient with these attributes fills.
ImportedSvg with_gradient(const std::string& attributes, const std::string& stops = kStops) {
  return mistaken("<linearGradient id='g' " + attributes + ">" + stops + "</linearGradient>" +
                  kPainted);
}

TEST(ImportMistakes, a_path_ends_at_its_mistake) {
  const ImportedSvg made = mistaken("<path d='M10 10H50V50 L10 # 90 90'/>");
  EXPECT_EQ(extent_of_mistaken(made), "10 10 50 50 ");
  EXPECT_EQ(warning_of(made),
            "a.svg:1:63: d of <path>: at character 18, before \"# 90 90\": expected a number; what "
            "follows is left out");
  EXPECT_EQ(extent_of_mistaken(mistaken("<path d='H50V50'/>")), "nothing");
  EXPECT_EQ(extent_of_mistaken(mistaken("<path d='M10 10H50V50zM60 60'/>")), "10 10 50 50 ");
}

TEST(ImportMistakes, points_end_at_their_mistake) {
  for (const char* points : {"10 10 50 10 50 50 90", "10 10 50 10 50 50 word 90 90"}) {
    const ImportedSvg made = mistaken("<polygon points='" + std::string(points) + "'/>");
    EXPECT_EQ(extent_of_mistaken(made), "10 10 50 50 ") << points;
    EXPECT_NE(warning_of(made).find("what follows is left out"), std::string::npos) << points;
  }
}

TEST(ImportMistakes, a_negative_radius_of_corners_is_that_of_the_other_axis) {
  const auto points = [](const std::string& radii) {
    const ImportedSvg made = mistaken("<rect width='80' height='40' " + radii + "/>");
    return made.document.layers.at(0).curves.at(0).control_points;
  };
  EXPECT_EQ(points("rx='-5' ry='9'"), points("ry='9'"));
  EXPECT_EQ(points("rx='9' ry='-5'"), points("rx='9'"));
  EXPECT_EQ(points("rx='-9' ry='-5'"), points(""));
  const ImportedSvg made = mistaken("<ellipse rx='-1' ry='20'/>");
  EXPECT_EQ(extent_of_mistaken(made), "-20 -20 20 20 ");
  EXPECT_EQ(warning_of(made),
            "a.svg:1:63: rx of <ellipse> is negative; use 0 or more; it is ignored");
}

TEST(ImportMistakes, a_paint_that_is_none_is_ignored) {
  const auto color = [](const std::string& fill) {
    const ImportedSvg made = mistaken("<g fill='#0f0'><circle r='20' fill='" + fill + "'/></g>" +
                                      "<linearGradient id='g'><stop/></linearGradient>");
    EXPECT_NE(warning_of(made).find("it is ignored"), std::string::npos) << fill;
    const auto& stops = made.document.layers.at(0).curves.at(0).right.color.stops.stops;
    return stops.empty() ? Rgb{} : stops[0].value;
  };
  for (const char* fill : {"#12", "none of these", "red icc-color(a, 0)", "rgba(0, 50%, 0, .5)",
                           "url(#g) red icc-color(a, 0)"}) {
    EXPECT_EQ(color(fill), (Rgb{0, 1, 0})) << fill;
  }
  EXPECT_EQ(warning_of(mistaken("<circle r='20' stroke='gren'/>")),
            "a.svg:1:63: stroke of <circle> is \"gren\"; its value is not understood, and it is "
            "ignored; did you mean green?");
}

TEST(ImportMistakes, a_gradient_does_without_a_faulty_attribute) {
  const std::string right = facts_of(with_gradient(""));
  for (const char* attributes :
       {"spreadMethod='often'", "gradientUnits='mine'", "gradientTransform='turn(3)'", "x2='far'",
        "href='#nothing'", "href='other.svg#g'", "href='#g'"}) {
    const ImportedSvg made = with_gradient(attributes);
    EXPECT_EQ(facts_of(made), right) << attributes;
    EXPECT_NE(warning_of(made).find("; it is ignored"), std::string::npos) << warning_of(made);
  }
  for (const char* stop :
       {"<stop offset='3mm' stop-color='red'/>", "<stop stop-color='red' stop-opacity='most'/>"}) {
    const ImportedSvg made =
        with_gradient("", stop + std::string("<stop offset='1' stop-color='blue'/>"));
    EXPECT_EQ(facts_of(made), right) << stop;
    EXPECT_NE(warning_of(made).find("; it is ignored"), std::string::npos) << warning_of(made);
  }
}

TEST(ImportMistakes, a_transform_that_cannot_be_read_is_inherited) {
  const auto heir = [](const std::string& attributes, const std::string& between = "") {
    return mistaken("<linearGradient id='i' gradientTransform='scale(3)'>" + kStops +
                    "</linearGradient><linearGradient id='h' href='#i' " + between +
                    "/><linearGradient id='g' href='#h' " + attributes + "/>" + kPainted);
  };
  const std::string inherited = facts_of(heir(""));
  EXPECT_NE(inherited, facts_of(heir("gradientTransform=''")));
  for (const char* turned : {"", "gradientTransform='turn(4)'"}) {
    const ImportedSvg made = heir("gradientTransform='turn(3)'", turned);
    EXPECT_EQ(facts_of(made), inherited) << turned;
    EXPECT_NE(warning_of(made).find("; it is ignored"), std::string::npos) << warning_of(made);
  }
  EXPECT_EQ(facts_of(heir("gradientTransform='turn(3)'", "gradientTransform='scale(2)'")),
            facts_of(heir("gradientTransform='scale(2)'")));
}

TEST(ImportMistakes, an_empty_transform_is_the_identity) {
  const std::string scaled =
      "<linearGradient id='h' gradientTransform='scale(3)'>" + kStops + "</linearGradient>";
  for (const std::string empty : {"gradientTransform=''", "gradientTransform=' '"}) {
    const ImportedSvg alone = with_gradient(empty);
    EXPECT_EQ(facts_of(alone), facts_of(with_gradient("")));
    EXPECT_EQ(warning_of(alone), "");
    const ImportedSvg heir =
        mistaken(scaled + "<linearGradient id='g' href='#h' " + empty + "/>" + kPainted);
    EXPECT_EQ(facts_of(heir), facts_of(alone));
    EXPECT_EQ(warning_of(heir), "");
  }
  const ImportedSvg shape = mistaken("<rect width='80' height='40' transform=''/>");
  EXPECT_EQ(extent_of_mistaken(shape), "0 0 80 40 ");
  EXPECT_EQ(warning_of(shape), "");
}

TEST(ImportMistakes, hrefs_of_gradients_in_a_circle_end_where_they_close) {
  const ImportedSvg made = mistaken(
      "<linearGradient id='g' href='#h'/><linearGradient id='h' "
      "href='#g'>" +
      kStops + "</linearGradient>" + kPainted);
  EXPECT_EQ(gradient_of(made).stops.size(), 2u);
  EXPECT_NE(warning_of(made).find("go round in a circle: #g → #h → #g"), std::string::npos);
}

TEST(ImportMistakes, radii_of_gradients_are_not_negative) {
  const auto radial = [](const std::string& attributes) {
    return mistaken("<radialGradient id='g' " + attributes + ">" + kStops + "</radialGradient>" +
                    kPainted);
  };
  EXPECT_EQ(facts_of(radial("fr='-1'")), facts_of(radial("")));
  EXPECT_EQ(facts_of(radial("r='-1'")), facts_of(radial("r='0'")));
  EXPECT_NE(warning_of(radial("r='-1'")).find("r is negative"), std::string::npos);
}

TEST(ImportMistakes, equal_circles_of_a_gradient_are_a_step) {
  const ImportedSvg made =
      mistaken("<radialGradient id='g' fr='.5'>" + kStops + "</radialGradient>" + kPainted);
  const RadialGradient circle = std::get<RadialGradient>(gradient_of(made).shape);
  EXPECT_LT(circle.focal_radius, circle.radius);
  EXPECT_GT(circle.focal_radius, 0.99 * circle.radius);
  EXPECT_EQ(warning_of(made), "");
}

}  // namespace
}  // namespace sfumato
