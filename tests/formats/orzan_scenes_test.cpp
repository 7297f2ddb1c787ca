// The public scenes: the read documents match the format's description in the README.md beside
// them.
#include <gtest/gtest.h>

#include <algorithm>

#include "support/scenes.hpp"

namespace sfumato {
namespace {

struct SceneFacts {
  const char* file;
  std::size_t curve_count;
  double width;
  double height;
};

class PublicScene : public testing::TestWithParam<SceneFacts> {};

TEST_P(PublicScene, loads_with_all_its_curves_and_its_canvas) {
  const SceneFacts& facts = GetParam();
  const auto bytes = test::shared_scene_bytes(facts.file);
  if (!bytes) GTEST_SKIP() << "no public scene " << facts.file;
  Context context;
  const Result<ReadDocument> read = read_orzan(context, *bytes, facts.file);
  ASSERT_TRUE(read.ok()) << to_string(read.status());
  const Document& document = read->document;
  ASSERT_EQ(document.layers.size(), 1u);
  ASSERT_EQ(document.stack.size(), 1u);
  EXPECT_EQ(document.layers[0].curves.size(), facts.curve_count);
  EXPECT_EQ(document.artboard, (Box{{0, 0}, {facts.width, facts.height}}));
  EXPECT_TRUE(validate(Context{}, document).ok());
  EXPECT_EQ(context.budget.used(), 0u);
}

TEST_P(PublicScene, lies_for_the_most_part_on_its_canvas) {
  const SceneFacts& facts = GetParam();
  const auto document = test::shared_scene(facts.file);
  if (!document) GTEST_SKIP() << "no public scene " << facts.file;
  const Box near = document->artboard.grown_by(12);
  for (const Curve& curve : document->layers[0].curves) {
    EXPECT_TRUE(
        std::ranges::any_of(curve.control_points, [&](Vec2 p) { return near.contains(p); }));
  }
}

INSTANTIATE_TEST_SUITE_P(, PublicScene,
                         testing::Values(SceneFacts{"lady_bug.xml", 71, 512, 512},
                                         SceneFacts{"dolphin.xml", 1521, 946, 633},
                                         SceneFacts{"tomatos.xml", 397, 512, 512},
                                         SceneFacts{"drape.xml", 69, 512, 512},
                                         SceneFacts{"roses_spirales.xml", 20, 512, 512},
                                         SceneFacts{"glass_droplet_blur.xml", 524, 623, 623},
                                         SceneFacts{"arch.xml", 1, 512, 512},
                                         SceneFacts{"circles.xml", 2, 512, 512},
                                         SceneFacts{"endcap.xml", 2, 512, 512},
                                         SceneFacts{"usvg_ladybug.xml", 59, 1024, 1024}),
                         [](const auto& facts) {
                           std::string name = facts.param.file;
                           return name.substr(0, name.find('.'));
                         });

TEST(LadyBug, first_curve_is_turned_upright_with_its_colours_in_order) {
  const auto document = test::shared_scene("lady_bug.xml");
  if (!document) GTEST_SKIP() << "no public scene lady_bug.xml";
  const Curve& curve = document->layers[0].curves[0];
  ASSERT_EQ(curve.control_points.size(), 31u);
  EXPECT_EQ(curve.control_points[0], (Vec2{220, 114}));
  EXPECT_EQ(curve.control_points[1], (Vec2{253, 93}));
  ASSERT_EQ(curve.left.color.stops.stops.size(), 4u);
  ASSERT_EQ(curve.right.color.stops.stops.size(), 6u);
  const Stop<Rgb>& second = curve.right.color.stops.stops[1];
  EXPECT_DOUBLE_EQ(second.offset, 2.1);
  EXPECT_EQ(second.value, (Rgb{247 / 255.f, 187 / 255.f, 135 / 255.f}));
}

// The lady bug's outline runs clockwise on the screen, so the red body lies on its right.
TEST(LadyBug, red_body_is_right_of_its_outline) {
  const auto document = test::shared_scene("lady_bug.xml");
  if (!document) GTEST_SKIP() << "no public scene lady_bug.xml";
  const Curve& curve = document->layers[0].curves[0];
  double doubled_area = 0;
  for (std::size_t i = 0; i + 1 < curve.control_points.size(); ++i) {
    doubled_area += cross(curve.control_points[i], curve.control_points[i + 1]);
  }
  EXPECT_GT(doubled_area, 0);
  const Rgb body = curve.right.color.stops.stops[1].value;
  EXPECT_GT(body.r, body.b + 0.3f);
}

// The two files hold the same drawing, one at half the size, in two dialects.
TEST(LadyBug, is_the_same_in_both_dialects) {
  const auto orzan = test::shared_scene("lady_bug.xml");
  const auto scene = test::shared_scene("usvg_ladybug.xml");
  if (!orzan || !scene) GTEST_SKIP() << "no public scenes lady_bug.xml, usvg_ladybug.xml";
  const Curve& a = orzan->layers[0].curves[0];
  const Curve& b = scene->layers[0].curves[0];
  ASSERT_EQ(a.control_points.size(), b.control_points.size());
  const Vec2 shift = b.control_points[0] - a.control_points[0] * 0.5;
  for (std::size_t i = 0; i < a.control_points.size(); ++i) {
    EXPECT_LT(length(b.control_points[i] - a.control_points[i] * 0.5 - shift), 0.01);
  }
  EXPECT_EQ(a.right.color, b.right.color);
  EXPECT_EQ(b.left.color.kind, ShaderKind::barrier);
}

TEST(UsvgLadyBug, warns_once_for_each_kind_of_set_that_holds_no_curves) {
  const auto bytes = test::shared_scene_bytes("usvg_ladybug.xml");
  if (!bytes) GTEST_SKIP() << "no public scene usvg_ladybug.xml";
  Context context;
  const Result<ReadDocument> read = read_orzan(context, *bytes, "bug.xml");
  ASSERT_TRUE(read.ok());
  ASSERT_EQ(read->warnings.size(), 2u);
  EXPECT_EQ(to_string(read->warnings[0]),
            "bug.xml:1857:3: <poisson_curve_set> is not read; such elements are ignored");
  EXPECT_EQ(to_string(read->warnings[1]),
            "bug.xml:1972:3: <mesh_set> is not read; such elements are ignored");
}

TEST(GlassDroplet, has_blur_radii_on_both_sides_alike) {
  const auto document = test::shared_scene("glass_droplet_blur.xml");
  if (!document) GTEST_SKIP() << "no public scene glass_droplet_blur.xml";
  const Curve& curve = document->layers[0].curves[0];
  ASSERT_EQ(curve.left.blur_radius.stops.size(), 2u);
  EXPECT_NEAR(curve.left.blur_radius.stops[0].value, 3 * 1.87997, 1e-4);
  EXPECT_NEAR(curve.left.blur_radius.stops[1].value, 1.87997, 1e-4);
  EXPECT_EQ(curve.left.blur_radius, curve.right.blur_radius);
}

}  // namespace
}  // namespace sfumato
