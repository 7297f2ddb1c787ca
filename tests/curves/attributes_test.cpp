#include "curves/attributes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace sfumato::curves {
namespace {

Curve line_with_left(StopSpace space, std::vector<Stop<Rgb>> stops) {
  Curve curve{.control_points = {{0, 0}, {30, 0}, {60, 0}, {90, 0}}};
  curve.left.color = {ShaderKind::curve_domain, {space, std::move(stops)}, 0};
  return curve;
}

struct Sampled {
  FlatCurves flat;
  SegmentAttributes attributes;
};

Sampled sampled(const Curve& curve) {
  Context context;
  const std::vector<Curve> curves{curve};
  Result<FlatCurves> flat = flatten(context, curves, {});
  TableMemory memory("a test");
  Result<SegmentAttributes> attributes =
      sample_colors(context, *flat, curves, InterpolationSpace::srgb, memory);
  return {std::move(*flat), std::move(*attributes)};
}

TEST(Attributes, colours_are_linear_between_stops) {
  const Sampled s = sampled(
      line_with_left(StopSpace::parameter, {{0, {0, 0, 0}}, {0.5, {1, 0, 0}}, {1, {1, 1, 0}}}));
  ASSERT_EQ(s.flat.segment_count(), 2u);
  EXPECT_EQ(s.attributes.left[0].value.start, (Rgb{0, 0, 0}));
  EXPECT_EQ(s.attributes.left[0].value.end, (Rgb{1, 0, 0}));
  EXPECT_EQ(s.attributes.left[1].value.start, (Rgb{1, 0, 0}));
  EXPECT_EQ(s.attributes.left[1].value.end, (Rgb{1, 1, 0}));
}

TEST(Attributes, before_the_first_and_after_the_last_stop_the_colour_is_constant) {
  const Sampled s =
      sampled(line_with_left(StopSpace::parameter, {{0.25, {1, 0, 0}}, {0.75, {0, 0, 1}}}));
  ASSERT_EQ(s.flat.segment_count(), 3u);
  EXPECT_EQ(s.attributes.left[0].value.start, (Rgb{1, 0, 0}));
  EXPECT_EQ(s.attributes.left[0].value.end, (Rgb{1, 0, 0}));
  EXPECT_EQ(s.attributes.left[2].value.end, (Rgb{0, 0, 1}));
}

TEST(Attributes, two_stops_at_one_place_are_a_step) {
  const Sampled s = sampled(line_with_left(
      StopSpace::parameter, {{0, {1, 0, 0}}, {0.5, {1, 0, 0}}, {0.5, {0, 0, 1}}, {1, {0, 0, 1}}}));
  ASSERT_EQ(s.flat.segment_count(), 2u);
  EXPECT_EQ(s.attributes.left[0].value.end, (Rgb{1, 0, 0}));
  EXPECT_EQ(s.attributes.left[1].value.start, (Rgb{0, 0, 1}));
}

TEST(Attributes, a_list_in_arc_length_is_linear_in_length_not_in_the_parameter) {
  Curve curve = line_with_left(StopSpace::arc_length, {{0, {0, 0, 0}}, {1, {1, 1, 1}}});
  curve.control_points = {{0, 0}, {0, 0}, {90, 0}, {90, 0}};
  const Sampled s = sampled(curve);
  for (std::uint32_t v = 0; s.flat.begins_segment(v); ++v) {
    EXPECT_NEAR(s.attributes.left[v].value.start.channel[0], s.flat.vertex[v].x / 90, 1e-6);
  }
}

TEST(Attributes, a_side_without_colour_stays_open) {
  const Sampled s = sampled(line_with_left(StopSpace::parameter, {{0, {1, 1, 1}}}));
  EXPECT_EQ(s.attributes.left[0].kind, ShaderKind::curve_domain);
  EXPECT_EQ(s.attributes.right[0].kind, ShaderKind::open);
}

TEST(Attributes, the_weight_of_a_curve_is_on_all_its_segments) {
  Curve curve = line_with_left(StopSpace::parameter, {{0, {}}, {0.5, {}}});
  curve.weight = 2.5;
  const Sampled s = sampled(curve);
  EXPECT_EQ(s.attributes.weight[0], 2.5f);
  EXPECT_EQ(s.attributes.weight[1], 2.5f);
}

using Place = std::array<float, 3>;

Place place(const FieldValue& value) {
  return {value.channel[0], value.channel[1], value.channel[2]};
}

TEST(StopPlaces, are_fractions_between_stops_that_are_counted_curve_by_curve_left_then_right) {
  Curve first = line_with_left(StopSpace::parameter, {{0.25, {}}, {0.75, {}}});
  first.right.color = {ShaderKind::curve_domain, {StopSpace::arc_length, {{0, {}}, {1, {}}}}, 0};
  first.right.opacity = {ShaderKind::curve_domain, {StopSpace::parameter, {{0, 1.0f}}}, 0};
  Curve second = line_with_left(StopSpace::parameter, {{0, {}}});
  second.right.color = {ShaderKind::image_domain, {}, 7};
  const std::vector<Curve> curves{first, second};
  EXPECT_EQ(stop_count(curves, StopAttribute::color), 5u);
  EXPECT_EQ(stop_count(curves, StopAttribute::opacity), 1u);
  Context context;
  const FlatCurves flat = *flatten(context, curves, {});
  TableMemory memory("a test");
  const SegmentAttributes places =
      *sample_stop_places(context, flat, curves, StopAttribute::color, memory);
  EXPECT_EQ(context.budget.used(),
            capacity_bytes(places.left, places.right, places.weight, places.vertex, places.curve));
  // Before its first stop, between the two, after the last.
  EXPECT_EQ(place(places.left[0].value.start), (Place{0, 0, 0}));
  EXPECT_EQ(place(places.left[0].value.end), (Place{0, 0, 0}));
  EXPECT_EQ(place(places.left[1].value.start), (Place{0, 0, 0}));
  EXPECT_EQ(place(places.left[1].value.end), (Place{1, 0, 0}));
  EXPECT_EQ(place(places.left[2].value.start), (Place{0, 1, 0}));
  EXPECT_EQ(place(places.left[2].value.end), (Place{0, 1, 0}));
  EXPECT_EQ(place(places.right[1].value.start), (Place{0.25f, 2, 0}));
  EXPECT_EQ(place(places.right[1].value.end), (Place{0.75f, 2, 0}));
  const std::uint32_t s = flat.curve_begin[1];
  EXPECT_EQ(place(places.left[s].value.end), (Place{0, 4, 1}));
  EXPECT_EQ(places.right[s].kind, ShaderKind::image_domain);
  EXPECT_EQ(place(places.right[s].value.start), (Place{0, 0, 1}));
  EXPECT_EQ(places.shader, std::vector<std::uint32_t>{7});
}

TEST(StopPlaces, with_a_step_lie_on_the_side_of_it_where_the_segment_is) {
  const std::vector<Curve> curves{
      line_with_left(StopSpace::parameter, {{0, {}}, {0.5, {}}, {0.5, {}}, {1, {}}})};
  Context context;
  const FlatCurves flat = *flatten(context, curves, {});
  TableMemory memory("a test");
  const SegmentAttributes places =
      *sample_stop_places(context, flat, curves, StopAttribute::color, memory);
  EXPECT_EQ(place(places.left[0].value.end), (Place{1, 0, 0}));
  EXPECT_EQ(place(places.left[1].value.start), (Place{0, 2, 0}));
}

TEST(StopPlaces, of_more_stops_than_a_float_can_count_are_a_limit_error) {
  Curve curve = line_with_left(StopSpace::parameter, {{0, {}}});
  std::vector<Curve> curves{curve};
  Context context;
  const FlatCurves flat = *flatten(context, curves, {});
  curves[0].left.opacity.kind = ShaderKind::curve_domain;
  curves[0].left.opacity.stops.stops.resize(kMostStopPlaces + 1);
  TableMemory memory("a test");
  const Result<SegmentAttributes> places =
      sample_stop_places(context, flat, curves, StopAttribute::opacity, memory);
  ASSERT_FALSE(places.ok());
  EXPECT_EQ(places.status().code, StatusCode::limit);
  EXPECT_EQ(places.status().limit, "stops");
  EXPECT_TRUE(sample_stop_places(context, flat, curves, StopAttribute::color, memory).ok());
}

}  // namespace
}  // namespace sfumato::curves
