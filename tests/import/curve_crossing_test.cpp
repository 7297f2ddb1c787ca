#include "import/curve_crossing.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "import/boundary_check.hpp"

namespace sfumato {
namespace {

using curves::Cubic;
using svg_import::CurveCrossing;

Cubic segment(Vec2 from, Vec2 to) {
  return {from, lerp(from, to, 1.0 / 3), lerp(from, to, 2.0 / 3), to};
}

TEST(CurveCrossing, of_lines_and_arcs) {
  CurveCrossing crossing(1e-6, 1e-6);
  const Cubic arc{Vec2{0, 0}, {0, 10}, {20, 10}, {20, 0}};
  EXPECT_TRUE(crossing.of(arc, segment({5, 0}, {5, 20})));
  EXPECT_NEAR(crossing.place().x, 5, 0.1);
  EXPECT_TRUE(crossing.of(segment({-5, 7}, {25, 7}), arc));
  EXPECT_FALSE(crossing.of(arc, segment({-5, 7.6}, {25, 7.6})));
  EXPECT_FALSE(crossing.of(arc, segment({5, 0}, {5, 3})));
}

TEST(CurveCrossing, not_of_curves_that_touch) {
  CurveCrossing crossing(1e-6, 1e-6);
  EXPECT_FALSE(crossing.of(segment({0, 0}, {10, 0}), segment({5, 0}, {5, 10})));
  EXPECT_FALSE(crossing.of(segment({0, 0}, {10, 0}), segment({10, 0}, {5, 10})));
}

/// Chords of these do not cross: at the tip, each handle lies on the wrong side of the other.
TEST(CurveCrossing, beside_a_sharp_tip) {
  CurveCrossing crossing(1e-6, 1e-6);
  const Vec2 tip{0, 0};
  const auto leaf = [&](double handle) {
    const Cubic there{tip, {10, -handle}, {30, 4}, {40, 0}};
    const Cubic back{Vec2{40, 0}, {30, -4}, {10, handle}, tip};
    return crossing.beyond_joint(back, there);
  };
  EXPECT_FALSE(leaf(-1));
  EXPECT_TRUE(leaf(1));
}

TEST(BoundaryCheck, finds_loops_that_cross_or_come_too_near) {
  const auto square = [](double left, double right) {
    std::vector<Vec2> chain{{left, 0}};
    for (const Vec2 to : {Vec2{right, 0}, Vec2{right, 10}, Vec2{left, 10}, Vec2{left, 0}}) {
      const Cubic side = segment(chain.back(), to);
      chain.insert(chain.end(), side.begin() + 1, side.end());
    }
    return chain;
  };
  const std::vector<Vec2> first = square(0, 10);
  const auto count = [&](double left) {
    Context context;
    TableMemory memory("a test");
    const std::vector<Vec2> second = square(left, left + 10);
    const std::vector<const std::vector<Vec2>*> loops{&first, &second};
    const auto found = svg_import::leaking_pieces(context, loops, 0.01, {}, memory);
    EXPECT_TRUE(found);
    return found ? found->size() : 0;
  };
  EXPECT_EQ(count(10.02), 0u);
  EXPECT_GT(count(10.001), 0u);
  EXPECT_GT(count(9.001), 0u);
}

}  // namespace
}  // namespace sfumato
