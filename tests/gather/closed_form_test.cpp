#include "gather/kernels/closed_form.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "gather/gather_reference.hpp"
#include "gather/reference_weights.hpp"
#include "gather/scenes.hpp"

namespace sfumato::gather::test {
namespace {

struct Part {
  Vec2 q1, q2;
};

/// Returns visible parts of every angle, size and distance, seen from the origin counter-clockwise.
std::vector<Part> parts(double least_angle, double greatest_angle, double greatest_ratio) {
  std::mt19937 random(3);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
  std::vector<Part> result;
  for (int i = 0; i < 2000; ++i) {
    const double start = 2 * std::numbers::pi * uniform();
    const double ratio = greatest_angle / least_angle;
    const double angle = least_angle * std::pow(ratio, uniform());
    const double r1 = std::pow(10, 4 * uniform() - 2);
    const double r2 = r1 * std::pow(greatest_ratio, 2 * uniform() - 1);
    result.push_back({{r1 * std::cos(start), r1 * std::sin(start)},
                      {r2 * std::cos(start + angle), r2 * std::sin(start + angle)}});
  }
  return result;
}

/// Returns ∫ r⁻² (1 - l) dθ and ∫ r⁻² l dθ by Simpson's rule, l the fraction from q1 to q2.
ReferenceWeights simpson(const Part& part) {
  const double start = std::atan2(part.q1.y, part.q1.x);
  const double angle = std::atan2(cross(part.q1, part.q2), dot(part.q1, part.q2));
  const Vec2 e = part.q2 - part.q1;
  constexpr int kSteps = 20000;
  ReferenceWeights sum;
  for (int i = 0; i <= kSteps; ++i) {
    const double theta = start + angle * i / kSteps;
    const Vec2 d{std::cos(theta), std::sin(theta)};
    const double l = cross(part.q1, d) / -cross(e, d);
    const double rate = 1 / length_squared(part.q1 + l * e);
    const double factor = (i == 0 || i == kSteps ? 1 : i % 2 ? 4 : 2) * angle / kSteps / 3;
    sum.right += factor * rate * (1 - l);
    sum.left += factor * rate * l;
  }
  return sum;
}

PartWeight<Lanes<1>> single_precision(const Part& part) {
  const float x1 = static_cast<float>(part.q1.x), y1 = static_cast<float>(part.q1.y);
  const float x2 = static_cast<float>(part.q2.x), y2 = static_cast<float>(part.q2.y);
  const auto cross_q = static_cast<float>(cross(Vec2{x1, y1}, Vec2{x2, y2}));
  const auto length_squared = static_cast<float>(sfumato::length_squared(part.q2 - part.q1));
  return part_weight<Lanes<1>>(x1, y1, x2, y2, cross_q, length_squared, LaneMask<1>::from_bits(1));
}

Part rounded(const Part& part) {
  const auto round = [](Vec2 q) {
    return Vec2{double{static_cast<float>(q.x)}, double{static_cast<float>(q.y)}};
  };
  return {round(part.q1), round(part.q2)};
}

TEST(ClosedForm, reference_weights_are_simpsons_integral) {
  const std::vector<Part> all = parts(1e-3, 3.0, 3);
  for (std::size_t i = 0; i < all.size(); i += 20) {
    const ReferenceWeights expected = simpson(all[i]);
    const ReferenceWeights weights = reference_weights(all[i].q1, all[i].q2);
    EXPECT_NEAR(weights.right / expected.right, 1, 1e-9);
    EXPECT_NEAR(weights.left / expected.left, 1, 1e-9);
  }
}

void expect_close_to_reference(const std::vector<Part>& all, double tolerance) {
  for (const Part& exact : all) {
    const Part part = rounded(exact);
    const ReferenceWeights expected = reference_weights(part.q1, part.q2);
    const double weight = expected.right + expected.left;
    const PartWeight<Lanes<1>> got = single_precision(part);
    EXPECT_NEAR(got.weight[0] / weight, 1, tolerance);
    EXPECT_NEAR(got.lean[0] / weight, (expected.left - expected.right) / weight, tolerance);
  }
}

TEST(ClosedForm, single_precision_is_the_reference_below_a_right_angle) {
  expect_close_to_reference(parts(1e-3, std::numbers::pi / 2, 10), 6e-6);
}

TEST(ClosedForm, single_precision_is_the_reference_above_a_right_angle) {
  expect_close_to_reference(parts(std::numbers::pi / 2, 2.8, 10), 2e-5);
}

TEST(ClosedForm, small_parts_lose_nothing) {
  expect_close_to_reference(parts(1e-6, 1e-3, 1.0001), 3e-6);
}

TEST(ClosedForm, a_point_on_the_segment_takes_the_weights_of_linear_interpolation) {
  const PartWeight<Lanes<1>> got = single_precision({{-1, 0}, {3, 0}});
  EXPECT_NEAR(got.lean[0] / got.weight[0], 2 * 0.25 - 1, 1e-5);
}

TEST(ClosedForm, an_edge_on_part_weighs_nothing) {
  const PartWeight<Lanes<1>> got = single_precision({{1, 0}, {3, 0}});
  EXPECT_EQ(got.weight[0], 0);
  EXPECT_EQ(got.lean[0], 0);
}

TEST(ClosedForm, a_point_on_an_end_gets_finite_weights) {
  for (const Part& part : {Part{{0, 0}, {3, 0}}, Part{{0, 3}, {0, 0}}, Part{{0, 0}, {1e7, 1e7}},
                           Part{{-1e-20, 0}, {1e7, 1e-20}}}) {
    const PartWeight<Lanes<1>> got = single_precision(part);
    EXPECT_TRUE(std::isfinite(got.weight[0]));
    EXPECT_TRUE(std::isfinite(got.lean[0]));
  }
}

TEST(ClosedForm, a_full_line_weighs_half_pi_over_the_squared_distance) {
  const Drawing drawing =
      draw({plain_line({{-4000, 0}, {4000, 0}}, {1, 0, 0})}, {{-4096, -4096}, {4096, 4096}});
  for (double d : {0.5, 1.0, 4.0}) {
    const Vec2 p{0.25, d};
    const std::int32_t triangle = find_triangle(drawing.mesh, p);
    ASSERT_NE(triangle, mesh::kNone);
    const double weight =
        gather_reference(drawing.mesh, drawing.attributes, p, static_cast<std::uint32_t>(triangle))
            .weight;
    EXPECT_NEAR(weight * d * d, std::numbers::pi / 2, 1e-8);
  }
}

TEST(ClosedForm, between_two_parallel_lines_colours_mix_by_inverse_squares) {
  const Drawing drawing = draw({plain_line({{-4000, 0}, {4000, 0}}, {1, 0, 0}),
                                plain_line({{-4000, 8}, {4000, 8}}, {0, 1, 0})},
                               {{-4096, -4096}, {4096, 4096}});
  Context context;
  const std::vector<Vec2> points{{0, 1}, {3, 2}, {-5, 4}, {7, 7.5}};
  const Gathered gathered = gather_at(context, drawing, points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double near = 1 / (points[i].y * points[i].y);
    const double far = 1 / ((8 - points[i].y) * (8 - points[i].y));
    EXPECT_NEAR(gathered.value[3 * i], near / (near + far), 1e-6);
    EXPECT_NEAR(gathered.value[3 * i + 1], far / (near + far), 1e-6);
    EXPECT_EQ(gathered.value[3 * i + 2], 0);
    EXPECT_EQ(gathered.hit[i], 1);
  }
}

TEST(ClosedForm, a_loop_of_one_colour_is_constant) {
  Line loop = plain_line({}, {});
  for (int i = 0; i <= 40; ++i) {
    const double angle = 2 * std::numbers::pi * (i % 40) / 40;
    const double radius = i % 3 == 1 && i != 40 ? 120 : 200;
    loop.points.push_back(
        {std::round(256 + radius * std::cos(angle)), std::round(256 + radius * std::sin(angle))});
  }
  loop.left.assign(loop.points.size(), {0.25f, 0.5f, 0.75f});
  loop.right.assign(loop.points.size(), {0.75f, 0.5f, 0.25f});
  const Drawing drawing = draw({loop});
  Context context;
  std::vector<Vec2> inside;
  for (const Vec2& p : random_points(drawing, 1, 3000, 0.01)) {
    if (length(p - Vec2{256, 256}) < 110) inside.push_back(p);
  }
  ASSERT_GT(inside.size(), 200u);
  const Gathered gathered = gather_at(context, drawing, inside);
  // The polyline runs clockwise on the screen, so its inside is on the right.
  for (std::size_t i = 0; i < inside.size(); ++i) {
    EXPECT_NEAR(gathered.value[3 * i], 0.75, 1e-6);
    EXPECT_NEAR(gathered.value[3 * i + 1], 0.5, 1e-6);
    EXPECT_NEAR(gathered.value[3 * i + 2], 0.25, 1e-6);
  }
}

}  // namespace
}  // namespace sfumato::gather::test
