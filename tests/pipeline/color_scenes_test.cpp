#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>

#include "sfumato/solve/solution.hpp"
#include "support/same_picture.hpp"
#include "support/sanitizers.hpp"
#include "support/scenes.hpp"

/// Scenes of the literature whose stops get other colours.
namespace sfumato {
namespace {

class ColorScenes : public testing::TestWithParam<const char*> {};

/// The paper's mesh is the same for all colours of sharp curves.
const DiffuseOptions kPaper{.max_error = 0};

TEST_P(ColorScenes, show_the_colours_that_a_solution_has) {
  std::optional<Document> scene = test::shared_scene(GetParam());
  if (!scene) GTEST_SKIP() << "no public scene " << GetParam();
  if (SFUMATO_HAS_SANITIZER) GTEST_SKIP() << "minutes under sanitizers";
  Context context;
  Result<Solution> solution = Solution::create(context, std::move(*scene));
  ASSERT_TRUE(solution.ok());
  solution->expect_drags();
  ASSERT_TRUE(solution->solve(context, kPaper).ok());
  const auto count = static_cast<std::uint32_t>(solution->document().layers[0].curves.size());
  for (std::uint32_t i = 0; i < 3; ++i) {
    const StopPlace place{0, (2 * i + 1) * count / 6, CurveSide::right, StopAttribute::color, 0};
    SCOPED_TRACE("curve " + std::to_string(place.curve));
    ASSERT_TRUE(solution->begin_color(context, place).ok());
    ASSERT_TRUE(solution->color(context, Rgb{0.9f, 0.1f, 0.4f}).ok());
    const PatchLayer shown = solution->picture().layers[0];
    ASSERT_TRUE(solution->solve(context, kPaper).ok());
    const PatchLayer& solved = solution->picture().layers[0];
    if (shown.triangle_vertex != solved.triangle_vertex) continue;  // a blurred curve
    EXPECT_LT(255 * test::largest_difference(shown.color, solved.color), 0.5);
  }
}

INSTANTIATE_TEST_SUITE_P(Public, ColorScenes,
                         testing::Values("lady_bug.xml", "dolphin.xml", "roses.xml"));

}  // namespace
}  // namespace sfumato
