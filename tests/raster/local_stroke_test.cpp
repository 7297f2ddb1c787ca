#include "raster/layers/local_stroke.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "curves/bezier.hpp"
#include "curves/stop_parameters.hpp"

namespace sfumato::test {
namespace {

using raster::StrokePainter;

constexpr int kStrokeSide = 160;
constexpr double kHalfCode = 0.5 / 255;

using Planes = std::array<std::vector<float>, 4>;

Planes transparent() {
  Planes planes;
  for (auto& plane : planes) plane.assign(std::size_t{kStrokeSide} * kStrokeSide, 0);
  return planes;
}

StrokePainter painter_of(const LocalCurve& curve, const Affine& image_from_artboard = {},
                         SimdLevel level = detected_simd_level(),
                         InterpolationSpace space = InterpolationSpace::srgb) {
  static Context context;  // must outlive the tables charged to it
  context.simd = level;
  Result<StrokePainter> painter =
      StrokePainter::create(context, {curve, {}}, image_from_artboard, space);
  EXPECT_TRUE(painter.ok()) << to_string(painter.status());
  return std::move(*painter);
}

void paint_part(const StrokePainter& painter, int x, int y, int width, int height, Planes& planes) {
  const std::size_t offset =
      static_cast<std::size_t>(y) * kStrokeSide + static_cast<std::size_t>(x);
  const Context context;
  const Status status = painter.paint(context, x, y, width, height, planes[0].data() + offset,
                                      planes[1].data() + offset, planes[2].data() + offset,
                                      planes[3].data() + offset, kStrokeSide);
  EXPECT_TRUE(status.ok()) << to_string(status);
}

Planes painted(const StrokePainter& painter) {
  Planes planes = transparent();
  paint_part(painter, 0, 0, kStrokeSide, kStrokeSide, planes);
  return planes;
}

float value(const Planes& planes, int channel, int x, int y) {
  return planes[static_cast<std::size_t>(channel)]
               [static_cast<std::size_t>(y) * kStrokeSide + static_cast<std::size_t>(x)];
}

template <class Value>
StopList<Value> stops(std::vector<Stop<Value>> list, StopSpace space = StopSpace::arc_length) {
  return {space, std::move(list)};
}

/// Returns a curve from (20, 80.5) to (140, 80.5), red on the left (above), blue on the right.
LocalCurve straight(float radius) {
  LocalCurve curve;
  curve.control_points = {{20, 80.5}, {60, 80.5}, {100, 80.5}, {140, 80.5}};
  curve.left_color = stops<Rgb>({{0, {1, 0, 0}}});
  curve.right_color = stops<Rgb>({{0, {0, 0, 1}}});
  curve.influence_radius = stops<float>({{0, radius}});
  return curve;
}

/// Returns a stroke like the paper's Fig. 8: everything varies.
LocalCurve wavy_stroke() {
  LocalCurve curve;
  curve.control_points = {{20, 80}, {45, -20}, {95, 0}, {80, 50}, {65, 95}, {130, 100}, {145, 20}};
  curve.left_color = stops<Rgb>({{0, {1, 0.2f, 0.1f}}, {0.5, {1, 0.9f, 0.1f}}, {1, {0, 0.6f, 1}}});
  curve.right_color = stops<Rgb>({{0, {0.2f, 0, 1}}, {1.5, {0, 0.8f, 0}}}, StopSpace::parameter);
  curve.blur_radius = stops<float>({{0, 0}, {0.5, 2}, {1, 10}});
  curve.influence_radius = stops<float>({{0, 0}, {0.3, 18}, {0.6, 7}, {0.85, 14}, {1, 0}});
  return curve;
}

/// Eq. 12–16 by 4,000 samples of the true curve per piece.
class DenseReference {
 public:
  DenseReference(const LocalCurve& curve, const Affine& image_from_stroke)
      : curve_(curve), stroke_from_image_(inverse(image_from_stroke)) {
    const std::vector<double> before = curves::cumulative_length(curve.control_points);
    constexpr int kSamples = 4000;
    for (std::size_t i = 0; i + 1 < before.size(); ++i) {
      const curves::Cubic cubic = curves::piece(curve.control_points, i);
      double walked = before[i];
      for (int k = 0; k < kSamples; ++k) {
        const double t = (k + 0.5) / kSamples;
        const Vec2 speed = curves::derivative_at(cubic, t);
        const double ds = length(speed) / kSamples;
        const double middle = walked + ds / 2;
        walked += ds;
        if (ds > 0) add(cubic, static_cast<double>(i), t, speed, ds, middle / before.back());
      }
    }
  }

