#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "equal/tool/difference.hpp"
#include "equal/tool/scene_check.hpp"
#include "equal/tool/scene_trace.hpp"
#include "sfumato/codecs/png.hpp"

namespace sfumato::test {
namespace {

const TraceArray* stage_of(const Trace& trace, const std::string& stage) {
  const auto found = std::ranges::find(trace, stage, &TraceArray::stage);
  return found == trace.end() ? nullptr : &*found;
}

/// The bisection examines the same computation as the hashes.
TEST(SceneTraces, end_with_what_diffuse_and_rasterize_give) {
  for (std::uint64_t seed : {2, 5, 9, 17, 31}) {
    SCOPED_TRACE(seed);
    const Scene scene = random_scene(seed);
    Context context;
    const Result<Trace> trace = trace_scene(context, scene);
    ASSERT_TRUE(trace.ok()) << to_string(trace.status());
    const Result<Picture> picture = diffuse(context, scene.document, scene.diffuse);
    ASSERT_TRUE(picture.ok());
    for (std::size_t i = 0; i < picture->layers.size(); ++i) {
      const PatchLayer& layer = picture->layers[i];
      const std::string stage = "layer " + std::to_string(i) + ", patches: ";
      const TraceArray* const vertices = stage_of(*trace, stage + "vertices");
      if (!vertices) continue;  // outside the view
      EXPECT_EQ(vertices->bytes, points("", layer.vertex_position).bytes);
      EXPECT_EQ(stage_of(*trace, stage + "color node values")->bytes,
                numbers("", layer.color.node_value, 1).bytes);
    }
    const Result<Image> image = rasterize(context, *picture, scene.raster);
    ASSERT_TRUE(image.ok());
    EXPECT_EQ(stage_of(*trace, "pixels")->bytes, image->bytes);
    EXPECT_EQ(stage_of(*trace, "png")->bytes, *encode_png(context, *image));
  }
}

TEST(SceneTraces, have_every_step_in_its_order) {
  Scene scene = random_scene(1);
  scene.by_pixels = true;
  Context context;
  const Result<Trace> trace = trace_scene(context, scene);
  ASSERT_TRUE(trace.ok());
  std::size_t place = 0;
  for (const char* stage :
       {"document, layer 0: control points", "document as SVG", "layer 0, flatten: color vertices",
        "layer 0, mesh: vertices", "layer 0, round 0: mesh vertices",
        "layer 0, round 0: color node positions", "layer 0, round 0: color node values",
        "layer 0, patches: color node values", "pixels", "png", "pixels by the gather"}) {
    const TraceArray* const found = stage_of(*trace, stage);
    ASSERT_TRUE(found) << stage;
    const auto at = static_cast<std::size_t>(found - trace->data());
    EXPECT_GE(at, place) << stage;
    place = at;
  }
}

TEST(SceneTraces, tell_where_a_computation_takes_another_way) {
  Scene scene = random_scene(3);
  scene.diffuse.max_error = 0;
  scene.diffuse.gather = {gather::Method::rays, 8, 1};
  Scene other = scene;
  other.diffuse.gather.seed = 2;
  Context context;
  const Result<Trace> a = trace_scene(context, scene), b = trace_scene(context, other);
  ASSERT_TRUE(a.ok() && b.ok());
  const auto difference = first_difference(*a, *b);
  ASSERT_TRUE(difference);
  EXPECT_EQ(difference->stage, "layer 0, round 0: color node values");
  EXPECT_TRUE(difference->position);
}

}  // namespace
}  // namespace sfumato::test
