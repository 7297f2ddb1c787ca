#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <utility>

#include "sfumato/solve/solution.hpp"
#include "solve/diffused.hpp"
#include "solve/mean_difference.hpp"
#include "support/same_picture.hpp"
#include "support/sanitizers.hpp"
#include "support/scenes.hpp"

/// The scenes of the literature while two of their curves move.
namespace sfumato {
namespace {

class RoughScenes : public testing::TestWithParam<const char*> {};

TEST_P(RoughScenes, are_near_the_exact_ones) {
  std::optional<Document> scene = test::shared_scene(GetParam());
  if (!scene) GTEST_SKIP() << "no public scene " << GetParam();
  if (SFUMATO_HAS_SANITIZER) GTEST_SKIP() << "minutes under sanitizers";
  Context context;
  Result<Solution> solution = Solution::create(context, std::move(*scene));
  ASSERT_TRUE(solution.ok());
  ASSERT_TRUE(solution->solve(context, {}).ok());
  const auto count = static_cast<std::uint32_t>(solution->document().layers[0].curves.size());
  for (const std::uint32_t curve : {count / 3, 2 * count / 3}) {
    Curve moved = solution->document().layers[0].curves[curve];
    for (Vec2& p : moved.control_points) p = p + Vec2{3, -2};
    ASSERT_TRUE(solution->apply(context, ReplaceCurve{0, curve, std::move(moved)}).ok());
  }
  ASSERT_TRUE(solution->solve_roughly(context, {}).ok());
  const Picture exact = test::diffused(solution->document());
  EXPECT_LT(test::mean_difference(solution->picture(), exact, 512), 0.5);
  EXPECT_LT(2 * solution->picture().layers[0].triangle_count(), exact.layers[0].triangle_count());
  ASSERT_TRUE(solution->solve(context, {}).ok());
  EXPECT_EQ(test::difference_of(solution->picture(), exact), "");
}

INSTANTIATE_TEST_SUITE_P(Public, RoughScenes, testing::Values("lady_bug.xml", "dolphin.xml"));

}  // namespace
}  // namespace sfumato