  /// Returns premultiplied colour and opacity.
  std::array<double, 4> at(Vec2 image_point) const {
    const Vec2 p = stroke_from_image_(image_point);
    double weight = 0, color[3] = {};
    for (const Sample& s : samples_) {
      const Vec2 d = p - s.point;
      const double r = length(d) / s.influence;
      if (r >= 1) continue;
      const double w = (1 - r * r * (3 - 2 * r)) * s.ds / s.influence;
      const double u = std::clamp(0.5 + 0.5 * dot(s.left, d) / s.blur, 0.0, 1.0);
      const Rgb z = lerp(s.right_color, s.left_color, static_cast<float>(u * u * (3 - 2 * u)));
      weight += w;
      color[0] += w * z.r;
      color[1] += w * z.g;
      color[2] += w * z.b;
    }
    const double opacity = std::min(1.0, curve_.alpha * weight);
    const double share = weight > 0 ? opacity / weight : 0;
    return {color[0] * share, color[1] * share, color[2] * share, opacity};
  }

 private:
  struct Sample {
    Vec2 point, left;
    double ds, influence, blur;
    Rgb left_color, right_color;
  };

  template <class Value>
  static Value at_stops(const StopList<Value>& list, double parameter, double fraction) {
    const double x = list.space == StopSpace::parameter ? parameter : fraction;
    std::size_t next = 0;
    while (next < list.stops.size() && list.stops[next].offset <= x) ++next;
    if (next == 0) return list.stops.empty() ? Value{} : list.stops.front().value;
    if (next == list.stops.size()) return list.stops.back().value;
    const auto &a = list.stops[next - 1], &b = list.stops[next];
    return lerp(a.value, b.value, static_cast<float>((x - a.offset) / (b.offset - a.offset)));
  }

  void add(const curves::Cubic& cubic, double begin, double t, Vec2 speed, double ds,
           double fraction) {
    Sample s;
    s.point = curves::point_at(cubic, t);
    s.left = left_of(speed / length(speed));
    s.ds = ds;
    const double influence = at_stops(curve_.influence_radius, begin + t, fraction);
    // Below a pixel a stroke becomes fainter and not thinner.
    s.influence = std::max(influence, std::sqrt(std::fabs(stroke_from_image_.determinant())));
    s.ds *= influence / s.influence;
    // The pixel's square, as wide as a blur of this radius.
    const Vec2 x{stroke_from_image_.a, stroke_from_image_.b};
    const Vec2 y{stroke_from_image_.c, stroke_from_image_.d};
    const double blur = at_stops(curve_.blur_radius, begin + t, fraction);
    const double across = dot(s.left, x) * dot(s.left, x) + dot(s.left, y) * dot(s.left, y);
    s.blur = std::sqrt(blur * blur + 5.0 / 12 * across);
    s.left_color = at_stops(curve_.left_color, begin + t, fraction);
    s.right_color = at_stops(curve_.right_color, begin + t, fraction);
    samples_.push_back(s);
  }

