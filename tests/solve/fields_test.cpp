#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sfumato/solve/diffuse.hpp"
#include "sfumato/solve/point_evaluator.hpp"
#include "solve/diffused.hpp"
#include "support/drawing.hpp"
#include "support/picture_sampler.hpp"

// Colour and opacity as two fields, blur, shaders by their weights (paper sections 3 to 5).
namespace sfumato {
namespace {

using test::blurred;
using test::circle_curve;
using test::colored;
using test::diffused;
using test::one_layer;
using test::straight_curve;
using test::with_opacity;

Curve imaged(Curve curve, std::uint32_t left, std::uint32_t right) {
  curve.left.color = {ShaderKind::image_domain, {}, left};
  curve.right.color = {ShaderKind::image_domain, {}, right};
  return curve;
}

Shader gradient() {
  return {"gradient", GradientFill{LinearGradient{}, SpreadMethod::pad, {}, {{0, {}, 1}}}};
}

double opacity_at(const Picture& picture, Vec2 p) {
  const auto value = test::sample_field(picture.layers[0], picture.layers[0].opacity, p);
  return value ? (*value)[0] : 0;
}

TEST(Fields, a_layer_without_opacity_has_no_opacity_field) {
  const Picture picture =
      diffused(one_layer({colored(circle_curve({50, 50}, 30), test::kRed, test::kBlue)}));
  EXPECT_EQ(picture.layers[0].opacity.channel_count, 0);
}

TEST(Fields, one_opacity_on_all_sides_is_that_opacity_everywhere) {
  Curve circle = with_opacity(colored(circle_curve({50, 50}, 30), test::kRed, test::kBlue), .5, .5);
  const Picture picture = diffused(one_layer({circle}));
  for (double x = 3; x < 100; x += 8) {
    EXPECT_NEAR(opacity_at(picture, {x, 0.7 * x + 11}), 0.5, 1e-5);
  }
}

TEST(Fields, colour_ignores_curves_of_opacity_and_opacity_those_of_colour) {
  const Curve color = colored(straight_curve({-20, 50}, {120, 50}), test::kRed, test::kBlue);
  const Curve mask = with_opacity(straight_curve({50, -20}, {50, 120}), 1, 0.25);
  // Soft ends of the mask reach far, but weakly: 0.001 here.
  const Picture both = diffused(one_layer({color, mask}), {.ends = gather::Ends::paper});
  const auto above = test::sample(both.layers[0], {80.3, 20.1});
  EXPECT_NEAR((*above)[0], 1, 1e-5);  // the mask between does not stop the red
  EXPECT_NEAR(opacity_at(both, {20.2, 80.4}), 0.25, 1e-5);
  EXPECT_NEAR(opacity_at(both, {80.2, 80.4}), 1, 1e-5);
}

TEST(Fields, curves_that_bear_both_give_the_same_as_two_fields) {
  const auto both = [](Curve curve) { return with_opacity(std::move(curve), 0.3f, 0.9f); };
  std::vector<Curve> curves{
      blurred(both(colored(circle_curve({40, 50}, 25), test::kRed, test::kBlue)), 4),
      both(colored(straight_curve({70, 20}, {85, 80}), test::kGreen, test::kWhite))};
  const Picture joint = diffused(one_layer(curves));
  // A speck of opacity without colour, far outside, separates the fields.
  curves.push_back(with_opacity(straight_curve({5000, 0}, {5000.1, 0}), 0.5f, 0.5f));
  const Picture apart = diffused(one_layer(curves));
  EXPECT_EQ(joint.layers[0].color.channel_count, 3);
  EXPECT_EQ(joint.layers[0].opacity.channel_count, 1);
  for (double x = 3.1; x < 100; x += 5.3) {
    const Vec2 p{x, 95 - 0.9 * x};
    const auto a = test::sample(joint.layers[0], p), b = test::sample(apart.layers[0], p);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR((*a)[c], (*b)[c], 2.0 / 255);
    EXPECT_NEAR(opacity_at(joint, p), opacity_at(apart, p), 2.0 / 255);
  }
}

TEST(Fields, a_curve_of_neither_changes_nothing) {
  const Curve line = colored(straight_curve({10, 30}, {90, 60}), test::kRed, test::kBlue);
  const Curve neither = straight_curve({20, 90}, {80, 10});
  const Picture with = diffused(one_layer({line, neither}));
  const Picture without = diffused(one_layer({line}));
  for (double x = 4; x < 100; x += 9) {
    const Vec2 p{x, 100.3 - x};
    const auto a = test::sample(with.layers[0], p), b = test::sample(without.layers[0], p);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR((*a)[c], (*b)[c], 1.5 / 255);
  }
}

TEST(Fields, what_is_nowhere_opaque_has_no_triangles) {
  const Curve mask =
      with_opacity(colored(circle_curve({50, 50}, 20), test::kRed, test::kRed), 0, 1);
  const Picture picture = diffused(one_layer({mask}));
  const PatchLayer& layer = picture.layers[0];
  EXPECT_FALSE(test::sample(layer, {90, 90}).has_value());
  EXPECT_TRUE(test::sample(layer, {50, 50}).has_value());
  EXPECT_LT(layer.triangle_count(), 2000u);
}

TEST(Fields, a_soft_mask_falls_by_smoothstep_over_its_radius) {
  const Curve color = colored(circle_curve({50, 50}, 400), test::kRed, test::kRed);
  const Curve mask = blurred(with_opacity(straight_curve({-400, 50}, {500, 50}), 1, 0), 12);
  const Picture picture = diffused(one_layer({color, mask}));
  for (double d : {-11.0, -6.0, -1.0, 2.0, 5.0, 10.0, 13.0}) {
    const double x = std::clamp((d + 12) / 24, 0.0, 1.0);
    EXPECT_NEAR(opacity_at(picture, {47.7, 50 - d}), x * x * (3 - 2 * x), 1.2 / 255) << d;
  }
}

TEST(Fields, the_weights_of_shaders_and_white_sum_to_one) {
  Document document = one_layer({imaged(straight_curve({10, 20}, {90, 35}), 0, 1),
                                 blurred(imaged(straight_curve({20, 80}, {80, 60}), 2, 0), 9),
                                 colored(circle_curve({60, 50}, 9), test::kWhite, test::kWhite)});
  document.layers[0].curves[0].left.color = test::one_color(test::kWhite);
  for (int i = 0; i < 3; ++i) document.shaders.push_back(gradient());
  const Picture picture = diffused(document);
  const PatchLayer& layer = picture.layers[0];
  ASSERT_EQ(layer.color.channel_count, 6);
  EXPECT_EQ(layer.color.shader, (std::vector<std::uint32_t>{1, 2, 0}));
  for (std::size_t node = 0; node < layer.color.node_value.size() / 6; ++node) {
    const float* value = layer.color.node_value.data() + 6 * node;
    EXPECT_NEAR(value[0] + value[3] + value[4] + value[5], 1, 1e-5);
  }
}

TEST(Fields, a_blurred_curve_has_the_mean_of_its_sides) {
  const Picture picture = diffused(one_layer(
      {blurred(colored(straight_curve({10, 50}, {90, 50}), test::kRed, test::kBlue), 8)}));
  const auto on_it = test::sample(picture.layers[0], {50.1, 50 - 1e-6});
  EXPECT_NEAR((*on_it)[0], 0.5, 1e-3);
  EXPECT_NEAR((*on_it)[2], 0.5, 1e-3);
}

/// Returns the largest difference of the patches from the gather at points near the first curve.
double largest_miss(const Document& document, const DiffuseOptions& options, double reach) {
  const Picture picture = diffused(document, options);
  Context context;
  Result<PointEvaluator> evaluator = PointEvaluator::create(context, document, options);
  EXPECT_TRUE(evaluator.ok());
  double worst = 0;
  for (double x = 21.3; x < 79; x += 3.7) {
    for (double d = -reach; d <= reach; d += reach / 7.3) {
      const Vec2 p{x, 50 + d};
      float exact[3];
      std::uint8_t hit = 0;
      EXPECT_TRUE(evaluator->evaluate(context, 0, {&p, 1}, exact, {&hit, 1}).ok());
      const auto value = test::sample(picture.layers[0], p);
      for (int c = 0; c < 3; ++c) worst = std::max(worst, std::fabs((*value)[c] - exact[c]));
    }
  }
  return worst * 255;
}

TEST(Fields, small_radii_do_not_alias) {
  for (float radius : {2.0f, 5.0f, 20.0f}) {
    const Document document = one_layer(
        {blurred(colored(straight_curve({10, 50}, {90, 50}), test::kWhite, test::kBlack), radius)});
    EXPECT_LE(largest_miss(document, {}, 1.5 * radius), 2) << radius;
  }
}

TEST(Fields, radii_below_a_pixel_make_no_mesh_of_their_own) {
  const Curve circle = colored(circle_curve({50, 50}, 30), test::kWhite, test::kBlack);
  const Picture sharp = diffused(one_layer({circle}));
  const Picture tiny = diffused(one_layer({blurred(circle, 0.2f)}));
  EXPECT_EQ(tiny.layers[0].triangle_count(), sharp.layers[0].triangle_count());
  // Its chords are finer, and their errors show.
  const Picture fine = diffused(one_layer({blurred(circle, 0.5f)}));
  EXPECT_LT(fine.layers[0].triangle_count(), 2 * sharp.layers[0].triangle_count());
  // Enlarged, they are visible.
  const DiffuseOptions enlarged{.viewport = Box{{75, 45}, {85, 55}}, .pixels_per_unit = 10};
  EXPECT_GT(diffused(one_layer({blurred(circle, 0.5f)}), enlarged).layers[0].triangle_count(),
            diffused(one_layer({circle}), enlarged).layers[0].triangle_count());
}

TEST(Fields, the_mesh_follows_the_radii_even_where_it_is_not_refined) {
  const Document document = one_layer(
      {blurred(colored(straight_curve({10, 50}, {90, 50}), test::kWhite, test::kBlack), 5)});
  EXPECT_LE(largest_miss(document, {.max_error = 0}, 7), 12);
}

TEST(Fields, blur_can_be_ignored) {
  const Document document = one_layer(
      {blurred(colored(straight_curve({-50, 50}, {150, 50}), test::kRed, test::kBlue), 20)});
  const auto near = test::sample(diffused(document, {.ignore_blur = true}).layers[0], {50, 49.5});
  EXPECT_NEAR((*near)[0], 1, 1e-5);
}

TEST(Fields, an_enlarged_instance_is_as_fine_as_its_layer_drawn_large) {
  const auto lines = [](double s) {
    return std::vector{
        colored(straight_curve({10 * s, 50 * s}, {70 * s, 20 * s}), test::kWhite, test::kBlack)};
  };
  Document small = one_layer(lines(0.125));
  std::get<LayerInstance>(small.stack[0]).artboard_from_layer = {8, 0, 0, 8, 0, 0};
  const Picture of_small = diffused(small), of_large = diffused(one_layer(lines(1)));
  EXPECT_NEAR(of_small.layers[0].triangle_count(), of_large.layers[0].triangle_count(),
              0.02 * of_large.layers[0].triangle_count());
  for (double x = 3; x < 100; x += 9) {
    const Vec2 p{x, 90.3 - 0.8 * x};
    const auto a = test::sample(of_small.layers[0], p / 8), b = test::sample(of_large.layers[0], p);
    EXPECT_NEAR((*a)[0], (*b)[0], 1.5 / 255);
  }
}

TEST(Fields, a_field_is_gathered_among_the_curves_that_bear_it) {
  // A mask among hundreds of curves without opacity: cutting the windows at these curves would take
  // thousands of times longer than the mask itself.
  std::vector<Curve> curves;
  for (int i = 0; i < 400; ++i) {
    const Vec2 from{5.0 + i % 20 * 4.5, 4.0 + i / 20 * 4.6};
    curves.push_back(colored(straight_curve(from, from + Vec2{3, 1.7}), test::kRed, test::kBlue));
  }
  const Curve mask = with_opacity(circle_curve({50, 50}, 40), 0.2f, 0.8f);
  curves.push_back(mask);
  const Picture among = diffused(one_layer(curves));
  const Picture alone =
      diffused(one_layer({mask, colored(circle_curve({50, 50}, 400), test::kRed, test::kRed)}));
  for (double x = 3; x < 100; x += 6.1) {
    const Vec2 p{x, 0.4 * x + 25};
    EXPECT_NEAR(opacity_at(among, p), opacity_at(alone, p), 1.5 / 255);
    EXPECT_NEAR(opacity_at(among, p), length(p - Vec2{50, 50}) < 40 ? 0.8 : 0.2, 1.5 / 255);
  }
}

TEST(Fields, colours_are_interpolated_in_the_space_of_the_document) {
  Document document = one_layer({colored(circle_curve({50, 50}, 30), {0.5f, 0.2f, 0.8f}, {})});
  for (auto space : {InterpolationSpace::linear, InterpolationSpace::oklab}) {
    document.interpolation = space;
    const Picture picture = diffused(document);
    EXPECT_EQ(picture.interpolation, space);
    const auto value = test::sample(picture.layers[0], {95, 90});
    const Rgb expected = from_srgb(space, {0.5f, 0.2f, 0.8f});
    EXPECT_NEAR((*value)[0], expected.r, 1e-5);
    EXPECT_NEAR((*value)[1], expected.g, 1e-5);
    EXPECT_NEAR((*value)[2], expected.b, 1e-5);
  }
}

}  // namespace
}  // namespace sfumato
