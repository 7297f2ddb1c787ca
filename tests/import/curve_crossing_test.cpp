#include "import/curve_crossing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "import/boundary.hpp"
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

using Loop = std::vector<Vec2>;

Loop polygon(const std::vector<Vec2>& corners) {
  Loop chain{corners.front()};
  for (std::size_t i = 1; i <= corners.size(); ++i) {
    const Cubic side = segment(chain.back(), corners[i % corners.size()]);
    chain.insert(chain.end(), side.begin() + 1, side.end());
  }
  return chain;
}

Loop square_from(double left, double top = 0) {
  return polygon({{left, top}, {left + 10, top}, {left + 10, top + 10}, {left, top + 10}});
}

const Loop kEight = polygon({{0, 0}, {10, 9}, {10, 0}, {0, 10}});

TEST(BoundaryCheck, finds_loops_that_cross_or_come_too_near) {
  const Loop first = square_from(0);
  const auto count = [&](double left) {
    Context context;
    TableMemory memory("a test");
    const Loop second = square_from(left);
    const std::vector<svg_import::DrawnLoop> loops{{&first, 100}, {&second, 100}};
    const auto found = svg_import::leaking_pieces(context, loops, 0.01, {}, memory);
    EXPECT_TRUE(found);
    return found ? found->size() : 0;
  };
  EXPECT_EQ(count(10.02), 0u);
  EXPECT_GT(count(10.001), 0u);
  EXPECT_GT(count(9.001), 0u);
}

TEST(BoundaryCheck, refuses_loops_that_cross_or_are_turned) {
  Context context;
  const auto refused = [&](const std::vector<svg_import::DrawnLoop>& loops) {
    const Status status = svg_import::refuse_crossings(context, loops, 0.01, {});
    EXPECT_EQ(svg_import::is_too_intricate(status), !status.ok());
    return status.message;
  };
  const std::string crosses =
      "its outline crosses itself too closely; expected simpler curves there";
  const Loop first = square_from(0), near = square_from(10.001), across = square_from(9, 1);
  EXPECT_EQ(refused({{&first, 100}, {&near, 100}}), "");
  EXPECT_EQ(refused({{&first, 100}, {&across, 100}}), crosses);
  EXPECT_EQ(refused({{&first, 100}, {&near, -100}}), crosses);
  EXPECT_EQ(refused({{&kEight, 5}}), crosses);
}

TEST(BoundaryCheck, refuses_loops_that_share_a_straight_stretch) {
  Context context;
  const Loop first = square_from(0);
  for (const double left : {9.0, 10.0, 10.02}) {
    const Loop second = square_from(left);
    const std::vector<svg_import::DrawnLoop> loops{{&first, 100}, {&second, 100}};
    EXPECT_EQ(svg_import::refuse_crossings(context, loops, 0.01, {}).ok(), left > 10) << left;
  }
}

}  // namespace
}  // namespace sfumato
