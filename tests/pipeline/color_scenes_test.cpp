#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

#include "sfumato/formats/read_document.hpp"
#include "sfumato/solve/solution.hpp"
#include "support/same_picture.hpp"
#include "support/sanitizers.hpp"

/// Stops of the scenes of the literature that get other colours.
namespace sfumato {
namespace {

class ColorScenes : public testing::TestWithParam<const char*> {};

/// The mesh of the paper is the same for all colours of sharp curves.
const DiffuseOptions kPaper{.max_error = 0};

/// Of the largest layer, in code values, between pictures with the same triangles.
float largest_difference(const PatchField& a, const PatchField& b) {
  float largest = 0;
  const auto channels = static_cast<std::size_t>(a.channel_count);
  for (std::size_t i = 0; i < a.triangle_node.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      largest = std::max(largest, std::fabs(a.node_value[channels * a.triangle_node[i] + c] -
                                            b.node_value[channels * b.triangle_node[i] + c]));
    }
  }
  return 255 * largest;
}

TEST_P(ColorScenes, show_the_colours_that_a_solution_has) {
  std::ifstream file(std::string(SFUMATO_SHARED_DIR "/scenes/") + GetParam(), std::ios::binary);
  if (!file) GTEST_SKIP() << "the shared scenes are not here: no " << GetParam();
  if (SFUMATO_HAS_SANITIZER) GTEST_SKIP() << "minutes under sanitizers";
  const std::string text(std::istreambuf_iterator<char>(file), {});
  Context context;
  Result<ReadDocument> read = read_document(context, text, GetParam());
  ASSERT_TRUE(read.ok()) << read.status().message;
  Result<Solution> solution = Solution::create(context, std::move(read->document));
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
    EXPECT_LT(largest_difference(shown.color, solved.color), 0.5);
  }
}

INSTANTIATE_TEST_SUITE_P(Public, ColorScenes,
                         testing::Values("lady_bug.xml", "dolphin.xml", "roses.xml"));

}  // namespace
}  // namespace sfumato
