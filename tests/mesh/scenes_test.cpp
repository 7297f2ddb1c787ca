#include "support/scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "curves/flatten.hpp"
#include "mesh/arrangement_check.hpp"
#include "mesh/is_valid.hpp"
#include "mesh/mesh_facts.hpp"
#include "mesh/mesher.hpp"

namespace sfumato::mesh::test {
namespace {

struct Input {
  curves::FlatCurves flat;
  MeshOptions options;
};

/// Returns a public scene flattened to `tolerance_px`, at 1024 px for the artboard's longer side.
std::optional<Input> shared_input(const std::string& name, double tolerance_px) {
  const std::optional<Document> document = sfumato::test::shared_scene(name);
  if (!document) return std::nullopt;
  const Box artboard = document->artboard;
  const double unit = std::max(artboard.width(), artboard.height()) / 1024;
  Context context;
  curves::FlattenOptions flatten_options;
  flatten_options.tolerance = tolerance_px * unit;
  Result<curves::FlatCurves> flat =
      curves::flatten(context, document->layers.at(0).curves, flatten_options);
  if (!flat) return std::nullopt;
  Input input{std::move(*flat), {}};
  input.options.frame = artboard.grown_by(unit);
  input.options.unit_size = unit;
  input.options.max_area = 0.04 * artboard.width() * artboard.height();
  return input;
}

class MesherScenes : public testing::TestWithParam<const char*> {};

TEST_P(MesherScenes, every_step_leaves_a_valid_mesh) {
  const std::optional<Input> input = shared_input(GetParam(), 0.25);
  if (!input) GTEST_SKIP() << "no public scene " << GetParam();
  Context context;
  Result<Mesher> mesher = Mesher::build(context, input->flat, input->options);
  ASSERT_TRUE(mesher.ok()) << mesher.status().message;
  Status valid = is_valid(*mesher->visibility_mesh({}));
  EXPECT_TRUE(valid.ok()) << valid.message;
  ASSERT_TRUE(mesher->refine(context).ok());
  const TriangleMesh patch = *mesher->patch_mesh({});
  valid = is_valid(patch);
  EXPECT_TRUE(valid.ok()) << valid.message;
  std::vector<std::uint32_t> all(patch.triangle_count());
  for (std::uint32_t t = 0; t < all.size(); ++t) all[t] = t;
  ASSERT_TRUE(mesher->refine_triangles(context, all, input->options.unit_size).ok());
  valid = is_valid(*mesher->patch_mesh({}));
  EXPECT_TRUE(valid.ok()) << valid.message;
}

TEST_P(MesherScenes, constraints_stay_near_their_segments_and_cover_them) {
  const std::optional<Input> input = shared_input(GetParam(), 0.25);
  if (!input) GTEST_SKIP() << "no public scene " << GetParam();
  const double weld = input->options.weld_px * input->options.unit_size;
  Context context;
  Result<Mesher> mesher = Mesher::build(context, input->flat, input->options);
  ASSERT_TRUE(mesher.ok()) << mesher.status().message;
  const ArrangementFacts facts = check_arrangement(*mesher->visibility_mesh({}), input->flat, weld);
  EXPECT_EQ(facts.broken, "");
  EXPECT_LE(facts.input_to_mesh, 2.5 * weld);
  EXPECT_LE(facts.mesh_to_input, 2.5 * weld);
  EXPECT_GE(facts.vertex_gap, 0.99 * weld);
}

/// Small angles remain only where the input has them: few triangles, each beside a constraint.
TEST_P(MesherScenes, small_angles_stay_only_at_small_input_angles) {
  const std::optional<Input> input = shared_input(GetParam(), 0.25);
  if (!input) GTEST_SKIP() << "no public scene " << GetParam();
  Context context;
  Result<Mesher> mesher = Mesher::build(context, input->flat, input->options);
  ASSERT_TRUE(mesher.ok()) << mesher.status().message;
  ASSERT_TRUE(mesher->refine(context).ok());
  const TriangleMesh patch = *mesher->patch_mesh({});
  std::size_t small = 0;
  for (std::uint32_t t = 0; t < patch.triangle_count(); ++t) {
    EXPECT_LE(area(patch, t), input->options.max_area * (1 + 1e-9));
    if (smallest_angle(patch, t) >= 21.99) continue;
    ++small;
    std::size_t constrained_corners = 0;
    for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
      const std::uint32_t v = patch.origin(h);
      constrained_corners +=
          std::any_of(patch.constraint.begin(), patch.constraint.end(),
                      [&](const Constraint& c) { return c.from == v || c.to == v; });
    }
    EXPECT_GE(constrained_corners, 2u) << "triangle " << t;
  }
  EXPECT_LE(small, patch.triangle_count() / 50 + 5);
}

INSTANTIATE_TEST_SUITE_P(Public, MesherScenes,
                         testing::Values("lady_bug.xml", "dolphin.xml", "tomatos.xml",
                                         "glass_droplet_blur.xml", "drape.xml",
                                         "roses_spirales.xml", "arch.xml", "circles.xml",
                                         "endcap.xml", "usvg_ladybug.xml"),
                         [](const auto& scene) {
                           const std::string name = scene.param;
                           return name.substr(0, name.find('.'));
                         });

TEST(MesherScenes, the_mesh_of_lady_bug_is_the_same_in_every_build) {
  const std::optional<Input> input = shared_input("lady_bug.xml", 0.25);
  if (!input) GTEST_SKIP() << "no public scene lady_bug.xml";
  Context context;
  Result<Mesher> mesher = Mesher::build(context, input->flat, input->options);
  ASSERT_TRUE(mesher.ok()) << mesher.status().message;
  EXPECT_EQ(mesh_hash(*mesher->visibility_mesh({})), 4375257913588577031u);
  ASSERT_TRUE(mesher->refine(context).ok());
  EXPECT_EQ(mesh_hash(*mesher->patch_mesh({})), 8162999391152372774u);
}

}  // namespace
}  // namespace sfumato::mesh::test
