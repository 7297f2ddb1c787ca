#include "sfumato/solve/point_evaluator.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "sfumato/document/build.hpp"

namespace sfumato {
namespace {

/// Returns a square of one colour, with nothing outside it, and a layer that no instance shows.
Document square() {
  Document document;
  document.artboard = {{0, 0}, {10, 10}};
  Curve curve = polyline({{2, 2}, {8, 2}, {8, 8}, {2, 8}, {2, 2}});
  curve.right = sfumato::colored({rgb(0x336699)});
  curve.left.color.kind = ShaderKind::barrier;
  add_layer(document, {curve});
  document.layers.push_back({"hidden", {curve}});
  return document;
}

class Evaluates : public testing::Test {
 protected:
  Evaluates() : evaluator_(PointEvaluator::create(context_, square(), {})) {}

  StatusCode code_of(std::uint32_t layer, const std::vector<Vec2>& points, std::size_t colors,
                     std::size_t hits, std::size_t opacities = 0) {
    std::vector<float> color(colors), opacity(opacities);
    std::vector<std::uint8_t> hit(hits);
    return evaluator_->evaluate(context_, layer, points, color, hit, opacity).code;
  }

  Context context_;
  Result<PointEvaluator> evaluator_;
};

TEST_F(Evaluates, the_colour_at_points_and_whether_there_is_one) {
  const std::vector<Vec2> points{{5, 5}, {1, 1}};
  std::vector<float> color(6);
  std::vector<std::uint8_t> hit(2);
  ASSERT_TRUE(evaluator_->evaluate(context_, 0, points, color, hit).ok());
  EXPECT_NEAR(color[0], 0.2, 1e-6);
  EXPECT_NEAR(color[1], 0.4, 1e-6);
  EXPECT_NEAR(color[2], 0.6, 1e-6);
  EXPECT_EQ(hit[0], 1);
  EXPECT_EQ(hit[1], 0);
}

TEST_F(Evaluates, nothing_for_a_layer_that_is_not_there_or_not_shown) {
  EXPECT_EQ(evaluator_->color_channels(0), 3);
  for (const std::uint32_t layer : {1u, 2u, 0xffffffffu}) {
    EXPECT_EQ(evaluator_->color_channels(layer), 0);
    EXPECT_EQ(evaluator_->opacity_channels(layer), 0);
    EXPECT_TRUE(evaluator_->color_shaders(layer).empty());
    EXPECT_EQ(code_of(layer, {{5, 5}}, 3, 1), StatusCode::bad_input);
  }
}

TEST_F(Evaluates, only_tables_of_the_points_size) {
  EXPECT_EQ(code_of(0, {{5, 5}}, 3, 1), StatusCode::ok);
  EXPECT_EQ(code_of(0, {{5, 5}}, 2, 1), StatusCode::bad_input);
  EXPECT_EQ(code_of(0, {{5, 5}}, 4, 1), StatusCode::bad_input);
  EXPECT_EQ(code_of(0, {{5, 5}}, 3, 0), StatusCode::bad_input);
  EXPECT_EQ(code_of(0, {{5, 5}}, 3, 1, 1), StatusCode::bad_input);
  EXPECT_EQ(code_of(0, {}, 0, 0), StatusCode::ok);
}

TEST_F(Evaluates, only_points_inside) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double far = std::numeric_limits<double>::infinity();
  for (const Vec2 point : {Vec2{-1, 5}, Vec2{5, 10.5}, Vec2{nan, 5}, Vec2{5, nan}, Vec2{far, 5}}) {
    EXPECT_EQ(code_of(0, {{5, 5}, point}, 6, 2), StatusCode::bad_input)
        << point.x << ' ' << point.y;
  }
  EXPECT_EQ(code_of(0, {{0, 0}, {10, 10}}, 6, 2), StatusCode::ok);
}

TEST_F(Evaluates, as_before_after_a_move) {
  PointEvaluator moved(std::move(*evaluator_));
  EXPECT_EQ(evaluator_->color_channels(0), 0);
  EXPECT_EQ(code_of(0, {{5, 5}}, 3, 1), StatusCode::bad_input);
  *evaluator_ = std::move(moved);
  EXPECT_EQ(code_of(0, {{5, 5}}, 3, 1), StatusCode::ok);
}

}  // namespace
}  // namespace sfumato
