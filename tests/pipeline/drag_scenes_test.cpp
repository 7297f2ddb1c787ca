#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "solve/session/layer_session.hpp"
#include "support/same_picture.hpp"
#include "support/sanitizers.hpp"
#include "support/scenes.hpp"

/// Scenes of the literature whose curves are dragged.
namespace sfumato::solve {
namespace {

class DragScenes : public testing::TestWithParam<const char*> {};

TEST_P(DragScenes, miss_by_less_than_a_code_value) {
  std::optional<Document> scene = test::shared_scene(GetParam());
  if (!scene) GTEST_SKIP() << "no public scene " << GetParam();
  if (SFUMATO_HAS_SANITIZER) GTEST_SKIP() << "minutes under sanitizers";
  Context context;
  const Document& document = *scene;
  DiffuseOptions options;
  options.max_error = 0;
  const LayerSight sight = sight_of_layer(document, 0, document.artboard);
  const std::vector<Curve>& curves = document.layers[0].curves;
  for (std::uint32_t i = 0; i < 6; ++i) {
    const auto curve = static_cast<std::uint32_t>(curves.size() * (2 * i + 1) / 12);
    SCOPED_TRACE("curve " + std::to_string(curve));
    std::optional<RefinedLayer> none;
    const LayerInput input = input_of(document, 0, sight, options);
    Result<LayerSession> quick = LayerSession::open(context, input, {curve}, none);
    Result<LayerSession> slow =
        LayerSession::open(context, input, {curve}, none, {.most_missed = 0});
    ASSERT_TRUE(quick.ok() && slow.ok()) << quick.status().message << slow.status().message;
    for (const double by : {5.0, -12.0}) {
      Curve moved = curves[curve];
      for (Vec2& p : moved.control_points) p = p + Vec2{by, 0.5 * by};
      const Result<std::optional<FramePatches>> about = quick->frame(context, {&moved, 1});
      const Result<std::optional<FramePatches>> exact = slow->frame(context, {&moved, 1});
      ASSERT_TRUE(about.ok() && exact.ok() && *about && *exact);
      const PatchField &quick_color = (*about)->layer.color, &slow_color = (*exact)->layer.color;
      ASSERT_EQ(quick_color.triangle_node, slow_color.triangle_node);
      EXPECT_LT(255 * test::largest_difference(quick_color, slow_color), 1);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Public, DragScenes,
                         testing::Values("lady_bug.xml", "dolphin.xml", "roses.xml"));

}  // namespace
}  // namespace sfumato::solve
