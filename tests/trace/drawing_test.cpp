// A traced curve in a document, and the detection of drawn pictures.
#include "trace/curves/drawing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "trace/image/picture.hpp"
#include "trace/planes_of.hpp"
#include "trace/traced_curves.hpp"

namespace sfumato::tracing {
namespace {

const std::vector<Stop<Rgb>>& left_stops(const Curve& curve) {
  return curve.left.color.stops.stops;
}

TEST(DocumentCurves, have_steps_where_they_are_on_a_long_piece) {
  TracedCurve curve = test::traced(test::straight_curve({0, 0}, {4000, 0}));
  curve.side[0].place = {0, 0.4886, 0.48893, 0.48893, 0.4891, 1};
  curve.side[0].value.assign(6, {0, 0, 0, 1});
  const std::vector<Curve> drawn = document_curves(std::vector{curve}, {1, 1}, false);
  const std::vector<Stop<Rgb>>& stops = left_stops(drawn[0]);
  ASSERT_EQ(stops.size(), 6u);
  EXPECT_EQ(stops[2].offset, stops[3].offset);
  EXPECT_NEAR(4000 * stops[2].offset, 4000 * 0.48893, 0.1);
  EXPECT_TRUE(std::ranges::is_sorted(stops, {}, &Stop<Rgb>::offset));
}

TEST(DocumentCurves, have_short_numbers_elsewhere) {
  TracedCurve curve = test::traced(test::straight_curve({0, 0}, {4000, 0}));
  curve.side[0].place = {0, 0.12345, 1};
  curve.side[0].value.assign(3, {0, 0, 0, 1});
  const std::vector<Curve> drawn = document_curves(std::vector{curve}, {1, 1}, false);
  EXPECT_EQ(left_stops(drawn[0])[1].offset, 0.12);
}

/// Returns a grey disc of this radius on white, in a picture of 100 by 100 pixels, with noise only
/// inside.
Plane disc_on_white(double radius, double noise) {
  const auto inside = [&](Vec2 p) { return length(p - Vec2{50, 50}) < radius; };
  Plane rough = test::plane_of(100, 100, [](Vec2) { return 0.5; });
  test::add_noise(rough, noise, 7);
  return test::plane_of(100, 100, [&](Vec2 p) {
    return inside(p) ? rough.at(static_cast<int>(p.x), static_cast<int>(p.y)) : 1.0f;
  });
}

Noise noise_of(const Plane& plane) {
  Context context;
  const Result<Noise> noise = estimate_noise(context, plane);
  EXPECT_TRUE(noise.ok());
  return noise ? *noise : Noise{};
}

TEST(EstimateNoise, tells_a_drawn_picture_from_a_photo_on_white) {
  EXPECT_TRUE(noise_of(disc_on_white(36, 0)).is_drawn);
  // 40 of 100 pixels.
  EXPECT_FALSE(noise_of(disc_on_white(36, 0.01)).is_drawn);
  EXPECT_FALSE(noise_of(disc_on_white(200, 0.01)).is_drawn);
}

TEST(EstimateNoise, finds_the_deviation) {
  EXPECT_NEAR(noise_of(disc_on_white(200, 0.01)).deviation, 0.01, 0.001);
  EXPECT_EQ(noise_of(disc_on_white(200, 0)).deviation, 0);
}

}  // namespace
}  // namespace sfumato::tracing
