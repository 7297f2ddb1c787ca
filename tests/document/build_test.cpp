#include "sfumato/document/build.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <variant>

namespace sfumato {
namespace {

TEST(Build, a_colour_is_what_style_sheets_write) {
  EXPECT_EQ(rgb(0xff0000), (Rgb{1, 0, 0}));
  EXPECT_EQ(rgb(0x0080ff), (Rgb{0, 128.0f / 255, 1}));
  EXPECT_EQ(rgb(0xffffff), (Rgb{1, 1, 1}));
}

TEST(Build, a_polyline_is_straight_and_runs_evenly) {
  const Curve curve = polyline({{0, 0}, {3, 0}, {3, 6}});
  ASSERT_EQ(curve.control_points.size(), 7u);
  EXPECT_EQ(curve.piece_count(), 2u);
  EXPECT_NEAR(curve.control_points[1].x, 1, 1e-15);
  EXPECT_NEAR(curve.control_points[2].x, 2, 1e-15);
  EXPECT_EQ(curve.control_points[3], (Vec2{3, 0}));
  EXPECT_NEAR(curve.control_points[5].y, 4, 1e-15);
  EXPECT_EQ(curve.control_points[6], (Vec2{3, 6}));
}

TEST(Build, colours_stand_at_equal_distances) {
  const Side side = sfumato::colored({rgb(0), rgb(0xff0000), rgb(0xffffff)}, 2.5f);
  EXPECT_EQ(side.color.kind, ShaderKind::curve_domain);
  EXPECT_EQ(side.color.stops.space, StopSpace::arc_length);
  ASSERT_EQ(side.color.stops.stops.size(), 3u);
  EXPECT_EQ(side.color.stops.stops[1].offset, 0.5);
  EXPECT_EQ(side.color.stops.stops[2].offset, 1);
  ASSERT_EQ(side.blur_radius.stops.size(), 1u);
  EXPECT_EQ(side.blur_radius.stops[0].value, 2.5f);
}

TEST(Build, one_colour_is_the_same_everywhere_and_none_is_open) {
  EXPECT_EQ(sfumato::colored({rgb(0x123456)}).color.stops.stops.size(), 1u);
  EXPECT_TRUE(sfumato::colored({rgb(0x123456)}).blur_radius.empty());
  EXPECT_EQ(sfumato::colored({}), Side{});
}

TEST(Build, layers_are_stacked_in_the_order_of_the_calls) {
  Document document;
  EXPECT_EQ(add_layer(document, {polyline({{0, 0}, {1, 1}})}), 0u);
  EXPECT_EQ(add_layer(document, {}, 0.5f, BlendMode::screen), 1u);
  add_instance(document, 0, {2, 0, 0, 2, 5, 6});
  ASSERT_EQ(document.stack.size(), 3u);
  const auto& second = std::get<LayerInstance>(document.stack[1]);
  EXPECT_EQ(second.opacity, 0.5f);
  EXPECT_EQ(second.blend, BlendMode::screen);
  const auto& third = std::get<LayerInstance>(document.stack[2]);
  EXPECT_EQ(third.layer, 0u);
  EXPECT_EQ(third.artboard_from_layer, (Affine{2, 0, 0, 2, 5, 6}));
}

/// Returns validate()'s status for a drawing with this curve.
Status status_with(Curve curve) {
  Document document;
  document.artboard = {{0, 0}, {10, 10}};
  add_layer(document, {std::move(curve)});
  return validate(Context{}, document);
}

TEST(Build, what_is_no_curve_is_refused_by_validate) {
  EXPECT_TRUE(status_with(polyline({{0, 0}, {1, 1}})).ok());
  EXPECT_EQ(status_with(polyline({{0, 0}})).code, StatusCode::bad_input);
  EXPECT_EQ(status_with(polyline({})).code, StatusCode::bad_input);
  EXPECT_EQ(status_with(bezier({{0, 0}, {1, 1}, {2, 2}})).code, StatusCode::bad_input);
  for (const float radius : {-1.0f, std::nanf("")}) {
    Curve blurred = polyline({{0, 0}, {1, 1}});
    blurred.left = sfumato::colored({rgb(0xff)}, radius);
    EXPECT_EQ(status_with(blurred).code, StatusCode::bad_input) << radius;
  }
}

}  // namespace
}  // namespace sfumato