  const LocalCurve& curve_;
  Affine stroke_from_image_;
  std::vector<Sample> samples_;
};

/// Returns the largest difference over a grid of pixels, code values of 1.
double largest_difference(const LocalCurve& curve, const Affine& image_from_stroke) {
  const Planes planes = painted(painter_of(curve, image_from_stroke));
  const DenseReference reference(curve, image_from_stroke);
  double largest = 0;
  for (int y = 1; y < kStrokeSide; y += 4) {
    for (int x = 1; x < kStrokeSide; x += 4) {
      const std::array<double, 4> expected = reference.at({x + 0.5, y + 0.5});
      for (int c = 0; c < 4; ++c) {
        largest = std::max(
            largest, std::fabs(expected[static_cast<std::size_t>(c)] - value(planes, c, x, y)));
      }
    }
  }
  return largest;
}

TEST(LocalStroke, the_axis_of_a_long_straight_stroke_has_opacity_alpha) {
  for (double alpha : {0.25, 0.6, 1.0}) {
    for (float radius : {2.0f, 7.5f, 30.0f}) {
      LocalCurve curve = straight(radius);
      curve.alpha = alpha;
      const Planes planes = painted(painter_of(curve));
      EXPECT_NEAR(value(planes, 3, 80, 80), alpha, 0.001) << radius;
    }
  }
}

TEST(LocalStroke, half_of_the_axis_is_opaque_at_an_end) {
  const Planes planes = painted(painter_of(straight(30)));
  EXPECT_NEAR(0.5 * (value(planes, 3, 19, 80) + value(planes, 3, 20, 80)), 0.5, 0.001);
}

TEST(LocalStroke, opacity_stops_at_one) {
  LocalCurve curve = straight(30);
  curve.alpha = 3;
  EXPECT_EQ(value(painted(painter_of(curve)), 3, 80, 80), 1.0f);
}

TEST(LocalStroke, a_cancelled_stroke_says_so_and_one_beside_it_does_not) {
  Context context;
  const Result<StrokePainter> painter =
      StrokePainter::create(context, {straight(10), {}}, {}, InterpolationSpace::srgb);
  ASSERT_TRUE(painter.ok());
  context.cancel = true;
  Planes planes = transparent();
  const auto code = [&](int y, int height) {
    return painter
        ->paint(context, 0, y, kStrokeSide, height, planes[0].data(), planes[1].data(),
                planes[2].data(), planes[3].data(), kStrokeSide)
        .code;
  };
  EXPECT_EQ(code(0, kStrokeSide), StatusCode::cancelled);
  EXPECT_EQ(code(0, 20), StatusCode::ok) << "nothing is to be painted there";
  for (float alpha : planes[3]) ASSERT_EQ(alpha, 0);
}

TEST(LocalStroke, beyond_the_influence_radius_nothing_is_painted) {
  const StrokePainter painter = painter_of(straight(10));
  const Planes planes = painted(painter);
  for (int y = 0; y < kStrokeSide; ++y) {
    for (int x = 0; x < kStrokeSide; ++x) {
      const double beside = std::max({20 - (x + 0.5), x + 0.5 - 140, 0.0});
      const double distance = std::hypot(beside, y + 0.5 - 80.5);
      const bool inside = painter.bounds_px().contains({x + 0.5, y + 0.5});
      const float alpha = value(planes, 3, x, y);
      EXPECT_TRUE(alpha == 0 || (distance < 10.001 && inside)) << x << ' ' << y;
      EXPECT_TRUE(alpha > 0 || distance > 9) << x << ' ' << y;
    }
  }
}

TEST(LocalStroke, each_side_has_its_colour_and_the_axis_their_mean) {
  LocalCurve curve = straight(20);
  curve.blur_radius = stops<float>({{0, 4}});
  const Planes planes = painted(painter_of(curve));
  const auto share = [&](int y) { return value(planes, 0, 80, y) / value(planes, 3, 80, y); };
  EXPECT_NEAR(share(70), 1, 1e-5);
  EXPECT_NEAR(share(80), 0.5, 1e-5);
  EXPECT_NEAR(share(90), 0, 1e-5);
  // smoothstep((R + 2) / 2R), R widened to sqrt(16 + 5/12)
  const double u = 0.5 + 1 / std::sqrt(16 + 5.0 / 12);
  EXPECT_NEAR(share(78), u * u * (3 - 2 * u), 1e-5);
}

TEST(LocalStroke, a_pixel_that_a_hard_side_cuts_has_both_colours) {
  for (double below : {-0.4, -0.2, 0.0, 0.2, 0.4}) {
    const Planes planes = painted(painter_of(straight(20), {1, 0, 0, 1, 0, below}));
    const auto share = [&](int y) { return value(planes, 0, 80, y) / value(planes, 3, 80, y); };
    // The left side is above the axis, at 80.5 + below: the pixel's share of it.
    EXPECT_NEAR(share(80), 0.5 + below, 0.07);
    EXPECT_NEAR(share(79), 1, 0.03);
    EXPECT_NEAR(share(81), 0, 0.03);
  }
}

TEST(LocalStroke, a_closed_curve_has_no_seam) {
  LocalCurve curve = straight(12);
  const double k = 50 * 0.5522847498;
  curve.control_points = {{130, 80},    {130, 80 + k}, {80 + k, 130}, {80, 130},    {80 - k, 130},
                          {30, 80 + k}, {30, 80},      {30, 80 - k},  {80 - k, 30}, {80, 30},
                          {80 + k, 30}, {130, 80 - k}, {130, 80}};
  const Planes planes = painted(painter_of(curve));
  for (int d = -12; d < 12; ++d) {
    EXPECT_NEAR(value(planes, 3, 130 + d, 80), value(planes, 3, 80, 130 + d), 0.002) << d;
    EXPECT_NEAR(value(planes, 0, 130 + d, 80), value(planes, 0, 80, 130 + d), 0.002) << d;
  }
}

TEST(LocalStroke, a_side_without_colours_takes_the_other_sides) {
  LocalCurve curve = straight(20);
  curve.left_color = {};
  const Planes planes = painted(painter_of(curve));
  for (int y = 65; y < 95; ++y) {
    EXPECT_NEAR(value(planes, 2, 80, y), value(planes, 3, 80, y), 1e-6);
  }
}

TEST(LocalStroke, equal_colours_on_both_sides_are_that_colour_everywhere) {
  LocalCurve curve = wavy_stroke();
  const Rgb color{0.25f, 0.5f, 0.75f};
  curve.left_color = stops<Rgb>({{0, color}});
  curve.right_color = stops<Rgb>({{0, color}}, StopSpace::parameter);
  const Planes planes = painted(painter_of(curve));
  for (int y = 0; y < kStrokeSide; ++y) {
    for (int x = 0; x < kStrokeSide; ++x) {
      ASSERT_NEAR(value(planes, 1, x, y), 0.5f * value(planes, 3, x, y), 1e-6);
    }
  }
}

TEST(LocalStroke, it_is_the_integral_of_the_paper_within_a_quarter_of_an_8_bit_step) {
  EXPECT_LT(largest_difference(wavy_stroke(), {}), kHalfCode / 2);
  LocalCurve sharp = wavy_stroke();
  sharp.blur_radius = {};
  EXPECT_LT(largest_difference(sharp, {}), kHalfCode / 2);
  LocalCurve even = wavy_stroke();
  even.influence_radius = stops<float>({{0, 9}});
  EXPECT_LT(largest_difference(even, {}), kHalfCode / 2);
}

TEST(LocalStroke, a_curve_whose_speed_varies_and_one_with_a_cusp_are_integrated_as_well) {
  LocalCurve curve = wavy_stroke();
  curve.right_color = stops<Rgb>({{0, {0, 0, 1}}, {1, {0, 1, 0}}});
  curve.control_points = {{20, 80}, {20, 80}, {140, 80}, {140, 80}};
  EXPECT_LT(largest_difference(curve, {}), kHalfCode / 2);
  curve.control_points = {{20, 60}, {140, 60}, {20, 60}, {140, 110}};
  EXPECT_LT(largest_difference(curve, {}), kHalfCode / 2);
}

TEST(LocalStroke, a_map_that_stretches_makes_ellipses_of_its_circles) {
  const Affine stretched{1.5, 0, 0, 0.5, -30, 20};
  EXPECT_LT(largest_difference(wavy_stroke(), stretched), kHalfCode / 2);
  const Affine sheared{0.8, 0.3, -0.5, 0.7, 30, -5};
  EXPECT_LT(largest_difference(wavy_stroke(), sheared), kHalfCode / 2);
}

TEST(LocalStroke, a_stroke_turned_by_a_right_angle_gives_the_turned_picture) {
  const Planes upright = painted(painter_of(wavy_stroke()));
  const Planes turned = painted(painter_of(wavy_stroke(), {0, 1, -1, 0, kStrokeSide, 0}));
  for (int y = 0; y < kStrokeSide; ++y) {
    for (int x = 0; x < kStrokeSide; ++x) {
      for (int c = 0; c < 4; ++c) {
        ASSERT_NEAR(value(turned, c, kStrokeSide - 1 - y, x), value(upright, c, x, y), 2e-5);
      }
    }
  }
}

TEST(LocalStroke, scaled_curve_and_radii_give_what_a_scaled_map_gives) {
  LocalCurve larger = wavy_stroke();
  for (Vec2& p : larger.control_points) p = p * 4;
  for (auto& stop : larger.influence_radius.stops) stop.value *= 4;
  for (auto& stop : larger.blur_radius.stops) stop.value *= 4;
  const Planes expected = painted(painter_of(wavy_stroke()));
  const Planes actual = painted(painter_of(larger, {0.25, 0, 0, 0.25, 0, 0}));
  for (std::size_t c = 0; c < 4; ++c) EXPECT_EQ(actual[c], expected[c]);
}

TEST(LocalStroke, a_stroke_thinner_than_a_pixel_is_as_much_fainter) {
  const auto mass = [](float radius) {
    const Planes planes = painted(painter_of(straight(radius)));
    double sum = 0;
    for (float alpha : planes[3]) sum += alpha;
    return sum;
  };
  // 0.3 π Q of opacity per unit of length.
  EXPECT_NEAR(mass(8), 0.3 * std::acos(-1.0) * 8 * 120, 1);
  EXPECT_NEAR(mass(0.5f) / mass(1), 0.5, 1e-4);
  EXPECT_NEAR(mass(0.125f) / mass(1), 0.125, 1e-4);
}

TEST(LocalStroke, it_is_composited_over_what_is_there) {
  LocalCurve curve = straight(20);
  curve.alpha = 0.5;
  Planes planes = transparent();
  planes[1].assign(planes[1].size(), 1);
  planes[3].assign(planes[3].size(), 1);
  paint_part(painter_of(curve), 0, 0, kStrokeSide, kStrokeSide, planes);
  EXPECT_NEAR(value(planes, 0, 80, 72) / 0.5f, value(painted(painter_of(curve)), 0, 80, 72) / 0.5f,
              1e-6);
  EXPECT_NEAR(value(planes, 1, 80, 80), 0.5f, 0.001f);
  for (float alpha : planes[3]) ASSERT_NEAR(alpha, 1, 1e-6);
}

TEST(LocalStroke, colours_are_blended_in_the_interpolation_space) {
  const StrokePainter painter =
      painter_of(straight(20), {}, detected_simd_level(), InterpolationSpace::linear);
  const Planes planes = painted(painter);
  const float half = static_cast<float>(code_from_linear(0.5));
  EXPECT_NEAR(value(planes, 0, 80, 80) / value(planes, 3, 80, 80), half, 1e-4);
}

TEST(LocalStroke, a_pixel_does_not_depend_on_the_rectangle_that_it_is_painted_in) {
  const StrokePainter painter = painter_of(wavy_stroke());
  const Planes whole = painted(painter);
  Planes parts = transparent();
  for (int y = 0; y < kStrokeSide; y += 23) {
    for (int x = 0; x < kStrokeSide; x += 37) {
      paint_part(painter, x, y, std::min(37, kStrokeSide - x), std::min(23, kStrokeSide - y),
                 parts);
    }
  }
  for (std::size_t c = 0; c < 4; ++c) EXPECT_EQ(parts[c], whole[c]);
}

TEST(LocalStroke, every_instruction_set_gives_the_same_bits) {
  for (InterpolationSpace space : {InterpolationSpace::srgb, InterpolationSpace::oklab}) {
    const Planes expected = painted(painter_of(wavy_stroke(), {}, SimdLevel::sse2, space));
    for (SimdLevel level : {SimdLevel::avx2, SimdLevel::avx512}) {
      if (level > detected_simd_level()) GTEST_SKIP() << "no such instruction set here";
      const Planes actual = painted(painter_of(wavy_stroke(), {}, level, space));
      for (std::size_t c = 0; c < 4; ++c) EXPECT_EQ(actual[c], expected[c]);
    }
  }
}

TEST(LocalStroke, hostile_values_give_finite_pixels) {
  std::vector<LocalCurve> curves(6, straight(30));
  curves[0].blur_radius = stops<float>({{0, 1e7f}});
  curves[1].influence_radius = stops<float>({{0, 1e7f}});
  curves[2].influence_radius = stops<float>({{0, 0}, {0.3, 0}, {0.3, 30}, {0.6, 30}, {0.6, 0}});
  curves[3].influence_radius = stops<float>({{0, 0}, {0.5, 1e-30f}, {1, 0}});
  curves[4].control_points.assign(4, {80, 80});
  curves[5].control_points = {{-1e7, -1e7}, {1e7, 1e7}, {-1e7, 1e7}, {1e7, -1e7}};
  const Affine maps[] = {{},
                         {1e7, 0, 0, 1e7, -8e8, -8.05e8},
                         {1e-7, 0, 0, 1e-7, 80, 80},
                         {1, 0, 0, 1e-9, 0, 80},
                         {1e7, 0, 0, 1e-7, 0, 0},
                         {1, 1, 1, 1 + 1e-12, 0, 0}};
  for (const LocalCurve& curve : curves) {
    for (const Affine& map : maps) {
      const Planes planes = painted(painter_of(curve, map));
      for (const auto& plane : planes) {
        for (float v : plane) ASSERT_TRUE(v >= 0 && v <= 1) << v;
      }
    }
  }
}

TEST(LocalStroke, a_stroke_without_colour_or_length_paints_nothing) {
  LocalCurve point = straight(30), plain = straight(30);
  point.control_points.assign(7, {80, 80});
  plain.left_color = plain.right_color = {};
  for (const LocalCurve& curve : {point, plain}) {
    EXPECT_TRUE(painter_of(curve).bounds_px().empty());
    EXPECT_EQ(painted(painter_of(curve)), transparent());
  }
}

TEST(LocalStroke, a_budget_that_is_too_small_is_a_limit_error) {
  Context context{.budget = Budget(4096)};
  const Result<StrokePainter> painter =
      StrokePainter::create(context, {wavy_stroke(), {}}, {}, InterpolationSpace::srgb);
  EXPECT_EQ(painter.status().code, StatusCode::limit);
  EXPECT_EQ(context.budget.used(), 0u);
}

TEST(LocalStroke, its_memory_is_given_back) {
  Context context;
  {
    const Result<StrokePainter> painter =
        StrokePainter::create(context, {wavy_stroke(), {}}, {}, InterpolationSpace::srgb);
    ASSERT_TRUE(painter.ok());
    EXPECT_GT(context.budget.used(), 0u);
  }
  EXPECT_EQ(context.budget.used(), 0u);
}

}  // namespace
}  // namespace sfumato::test
