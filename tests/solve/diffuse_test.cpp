#include "sfumato/solve/diffuse.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "sfumato/base/native/thread_pool.hpp"
#include "sfumato/solve/point_evaluator.hpp"
#include "solve/diffused.hpp"
#include "support/drawing.hpp"
#include "support/picture_sampler.hpp"
#include "support/scenes.hpp"

namespace sfumato {
namespace {

using test::circle_curve;
using test::colored;
using test::diffused;
using test::one_layer;
using test::straight_curve;

std::array<double, 3> exact_color(const Document& document, Vec2 p) {
  Context context;
  Result<PointEvaluator> evaluator = PointEvaluator::create(context, document, {});
  EXPECT_TRUE(evaluator.ok());
  std::array<float, 3> rgb{};
  std::uint8_t hit = 0;
  const Vec2 points[] = {p};
  EXPECT_TRUE(evaluator->evaluate(context, 0, points, rgb, {&hit, 1}).ok());
  return {rgb[0], rgb[1], rgb[2]};
}

void expect_color(const std::array<double, 3>& color, Rgb expected, double tolerance) {
  EXPECT_NEAR(color[0], expected.r, tolerance);
  EXPECT_NEAR(color[1], expected.g, tolerance);
  EXPECT_NEAR(color[2], expected.b, tolerance);
}

TEST(Diffuse, closed_loop_of_one_colour_is_constant) {
  const Rgb inside{0.2f, 0.6f, 0.4f}, outside{0.9f, 0.1f, 0.3f};
  const Picture picture =
      diffused(one_layer({colored(circle_curve({50, 50}, 30), outside, inside)}));
  ASSERT_EQ(picture.layers.size(), 1u);
  for (double x = 2.25; x < 100; x += 7) {
    for (double y = 3.75; y < 100; y += 9) {
      const double r = length(Vec2{x, y} - Vec2{50, 50});
      const auto color = test::sample(picture.layers[0], {x, y});
      ASSERT_TRUE(color.has_value());
      if (std::fabs(r - 30) > 0.2) expect_color(*color, r < 30 ? inside : outside, 1e-5);
    }
  }
}

TEST(Diffuse, between_two_long_parallel_lines_weights_are_inverse_squares) {
  // W of a full line is π / (2 d²): the constant cancels in the mean of the two.
  const Document document =
      one_layer({colored(straight_curve({-1e5, 20}, {1e5, 20}), test::kBlack, test::kWhite),
                 colored(straight_curve({-1e5, 80}, {1e5, 80}), test::kRed, test::kBlue)});
  for (double y : {25.0, 40.0, 50.0, 60.0, 77.0}) {
    const double w1 = 1 / ((y - 20) * (y - 20)), w2 = 1 / ((80 - y) * (80 - y));
    const auto color = exact_color(document, {50.3, y});
    // The right of a line to the right is below it on the screen; the left of the other is above
    // it.
    EXPECT_NEAR(color[0], 1, 1e-5);
    EXPECT_NEAR(color[1], w1 / (w1 + w2), 1e-4);
    EXPECT_NEAR(color[2], w1 / (w1 + w2), 1e-4);
  }
}

Document two_curves(const Affine& artboard_from_drawing) {
  const bool mirrored = artboard_from_drawing.determinant() < 0;
  Document document = one_layer({Curve{.control_points = {{10, 80}, {30, 10}, {60, 20}, {80, 70}}},
                                 circle_curve({40, 60}, 8)});
  std::vector<Curve>& curves = document.layers[0].curves;
  curves[0] =
      colored(curves[0], mirrored ? test::kBlue : test::kRed, mirrored ? test::kRed : test::kBlue);
  curves[1] = colored(curves[1], mirrored ? test::kBlack : test::kGreen,
                      mirrored ? test::kGreen : test::kBlack);
  for (Curve& curve : curves) {
    for (Vec2& p : curve.control_points) p = artboard_from_drawing(p);
  }
  return document;
}

class Moved : public testing::TestWithParam<Affine> {};

TEST_P(Moved, a_moved_scene_has_the_same_colours_at_the_moved_points) {
  const Document plain = two_curves({}), moved = two_curves(GetParam());
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(15, 75);
  for (int i = 0; i < 40; ++i) {
    const Vec2 p{coordinate(random), coordinate(random)};
    const auto expected = exact_color(plain, p), color = exact_color(moved, GetParam()(p));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(color[c], expected[c], 2e-3);
  }
}

INSTANTIATE_TEST_SUITE_P(Diffuse, Moved,
                         testing::Values(Affine{-1, 0, 0, 1, 100, 0},  // mirrored: sides swapped
                                         Affine{0, 1, -1, 0, 100, 0},  // a quarter turn
                                         Affine{0.8, 0.6, -0.6, 0.8, 30, -12},
                                         Affine{1, 0, 0, 1, 3.5, -2.25}));

TEST(Diffuse, patches_miss_the_exact_colour_by_no_more_than_asked_away_from_ends) {
  const Document document = two_curves({});
  Context context;
  Result<PointEvaluator> evaluator = PointEvaluator::create(context, document, {});
  ASSERT_TRUE(evaluator.ok());
  const auto misses = [&](double max_error) {
    const Picture picture = diffused(document, {.max_error = max_error});
    std::mt19937 random(11);
    std::uniform_real_distribution<double> coordinate(1, 99);
    std::vector<double> sorted;
    for (int i = 0; i < 1500; ++i) {
      const Vec2 p{coordinate(random), coordinate(random)};
      if (length(p - Vec2{10, 80}) < 4 || length(p - Vec2{80, 70}) < 4) continue;
      float rgb[3];
      std::uint8_t hit;
      EXPECT_TRUE(evaluator->evaluate(context, 0, {&p, 1}, rgb, {&hit, 1}).ok());
      const auto color = test::sample(picture.layers[0], p);
      for (int c = 0; c < 3; ++c) sorted.push_back(255 * std::fabs((*color)[c] - rgb[c]));
    }
    std::sort(sorted.begin(), sorted.end());
    return sorted;
  };
  const auto percentile_99 = [](const std::vector<double>& sorted) {
    return sorted[sorted.size() * 99 / 100];
  };
  const auto off = misses(0), one = misses(1), quarter = misses(0.25);
  EXPECT_LE(percentile_99(one), 1);
  EXPECT_LE(percentile_99(quarter), 0.25);
  EXPECT_LT(one.back(), off.back());
}

TEST(Diffuse, around_a_free_end_the_colours_turn_from_one_side_to_the_other) {
  const Picture picture = diffused(
      one_layer({colored(straight_curve({50, 50}, {120, 50}), test::kWhite, test::kBlack)}),
      {.max_error = 0});
  const PatchLayer& layer = picture.layers[0];
  // The left of a line to the right is above it on the screen: white above, black below.
  int triangles_at_end = 0;
  for (std::uint32_t t = 0; t < layer.triangle_count(); ++t) {
    for (int k = 0; k < 3; ++k) {
      if (!(layer.vertex_position[layer.triangle_vertex[3 * t + k]] == Vec2{50, 50})) continue;
      ++triangles_at_end;
      Vec2 middle;
      for (int j = 0; j < 3; ++j) {
        middle = middle + layer.vertex_position[layer.triangle_vertex[3 * t + j]] / 3;
      }
      // From the upper side of the curve (angle 0, white) around to the lower (2π, black).
      double angle = std::atan2(-(middle.y - 50), middle.x - 50);
      if (angle < 0) angle += 2 * 3.14159265358979;
      const float value =
          layer.color.node_value[3 * std::size_t{layer.color.triangle_node[node_slot(t, k)]}];
      EXPECT_NEAR(value, 1 - angle / (2 * 3.14159265358979), 1e-5);
    }
  }
  EXPECT_GE(triangles_at_end, 4);
}

TEST(Diffuse, a_region_that_sees_no_curve_has_no_triangles) {
  Curve circle = circle_curve({50, 50}, 30);
  circle.left.color = test::one_color(test::kRed);  // outside only; the inside is open
  circle.right.color.kind = ShaderKind::barrier;
  const Picture picture = diffused(one_layer({circle}));
  EXPECT_TRUE(test::sample(picture.layers[0], {5, 5}).has_value());
  EXPECT_FALSE(test::sample(picture.layers[0], {50, 50}).has_value());
}

TEST(Diffuse, at_the_border_of_what_sees_a_curve_no_dark_fringe_appears) {
  Curve line = straight_curve({20, 50.3}, {80, 50.3});
  line.left.color = test::one_color(test::kRed);
  line.right.color.kind = ShaderKind::barrier;  // below it, no curve is visible
  const PatchLayer layer = diffused(one_layer({line})).layers[0];
  EXPECT_TRUE(test::sample(layer, {10, 40}).has_value());
  EXPECT_FALSE(test::sample(layer, {10, 60}).has_value());
  for (std::uint32_t node : layer.color.triangle_node) {
    EXPECT_NEAR(layer.color.node_value[3 * std::size_t{node}], 1, 1e-5);
  }
}

TEST(Diffuse, rays_pass_through_an_open_side) {
  Curve open = straight_curve({50, 10}, {50, 90});  // without any attribute
  const Document with =
      one_layer({colored(circle_curve({50, 50}, 40), test::kBlue, test::kRed), open});
  const auto color = test::sample(diffused(with).layers[0], {45, 50});
  ASSERT_TRUE(color.has_value());
  expect_color(*color, test::kRed, 1e-5);
}

TEST(Diffuse, an_empty_document_is_an_empty_picture) {
  const Picture picture = diffused(one_layer({}));
  ASSERT_EQ(picture.layers.size(), 1u);
  EXPECT_EQ(picture.layers[0].triangle_count(), 0u);
}

TEST(Diffuse, a_viewport_is_all_that_is_meshed) {
  const Document document = two_curves({});
  DiffuseStats whole, part;
  diffused(document, {.max_error = 0}, &whole);
  const Picture picture =
      diffused(document, {.viewport = Box{{40, 40}, {50, 50}}, .max_error = 0}, &part);
  EXPECT_LT(part.triangles, whole.triangles / 2);
  EXPECT_TRUE(test::sample(picture.layers[0], {40.01, 49.99}).has_value());
  EXPECT_FALSE(test::sample(picture.layers[0], {20, 20}).has_value());
}

TEST(Diffuse, an_artboard_thinner_than_a_pixel_is_no_finer_mesh) {
  const Curve curve = colored(straight_curve({100, 0}, {900, 1e-7}), test::kRed, test::kGreen);
  const Picture picture = diffused(one_layer({curve}, {{0, 0}, {1000, 1e-6}}));
  ASSERT_EQ(picture.layers.size(), 1u);
  EXPECT_GT(picture.layers[0].triangle_count(), 0u);
  EXPECT_LT(picture.layers[0].triangle_count(), 10'000u);
}

TEST(Diffuse, the_same_bits_for_any_number_of_threads_and_any_instruction_set) {
  const Document document = two_curves({});
  const Picture expected = diffused(document);
  for (int threads : {1, 2, 3, 8}) {
    for (SimdLevel level : {SimdLevel::sse2, SimdLevel::avx2, SimdLevel::avx512}) {
      if (level > detected_simd_level()) continue;
      ThreadPool pool(threads);
      Context context;
      context.executor = &pool;
      context.simd = level;
      Result<Picture> picture = diffuse(context, document, {});
      ASSERT_TRUE(picture.ok());
      EXPECT_EQ(picture->layers[0].color.node_value, expected.layers[0].color.node_value);
      EXPECT_EQ(picture->layers[0].triangle_vertex, expected.layers[0].triangle_vertex);
    }
  }
}

TEST(Diffuse, options_out_of_range_are_refused) {
  const Document document = two_curves({});
  Context context;
  const auto code = [&](const DiffuseOptions& options) {
    return diffuse(context, document, options).status().code;
  };
  EXPECT_EQ(code({.pixels_per_unit = 0}), StatusCode::bad_input);
  EXPECT_EQ(code({.tolerance = -1}), StatusCode::bad_input);
  EXPECT_EQ(code({.min_angle_deg = 60}), StatusCode::bad_input);
  EXPECT_EQ(code({.max_area_fraction = 0}), StatusCode::bad_input);
  EXPECT_EQ(code({.max_error = std::nan("")}), StatusCode::bad_input);
  EXPECT_EQ(code({.viewport = Box{{5, 5}, {5, 9}}}), StatusCode::bad_input);
}

/// Records the largest charge at any report of a computation.
class MostCharged final : public Progress {
 public:
  explicit MostCharged(const Budget& budget) : budget_(budget) {}
  void report(std::string_view, double) override { bytes_ = std::max(bytes_, budget_.used()); }
  std::size_t bytes() const { return bytes_; }

 private:
  const Budget& budget_;
  std::size_t bytes_ = 0;
};

TEST(Diffuse, patches_are_charged_as_long_as_they_are_held) {
  const std::vector<Curve> curves{colored(circle_curve({50, 50}, 30), test::kRed, test::kGreen),
                                  colored(straight_curve({5, 5}, {60, 90}), {}, test::kBlue)};
  Document document = one_layer(curves);
  for (std::uint32_t i = 1; i < 4; ++i) {
    document.layers.push_back({"", curves});
    document.stack.push_back(LayerInstance{i, {}});
  }
  Context context;
  MostCharged most(context.budget);
  context.progress = &most;
  const Result<Picture> picture = diffuse(context, document, {});
  ASSERT_TRUE(picture.ok()) << picture.status().message;
  std::size_t held = 0;
  for (const PatchLayer& layer : picture->layers) {
    held += 4 * (layer.color.node_value.size() + layer.color.triangle_node.size());
  }
  EXPECT_GT(most.bytes(), held);
  EXPECT_EQ(context.budget.used(), 0u);
}

TEST(Diffuse, a_budget_that_is_too_small_is_a_limit) {
  Context context{.budget = Budget(10'000)};
  EXPECT_EQ(diffuse(context, two_curves({}), {}).status().code, StatusCode::limit);
  EXPECT_EQ(context.budget.used(), 0u);
}

TEST(Diffuse, a_cancelled_context_gives_no_picture) {
  Context context;
  context.cancel = true;
  EXPECT_EQ(diffuse(context, two_curves({}), {}).status().code, StatusCode::cancelled);
}

TEST(Diffuse, a_layer_that_is_shrunk_to_nothing_is_a_limit_that_names_it) {
  for (const Affine& map : {Affine{1e-7, 0, 0, 1e-7, 0, 0}, Affine{1, 0, 0, 1e-6, 0, 0}}) {
    Document document = two_curves({});
    document.layers[0].id = "far";
    std::get<LayerInstance>(document.stack[0]).artboard_from_layer = map;
    Context context;
    const Status status = diffuse(context, document, {}).status();
    EXPECT_EQ(status.code, StatusCode::limit);
    EXPECT_NE(status.message.find("\"far\""), std::string::npos) << status.message;
  }
}

TEST(Diffuse, at_the_papers_density_the_lady_bug_has_the_papers_size) {
  const std::optional<Document> document = test::shared_scene("lady_bug.xml");
  if (!document) GTEST_SKIP() << "the shared scenes are not here";
  DiffuseStats stats;
  diffused(*document, {.tolerance = 0.1, .max_error = 0}, &stats);
  EXPECT_GT(stats.triangles, 7000u);
  EXPECT_LT(stats.triangles, 10'500u);
  EXPECT_GT(stats.nodes, 28'000u);
  EXPECT_LT(stats.nodes, 42'000u);
}

}  // namespace
}  // namespace sfumato
