#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "curves/flatten.hpp"
#include "gather/gather_reference.hpp"
#include "gather/scenes.hpp"
#include "mesh/mesher.hpp"
#include "support/scenes.hpp"

namespace sfumato::gather::test {
namespace {

class SharedScene : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    const std::optional<Document> document = sfumato::test::shared_scene(GetParam());
    if (!document) GTEST_SKIP() << "no public scene " << GetParam();
    Context context;
    const double side = std::max(document->artboard.width(), document->artboard.height());
    const std::vector<Curve>& curves = document->layers[0].curves;
    Result<curves::FlatCurves> flat =
        curves::flatten(context, curves, {.tolerance = side * 0.1 / 512});
    ASSERT_TRUE(flat.ok());
    mesh::MeshOptions options;
    options.frame = document->artboard;
    options.unit_size = side / 1024;
    Result<mesh::Mesher> mesher = mesh::Mesher::build(context, *flat, options);
    ASSERT_TRUE(mesher.ok());
    drawing_.frame = document->artboard;
    TableMemory memory("a test");
    drawing_.attributes =
        *curves::sample_colors(context, *flat, curves, InterpolationSpace::srgb, memory);
    drawing_.mesh = *mesher->visibility_mesh({});
    points_ = points_off_the_curves();
  }

  /// Returns a regular grid that misses vertices, without points closer than 0.05 to a curve, where
  /// the rounding of the point itself shows.
  std::vector<Vec2> points_off_the_curves() const {
    std::vector<Vec2> points;
    constexpr int kSide = 40;
    for (int i = 0; i < kSide * kSide; ++i) {
      const Vec2 fraction{(i % kSide + 0.377) / kSide, (i / kSide + 0.619) / kSide};
      const Vec2 p = drawing_.frame.min + Vec2{fraction.x * drawing_.frame.width(),
                                               fraction.y * drawing_.frame.height()};
      if (distance_to_curves(p) > 0.05) points.push_back(p);
    }
    return points;
  }

  double distance_to_curves(Vec2 p) const {
    double least = 1e300;
    for (const mesh::Constraint& c : drawing_.mesh.constraint) {
      if (c.piece_begin == c.piece_end) continue;
      const Vec2 a = drawing_.mesh.vertex_position[c.from];
      const Vec2 e = drawing_.mesh.vertex_position[c.to] - a;
      const double t = std::clamp(dot(p - a, e) / length_squared(e), 0.0, 1.0);
      least = std::min(least, length(a + e * t - p));
    }
    return least;
  }

  Drawing drawing_;
  std::vector<Vec2> points_;
};

TEST_P(SharedScene, packets_give_the_reference) {
  Context context;
  const Gathered gathered = gather_at(context, drawing_, points_);
  const Difference d = difference(gathered.value, reference_at(drawing_, points_));
  EXPECT_LE(d.rms, 4e-3);
  EXPECT_LE(d.largest, 0.05);
}

TEST_P(SharedScene, bytes_do_not_depend_on_the_instruction_set) {
  Context context;
  context.simd = SimdLevel::sse2;
  const Gathered expected = gather_at(context, drawing_, points_);
  for (SimdLevel level : {SimdLevel::avx2, SimdLevel::avx512}) {
    if (level > detected_simd_level()) continue;
    context.simd = level;
    const Gathered gathered = gather_at(context, drawing_, points_);
    EXPECT_EQ(std::memcmp(gathered.value.data(), expected.value.data(),
                          expected.value.size() * sizeof(float)),
              0);
  }
}

TEST_P(SharedScene, rays_agree_within_their_noise) {
  std::vector<Vec2> some;
  for (std::size_t i = 0; i < points_.size(); i += 61) some.push_back(points_[i]);
  Context context;
  const Gathered exact = gather_at(context, drawing_, some);
  const Gathered rays = gather_at(context, drawing_, some,
                                  {.method = Method::rays, .rays_per_node = 4096, .seed = 1});
  EXPECT_LE(difference(rays.value, exact.value).rms, 0.1);
  EXPECT_EQ(rays.hit, exact.hit);
}

INSTANTIATE_TEST_SUITE_P(Public, SharedScene,
                         testing::Values("lady_bug.xml", "dolphin.xml", "tomatos.xml", "drape.xml",
                                         "roses_spirales.xml", "arch.xml", "circles.xml",
                                         "endcap.xml"),
                         [](const auto& scene) {
                           std::string name = scene.param;
                           return name.substr(0, name.find('.'));
                         });

}  // namespace
}  // namespace sfumato::gather::test
