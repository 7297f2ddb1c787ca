#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "equal/tool/scene_check.hpp"
#include "support/places.hpp"
#include "support/sanitizers.hpp"
#include "support/soak.hpp"

// Random scenes, each under four configurations (README.md): ninety; three hundred in `make soak`;
// twenty under sanitizers.
namespace sfumato::test {
namespace {

constexpr std::uint64_t kBlocks = SFUMATO_EQUAL_BLOCKS;
constexpr std::uint64_t kScenesPerBlock = 10;
/// Three seeds in a row use all pairs of threads and instruction sets. Sanitizers have few blocks.
constexpr std::uint64_t kQuickScenes = SFUMATO_HAS_SANITIZER ? 10 : 3;

/// A block of seeds is one test, so that blocks run in parallel.
class EqualScenes : public testing::TestWithParam<std::uint64_t> {};

TEST_P(EqualScenes, have_the_same_bits_under_every_configuration) {
  SceneChecker checker;
  const std::uint64_t first = 1 + GetParam() * kScenesPerBlock;
  const std::uint64_t count = random_case_count(kQuickScenes, kScenesPerBlock);
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    const SceneCheck check = checker.check(random_scene(seed), configurations_of(seed));
    EXPECT_EQ(check.complaint, "");
  }
}

INSTANTIATE_TEST_SUITE_P(Blocks, EqualScenes, testing::Range(std::uint64_t{0}, kBlocks));

TEST(EqualConfigurations, have_all_pairs_of_threads_and_instruction_sets_in_three_seeds) {
  std::set<std::string> pairs;
  for (std::uint64_t seed : {7, 8, 9}) {
    std::set<int> threads;
    std::set<SimdLevel> levels;
    for (const Configuration& configuration : configurations_of(seed)) {
      threads.insert(configuration.threads);
      levels.insert(configuration.simd);
      pairs.insert(to_string(configuration));
    }
    EXPECT_EQ(threads, (std::set<int>{1, 2, 3, 8}));
    EXPECT_EQ(levels.size(), simd_levels().size());
  }
  EXPECT_EQ(pairs.size(), 4 * simd_levels().size());
  EXPECT_EQ(all_configurations().size(), pairs.size());
}

TEST(EqualConfigurations, are_read_as_they_are_written) {
  for (const Configuration& configuration : all_configurations()) {
    EXPECT_EQ(parse_configuration(to_string(configuration)), configuration);
  }
  for (const char* text : {"", "3", "3/", "/sse2", "0/sse2", "-1/sse2", "3/sse", "3/sse2 ",
                           "3 /sse2", "99999999999/sse2", "9999/sse2"}) {
    EXPECT_FALSE(parse_configuration(text)) << text;
  }
}

/// The tests of the scenes would be useless if the scenes were equal, or were not drawn.
TEST(EqualScenesThemselves, differ_and_are_drawn) {
  SceneChecker checker;
  std::set<std::uint64_t> pixels;
  std::set<std::string> stages;
  const auto kSeeds = random_case_count<std::uint64_t>(20, 60);
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    Scene scene = random_scene(seed);
    scene.with_outputs = seed == 1;
    for (const StageHash& stage : checker.digest(scene, {})) {
      stages.insert(stage.stage);
      if (stage.stage == "pixels") pixels.insert(stage.hash);
    }
  }
  EXPECT_GE(pixels.size(), kSeeds - 2);
  for (const char* stage : {"document", "mesh", "nodes", "pixels", "png", "gathered", "html", "pdf",
                            "eps", "svg", "glb", "grid"}) {
    EXPECT_TRUE(stages.contains(stage)) << stage;
  }
}

/// Returns one thread and one of the other numbers in turn; in `make soak` all four numbers.
std::vector<Configuration> configurations_of_file(std::uint64_t seed) {
  const std::vector<Configuration> all = configurations_of(seed);
  if (is_soak()) return all;
  return {all.front(), all[1 + seed % (all.size() - 1)]};
}

/// The public scenes and the examples; together they use every configuration.
TEST(EqualFiles, have_the_same_bits_under_every_configuration) {
  SceneChecker checker;
  int count = 0;
  for (const std::string& folder : {source_path("examples"), shared_path("scenes")}) {
    if (!std::filesystem::is_directory(folder)) continue;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".svg" && extension != ".xml") continue;
      const Result<Scene> scene = file_scene(entry.path().string());
      ASSERT_TRUE(scene.ok()) << to_string(scene.status());
      const auto seed = static_cast<std::uint64_t>(count++);
      EXPECT_EQ(checker.check(*scene, configurations_of_file(seed)).complaint, "");
    }
  }
  EXPECT_GE(count, 8);
}

}  // namespace
}  // namespace sfumato::test
