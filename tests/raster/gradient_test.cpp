#include "raster/shaders/gradient.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace sfumato::test {
namespace {

using raster::Gradient;
using Sample = std::array<float, 4>;

/// A frame with small pixels: samples are nearly points.
constexpr Affine kFine{1e-4, 0, 0, 1e-4, 0, 0};

GradientFill fill_of(std::variant<LinearGradient, RadialGradient> shape,
                     SpreadMethod spread = SpreadMethod::pad) {
  return {shape, spread, {}, {{0, {0, 0, 1}, 1}, {0.25, {0.5f, 0, 1}, 1}, {1, {1, 0, 0}, 0.5f}}};
}

/// From (10, 20), 100 long in x.
const LinearGradient kLinear{{10, 20}, {110, 20}};

Gradient gradient_of(const GradientFill& fill) {
  static Context context;  // must outlive the tables charged to it
  Result<Gradient> gradient = Gradient::create(context, fill);
  EXPECT_TRUE(gradient.ok()) << to_string(gradient.status());
  return std::move(*gradient);
}

Sample sample(const Gradient& gradient, const Affine& layer_from_image, Vec2 image_point) {
  Sample s;
  gradient.evaluate(layer_from_image, image_point, 1, {&s[0], &s[1], &s[2], &s[3]});
  return s;
}

/// Returns the gradient at a point of the layer.
Sample at(const GradientFill& fill, Vec2 p) {
  return sample(gradient_of(fill), kFine, p / kFine.a);
}

void expect_near(const Sample& actual, const Sample& expected, double tolerance = 1e-5) {
  for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(actual[c], expected[c], tolerance) << c;
}

TEST(Gradient, a_linear_gradient_is_linear_between_its_stops) {
  expect_near(at(fill_of(kLinear), {22.5, -7}), {0.25f, 0, 1, 1});
  expect_near(at(fill_of(kLinear), {72.5, 300}), {0.75f, 0, 0.5f, 0.75f});
}

TEST(Gradient, it_goes_on_as_its_first_and_last_stop) {
  expect_near(at(fill_of(kLinear), {-1000, 0}), {0, 0, 1, 1});
  expect_near(at(fill_of(kLinear), {111, 0}), {1, 0, 0, 0.5f});
  GradientFill inner = fill_of(kLinear);
  inner.stops = {{0.5, {0.25f, 0.5f, 0.75f}, 1}};
  for (double x : {-10.0, 40.0, 80.0, 200.0})
    expect_near(at(inner, {x, 0}), {0.25f, 0.5f, 0.75f, 1});
}

TEST(Gradient, repeat_begins_again_and_reflect_turns_round) {
  for (double round : {-3.0, -2.0, -1.0, 1.0, 2.0, 7.0}) {
    const Vec2 p{22.5 + 100 * round, 0};
    expect_near(at(fill_of(kLinear, SpreadMethod::repeat), p), {0.25f, 0, 1, 1}, 1e-4);
    const bool back = std::fmod(round, 2) != 0;
    const Vec2 mirrored{back ? 110 - 12.5 + 100 * round : p.x, 0};
    expect_near(at(fill_of(kLinear, SpreadMethod::reflect), mirrored), {0.25f, 0, 1, 1}, 1e-4);
  }
}

TEST(Gradient, its_transform_moves_it) {
  GradientFill fill = fill_of(kLinear);
  fill.layer_from_gradient = {0, 2, -2, 0, 5, 7};
  expect_near(at(fill, fill.layer_from_gradient({22.5, 3})), {0.25f, 0, 1, 1});
}

TEST(Gradient, a_linear_gradient_without_length_is_its_last_stop) {
  const GradientFill fill = fill_of(LinearGradient{{3, 4}, {3, 4}}, SpreadMethod::repeat);
  expect_near(at(fill, {3, 4}), {1, 0, 0, 0.5f});
  expect_near(at(fill, {-50, 4}), {1, 0, 0, 0.5f});
}

TEST(Gradient, a_radial_gradient_is_linear_in_the_distance) {
  const GradientFill fill = fill_of(RadialGradient{{50, 60}, {50, 60}, 40});
  expect_near(at(fill, {50 + 3, 60 - 4}), {0.25f, 0, 1, 1});
  expect_near(at(fill, {50, 60 + 25}), {0.75f, 0, 0.5f, 0.75f});
  expect_near(at(fill, {500, 60}), {1, 0, 0, 0.5f});
}

TEST(Gradient, from_the_focus_it_is_linear_along_every_ray_to_the_circle) {
  for (double away : {0.3, 0.9, 0.99}) {
    const RadialGradient shape{{50, 60}, {50 + 40 * away, 60}, 40};
    const GradientFill fill = fill_of(shape);
    for (int i = 0; i < 12; ++i) {
      const double angle = 0.3 + i * 0.5;
      const Vec2 rim = shape.center + Vec2{std::cos(angle), std::sin(angle)} * shape.radius;
      expect_near(at(fill, lerp(shape.focus, rim, 0.125)), {0.25f, 0, 1, 1}, 2e-4);
      expect_near(at(fill, lerp(shape.focus, rim, 0.625)), {0.75f, 0, 0.5f, 0.75f}, 2e-4);
    }
  }
}

TEST(Gradient, a_focus_on_the_rim_leaves_no_point_without_colour) {
  const GradientFill fill = fill_of(RadialGradient{{50, 60}, {90, 60}, 40});
  expect_near(at(fill, {50, 60}), {2 / 3.0f, 0, 2 / 3.0f, 5 / 6.0f}, 2e-3);
  for (double x : {89.0, 90.0, 90.001, 95.0, 1e5}) {
    const Sample s = at(fill, {x, 61});
    EXPECT_GE(s[3], 0.5f);
    EXPECT_LE(s[3], 1.0f);
  }
  expect_near(at(fill, {95, 60}), {1, 0, 0, 0.5f});
}

TEST(Gradient, a_focus_outside_of_the_circle_fills_the_cone) {
  // The circle of radius 10 around (20, 0) as seen from the origin: 30 degrees on both sides.
  const GradientFill fill = fill_of(RadialGradient{{20, 0}, {0, 0}, 10});
  // On the axis, circle t reaches from 10 t to 30 t.
  expect_near(at(fill, {2.5, 0}), {0.5f, 0, 1, 1}, 1e-3);
  expect_near(at(fill, {6.25, 0}), {0.75f, 0, 0.5f, 0.75f}, 1e-3);
  for (double degrees : {-29.0, 29.0}) {
    const double angle = degrees * std::acos(-1.0) / 180;
    EXPECT_GE(at(fill, Vec2{std::cos(angle), std::sin(angle)} * 5)[3], 0.5f) << degrees;
  }
  for (double degrees : {-31.0, 31.0, 90.0, 180.0, 150.0}) {
    const double angle = degrees * std::acos(-1.0) / 180;
    EXPECT_EQ(at(fill, Vec2{std::cos(angle), std::sin(angle)} * 5)[3], 0) << degrees;
  }
}

TEST(Gradient, the_border_of_a_cone_is_smooth_over_a_pixel) {
  GradientFill fill = fill_of(RadialGradient{{2000, 0}, {0, 0}, 1000});
  for (GradientStop& stop : fill.stops) stop.alpha = 1;
  const Gradient gradient = gradient_of(fill);
  const double border = 300 * std::tan(std::acos(-1.0) / 6);
  const Vec2 across{-0.5, std::sqrt(0.75)};  // outside the cone
  float before = 1;
  for (double off = -0.6; off <= 0.6; off += 0.1) {
    const float alpha = sample(gradient, {}, Vec2{300, border} + across * off)[3];
    EXPECT_NEAR(alpha, std::clamp(0.5 - off, 0.0, 1.0), 0.02) << off;
    EXPECT_LE(alpha, before);
    before = alpha;
  }
}

TEST(Gradient, a_focal_circle_has_offset_0_on_it) {
  const GradientFill fill = fill_of(RadialGradient{{50, 60}, {50, 60}, 40, 10});
  expect_near(at(fill, {50 + 5, 60}), {0, 0, 1, 1});
  expect_near(at(fill, {50 + 10 + 7.5, 60}), {0.5f, 0, 1, 1});
  expect_near(at(fill, {50, 60 - 50}), {1, 0, 0, 0.5f});
  // A focal circle around the circle reverses the offsets.
  const GradientFill inward = fill_of(RadialGradient{{50, 60}, {50, 60}, 10, 40});
  expect_near(at(inward, {50 + 32.5, 60}), {0.5f, 0, 1, 1});
  expect_near(at(inward, {50 + 10, 60}), {1, 0, 0, 0.5f});
}

TEST(Gradient, two_equal_circles_paint_nothing) {
  const GradientFill fill = fill_of(RadialGradient{{50, 60}, {50, 60}, 10, 10});
  for (double x : {50.0, 60.0, 90.0}) EXPECT_EQ(at(fill, {x, 60})[3], 0);
}

TEST(Gradient, equal_offsets_are_a_step) {
  GradientFill fill = fill_of(kLinear);
  fill.stops = {{0, {1, 0, 0}, 1}, {0.5, {1, 0, 0}, 1}, {0.5, {0, 1, 0}, 1}, {1, {0, 1, 0}, 1}};
  expect_near(at(fill, {59.99, 0}), {1, 0, 0, 1});
  expect_near(at(fill, {60.01, 0}), {0, 1, 0, 1});
}

TEST(Gradient, a_pixel_on_a_step_is_the_mean_of_what_it_covers) {
  GradientFill fill = fill_of(kLinear);
  fill.stops = {{0, {1, 0, 0}, 1}, {0.5, {1, 0, 0}, 1}, {0.5, {0, 1, 0}, 0.5f}};
  const Gradient gradient = gradient_of(fill);
  // A quarter of the pixel lies beyond x = 60: alpha 0.75 + 0.25 / 2, colours weighted by it.
  const Sample s = sample(gradient, {}, {59.75, 0});
  expect_near(s, {0.75f / 0.875f, 0.125f / 0.875f, 0, 0.875f});
}

TEST(Gradient, stripes_finer_than_a_pixel_are_their_mean) {
  GradientFill fill = fill_of(kLinear, SpreadMethod::repeat);
  fill.stops = {{0, {1, 1, 1}, 1}, {0.5, {1, 1, 1}, 1}, {0.5, {0, 0, 0}, 1}};
  for (SpreadMethod spread : {SpreadMethod::repeat, SpreadMethod::reflect}) {
    fill.spread = spread;
    const Gradient gradient = gradient_of(fill);
    for (double x = 0; x < 40; x += 1.7) {
      EXPECT_NEAR(sample(gradient, {7030, 0, 0, 7030, 0, 0}, {x, 3})[0], 0.5f, 0.02);
    }
  }
}

TEST(Gradient, many_stops_are_found_exactly) {
  GradientFill fill = fill_of(kLinear);
  fill.stops.clear();
  for (int i = 0; i <= 1000; ++i) {
    fill.stops.push_back({i / 1000.0, {static_cast<float>(i % 7) / 7, 0, 0}, 1});
  }
  const Gradient gradient = gradient_of(fill);
  for (int i = 0; i < 1000; i += 37) {
    const float a = static_cast<float>(i % 7) / 7, b = static_cast<float>((i + 1) % 7) / 7;
    const Vec2 p{10 + (i + 0.25) / 10, 0};
    EXPECT_NEAR(sample(gradient, kFine, p / kFine.a)[0], a + (b - a) / 4, 1e-5);
  }
}

TEST(Gradient, extreme_maps_give_finite_colours) {
  const RadialGradient radial{{0, 0}, {1e7, 0}, 1e7};
  const RadialGradient small{{0, 0}, {0, 0}, 1e-7};
  const RadialGradient cone{{0, 0}, {1e7, 0}, 1e-3, 1e-7};
  for (const GradientFill& fill :
       {fill_of(cone), fill_of(cone, SpreadMethod::reflect), fill_of(kLinear, SpreadMethod::repeat),
        fill_of(LinearGradient{{0, 0}, {1e-7, 0}}), fill_of(radial, SpreadMethod::reflect),
        fill_of(small, SpreadMethod::repeat)}) {
    const Gradient gradient = gradient_of(fill);
    for (double scale : {1e-300, 1e-9, 1.0, 1e9, 1e300}) {
      for (double x : {0.0, 0.5, -1e7}) {
        for (float v : sample(gradient, {scale, 0, 0, scale, 0, 0}, {x, 0.5})) {
          EXPECT_TRUE(v >= 0 && v <= 1) << v;
        }
      }
    }
  }
}

}  // namespace
}  // namespace sfumato::test
