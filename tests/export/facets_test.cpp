#include "export/facets/facets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <random>

#include "export/facets/facet_patch.hpp"
#include "export/support.hpp"
#include "raster/pictures.hpp"
#include "sfumato/base/native/thread_pool.hpp"
#include "sfumato/solve/diffuse.hpp"
#include "support/drawing.hpp"
#include "support/scenes.hpp"

namespace sfumato::outputs {
namespace {

constexpr double kHalfStep = 0.5 / 255;

FacetMesh facets(const PatchLayer& layer, double max_error,
                 const FacetSource& source = {FacetSource::Kind::color, 0},
                 InterpolationSpace space = InterpolationSpace::srgb) {
  static Context context;  // must outlive the tables charged to it
  Result<FacetMesh> mesh = make_facets(context, layer, space, source, max_error);
  EXPECT_TRUE(mesh.ok()) << to_string(mesh.status());
  return mesh ? std::move(*mesh) : FacetMesh{};
}

/// Returns the barycentric weights of p in a triangle.
Barycentric weights(const std::array<Vec2, 3>& corner, Vec2 p) {
  const double area = cross(corner[1] - corner[0], corner[2] - corner[0]);
  const double u = cross(p - corner[0], corner[2] - corner[0]) / area;
  const double v = cross(corner[1] - corner[0], p - corner[0]) / area;
  return {1 - u - v, u, v};
}

/// Returns the largest difference between facets and patches on a lattice of `density` points per
/// side of every facet.
double largest_error(const PatchLayer& layer, const FacetMesh& mesh, const FacetSource& source,
                     InterpolationSpace space, int density = 5) {
  double largest = 0;
  const auto channels = static_cast<std::size_t>(mesh.channel_count);
  for (std::uint32_t t = 0; t < layer.triangle_count(); ++t) {
    const FacetPatch patch(layer, space, source, t, kHalfStep);
    std::array<Vec2, 3> corner;
    for (std::size_t k = 0; k < 3; ++k)
      corner[k] = layer.vertex_position[layer.triangle_vertex[3 * std::size_t{t} + k]];
    if (cross(corner[1] - corner[0], corner[2] - corner[0]) < 1e-9) continue;
    for (std::uint32_t f = mesh.patch_first_facet[t]; f < mesh.patch_first_facet[t + 1]; ++f) {
      const std::uint32_t* vertex = mesh.facet_vertex.data() + std::size_t{3} * f;
      for (int i = 0; i <= density; ++i) {
        for (int j = 0; i + j <= density; ++j) {
          const double w[3] = {1.0 * i / density, 1.0 * j / density,
                               1.0 * (density - i - j) / density};
          Vec2 p;
          for (int k = 0; k < 3; ++k) p = p + mesh.vertex_position[vertex[k]] * w[k];
          const FacetPatch::Value shown = patch.shown(weights(corner, p));
          for (std::size_t c = 0; c < channels; ++c) {
            double value = 0;
            for (int k = 0; k < 3; ++k) value += w[k] * mesh.vertex_value[channels * vertex[k] + c];
            largest = std::max(largest, std::fabs(value - shown[c]));
          }
        }
      }
    }
  }
  return largest;
}

/// Returns a grid of patches with random, shared nodes, like a layer of diffuse(): within `spread`
/// of `center` on the left, and calmer on the right, so that levels differ.
PatchLayer random_layer(std::uint32_t seed, float center, float spread) {
  std::mt19937 random(seed);
  std::map<std::pair<long, long>, Rgb> value_at;
  const auto draw = [&](float reach) {
    return center + reach * static_cast<float>(random() / 2147483648.0 - 1);
  };
  const test::RegionMesh mesh = test::jittered_grid(test::kSquareBox, 4, seed);
  PatchLayer layer = test::make_layer(mesh, [&](int, Vec2 p) {
    const auto key = std::pair{std::lround(p.x * 1e6), std::lround(p.y * 1e6)};
    const auto [place, is_new] = value_at.try_emplace(key);
    const float reach = p.x > 32 ? 0.1f * spread : spread;
    if (is_new) place->second = {draw(reach), draw(reach), draw(reach)};
    return place->second;
  });
  // One node where the positions are equal.
  std::map<std::pair<long, long>, std::uint32_t> node_at;
  for (std::uint32_t t = 0; t < layer.triangle_count(); ++t) {
    for (std::size_t n = 0; n < 10; ++n) {
      Vec2 p;
      for (std::size_t k = 0; k < 3; ++k)
        p = p + layer.vertex_position[layer.triangle_vertex[3 * std::size_t{t} + k]] *
                    kNodeBarycentric[n][k];
      std::uint32_t& node = layer.color.triangle_node[std::size_t{10} * t + n];
      node =
          node_at.try_emplace({std::lround(p.x * 1e6), std::lround(p.y * 1e6)}, node).first->second;
    }
  }
  return layer;
}

using Segment = std::pair<std::uint32_t, std::uint32_t>;

/// Returns facet sides that no other facet has in the other direction.
std::vector<Segment> unmatched_sides(const FacetMesh& mesh) {
  std::map<Segment, int> side_count;
  for (std::size_t i = 0; i < mesh.facet_vertex.size(); ++i) {
    const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
    ++side_count[{mesh.facet_vertex[i], mesh.facet_vertex[next]}];
  }
  std::vector<Segment> unmatched;
  for (const auto& [side, count] : side_count) {
    EXPECT_EQ(count, 1);
    if (!side_count.contains({side.second, side.first})) unmatched.push_back(side);
  }
  return unmatched;
}

/// Returns a layer of one triangle with one channel of colour, z(w, u, v) at the nodes.
PatchLayer one_patch(PatchOrder order, const std::function<double(double u, double v)>& z) {
  PatchLayer layer;
  layer.order = order;
  layer.vertex_position = {{0, 0}, {10, 0}, {0, 10}};
  layer.triangle_vertex = {0, 1, 2};
  layer.edge_is_curve = {0, 0, 0};
  for (std::uint32_t n = 0; n < 10; ++n) {
    layer.color.triangle_node.push_back(n);
    const auto value = static_cast<float>(z(kNodeBarycentric[n][1], kNodeBarycentric[n][2]));
    for (int c = 0; c < 3; ++c) layer.color.node_value.push_back(value);
  }
  return layer;
}

TEST(Facets, a_linear_patch_is_one_facet) {
  const PatchLayer layer =
      one_patch(PatchOrder::cubic, [](double u, double v) { return 0.1 + 0.5 * u + 0.3 * v; });
  const FacetMesh mesh = facets(layer, kHalfStep);
  EXPECT_EQ(mesh.facet_vertex, (std::vector<std::uint32_t>{0, 1, 2}));
  ASSERT_EQ(mesh.vertex_value.size(), 9u);
  EXPECT_FLOAT_EQ(mesh.vertex_value[3], 0.6f);
}

TEST(Facets, a_parabola_is_cut_along_itself_alone) {
  // z = h u² differs from a chord of length 1/n by h / 4 n². Edges are halved until that is 0.7 of
  // the error; the opposite edge does not bend.
  const double h = 0.6;
  int cuts = 1;
  while (h / (4 * cuts * cuts) > 0.7 * kHalfStep) cuts *= 2;
  for (PatchOrder order : {PatchOrder::cubic, PatchOrder::quadratic}) {
    const PatchLayer layer = one_patch(order, [&](double u, double) { return 0.2 + h * u * u; });
    const FacetMesh mesh = facets(layer, kHalfStep);
    int on_edge = 0, across = 0;
    for (Vec2 p : mesh.vertex_position) {
      on_edge += p.y == 0;
      across += p.x == 0;
    }
    EXPECT_EQ(on_edge, cuts + 1);
    EXPECT_EQ(across, 2);
    EXPECT_LT(mesh.facet_vertex.size() / 3, static_cast<unsigned>(cuts * cuts / 2));
  }
  const PatchLayer flat =
      one_patch(PatchOrder::linear, [&](double u, double) { return h * u * u; });
  EXPECT_EQ(facets(flat, kHalfStep).facet_vertex.size(), 3u);
}

// A cubic differs from its chord's middle by f'' / 8: `bend` reads f'' from Bézier ordinates,
// `shown` the values from patch_basis.
TEST(Facets, ordinates_and_basis_are_of_one_cubic) {
  std::mt19937 random(7);
  for (int round = 0; round < 50; ++round) {
    const PatchLayer layer = one_patch(PatchOrder::cubic, [&](double, double) {
      return 0.5 + 0.05 * (random() / 2147483648.0 - 1);
    });
    const FacetPatch patch(layer, InterpolationSpace::srgb, {}, 0, kHalfStep);
    for (const Barycentric& a : {Barycentric{0.6, 0.3, 0.1}, {0.1, 0.2, 0.7}, {0.2, 0.7, 0.1}}) {
      constexpr double kSide = 1.0 / 64;
      const Barycentric b{a[0] - kSide, a[1] + kSide, a[2]};
      const Barycentric middle{a[0] - kSide / 2, a[1] + kSide / 2, a[2]};
      const double miss =
          std::fabs(patch.shown(middle)[0] - (patch.shown(a)[0] + patch.shown(b)[0]) / 2);
      // The change of f'' from the middle to an end: f''' of such values is below 20.
      EXPECT_NEAR(patch.bend(a, b), miss, 20 * kSide * kSide * kSide / 16) << round;
    }
  }
}

TEST(Facets, every_facet_turns_as_its_patch) {
  const PatchLayer layer = random_layer(3, 0.5f, 0.1f);
  const FacetMesh mesh = facets(layer, kHalfStep);
  for (std::size_t f = 0; f < mesh.facet_vertex.size(); f += 3) {
    const Vec2 a = mesh.vertex_position[mesh.facet_vertex[f]];
    EXPECT_GT(cross(mesh.vertex_position[mesh.facet_vertex[f + 1]] - a,
                    mesh.vertex_position[mesh.facet_vertex[f + 2]] - a),
              0);
  }
}

TEST(Facets, random_patches_stay_within_the_error) {
  for (std::uint32_t seed = 1; seed <= 12; ++seed) {
    for (double max_error : {kHalfStep, 2 / 255.0}) {
      const PatchLayer layer = random_layer(seed, 0.5f, 0.02f);
      const FacetSource source;
      const double error =
          largest_error(layer, facets(layer, max_error), source, InterpolationSpace::srgb, 4);
      EXPECT_LE(error, max_error * 1.0001) << seed;
      EXPECT_GT(error, max_error / 4) << seed;
    }
  }
}

TEST(Facets, clamped_overshoot_stays_within_the_error) {
  for (std::uint32_t seed = 1; seed <= 4; ++seed) {
    const PatchLayer layer = random_layer(seed, 0.995f, 0.01f);
    const FacetMesh mesh = facets(layer, 2 / 255.0);
    EXPECT_EQ(*std::max_element(mesh.vertex_value.begin(), mesh.vertex_value.end()), 1);
    EXPECT_LE(largest_error(layer, mesh, {}, InterpolationSpace::srgb, 3), 2 / 255.0) << seed;
  }
}

TEST(Facets, other_interpolation_spaces_are_bound_in_code_values) {
  for (InterpolationSpace space : {InterpolationSpace::linear, InterpolationSpace::oklab}) {
    PatchLayer layer = random_layer(5, 0.4f, 0.02f);
    // OKLab's a and b are 0 for grey.
    for (std::size_t i = 0; space == InterpolationSpace::oklab && i < layer.color.node_value.size();
         ++i)
      if (i % 3 != 0) layer.color.node_value[i] -= 0.4f;
    const FacetMesh mesh = facets(layer, 2 / 255.0, {}, space);
    EXPECT_LE(largest_error(layer, mesh, {}, space, 3), 2 / 255.0) << static_cast<int>(space);
    EXPECT_GT(mesh.facet_vertex.size(), layer.triangle_vertex.size());
    // Without shaders the curves have the whole share.
    const FacetMesh base = facets(layer, 2 / 255.0, {FacetSource::Kind::color_base}, space);
    EXPECT_EQ(base.vertex_value, mesh.vertex_value);
  }
}

TEST(Facets, neighbours_share_the_points_of_their_edge) {
  for (std::uint32_t seed = 1; seed <= 6; ++seed) {
    const FacetMesh mesh = facets(random_layer(seed, 0.5f, 0.1f), kHalfStep);
    for (const auto& [from, to] : unmatched_sides(mesh)) {
      const Vec2 middle = lerp(mesh.vertex_position[from], mesh.vertex_position[to], 0.5);
      const bool on_border = std::min({middle.x, middle.y, 64 - middle.x, 64 - middle.y}) < 1e-9;
      EXPECT_TRUE(on_border) << seed << ": a T-junction at " << middle.x << ' ' << middle.y;
    }
  }
}

TEST(Facets, the_sides_of_a_curve_have_the_same_points) {
  // Left of the line steep, right of it flat; no nodes are shared.
  const test::RegionMesh mesh = test::cut_box(test::kSquareBox, {20, 64}, {40, 0});
  const PatchLayer layer = test::make_layer(mesh, [](int region, Vec2 p) {
    return region == 0 ? Rgb{static_cast<float>(p.y * p.y / 4096), 0, 0} : Rgb{0, 0, 1};
  });
  const FacetMesh cut = facets(layer, kHalfStep);
  std::map<std::pair<double, double>, std::array<int, 2>> count_at;
  for (std::uint32_t f = 0; f < cut.facet_vertex.size(); ++f) {
    const Vec2 p = cut.vertex_position[cut.facet_vertex[f]];
    if (std::fabs(20 + (64 - p.y) * 20 / 64 - p.x) > 1e-9) continue;
    const bool is_right = cut.vertex_value[3 * std::size_t{cut.facet_vertex[f]} + 2] > 0.5f;
    ++count_at[{p.x, p.y}][is_right];
  }
  EXPECT_GT(count_at.size(), 5u);
  for (const auto& [place, count] : count_at) {
    EXPECT_GT(count[0], 0) << place.second;
    EXPECT_GT(count[1], 0) << place.second;
  }
}

TEST(Facets, opacity_and_masks_are_one_channel) {
  const test::RegionMesh mesh = test::jittered_grid(test::kSquareBox, 2, 1);
  PatchLayer layer = test::make_layer(mesh, [](int, Vec2) { return test::kRed; });
  test::set_opacity(
      mesh, [](int, Vec2 p) { return static_cast<float>(p.x / 64); }, &layer);
  test::add_weight(
      mesh, 0, [](int, Vec2 p) { return static_cast<float>(p.y / 64); }, &layer.color);
  for (const auto kind : {FacetSource::Kind::opacity, FacetSource::Kind::color_mask}) {
    const FacetMesh cut = facets(layer, kHalfStep, {kind, 0});
    ASSERT_EQ(cut.channel_count, 1);
    for (std::size_t v = 0; v < cut.vertex_position.size(); ++v) {
      const Vec2 p = cut.vertex_position[v];
      EXPECT_NEAR(cut.vertex_value[v], (kind == FacetSource::Kind::opacity ? p.x : p.y) / 64, 1e-6);
    }
  }
}

TEST(Facets, values_that_are_no_numbers_are_never_written) {
  PatchLayer layer = random_layer(2, 0.5f, 0.1f);
  layer.color.node_value[40] = std::numeric_limits<float>::quiet_NaN();
  layer.color.node_value[70] = std::numeric_limits<float>::infinity();
  for (float value : facets(layer, kHalfStep).vertex_value)
    EXPECT_TRUE(value >= 0 && value <= 1) << value;
}

TEST(Facets, an_empty_layer_has_none) {
  const FacetMesh mesh = facets(PatchLayer{}, kHalfStep);
  EXPECT_TRUE(mesh.vertex_position.empty());
  EXPECT_EQ(mesh.patch_first_facet, std::vector<std::uint32_t>{0});
}

TEST(Facets, memory_and_cancellation_end_the_work) {
  const PatchLayer layer = random_layer(1, 0.5f, 0.1f);
  Context small;
  small.budget.charge(small.budget.limit() - 10'000, "the test").ok();
  const auto refused = make_facets(small, layer, InterpolationSpace::srgb, {}, kHalfStep);
  EXPECT_EQ(refused.status().code, StatusCode::limit);
  Context cancelled;
  cancelled.cancel = true;
  const auto stopped = make_facets(cancelled, layer, InterpolationSpace::srgb, {}, kHalfStep);
  EXPECT_EQ(stopped.status().code, StatusCode::cancelled);
}

TEST(Facets, memory_is_given_back) {
  Context context;
  {
    const auto mesh =
        make_facets(context, random_layer(1, 0.5f, 0.1f), InterpolationSpace::srgb, {}, kHalfStep);
    EXPECT_GT(context.budget.used(), 0u);
  }
  EXPECT_EQ(context.budget.used(), 0u);
}

TEST(Facets, any_number_of_threads_gives_the_same_bytes) {
  const PatchLayer layer = random_layer(7, 0.5f, 0.3f);
  const FacetMesh one = facets(layer, kHalfStep);
  ThreadPool pool(3);
  Context context;
  context.executor = &pool;
  const auto many = make_facets(context, layer, InterpolationSpace::srgb, {}, kHalfStep);
  ASSERT_TRUE(many.ok());
  EXPECT_EQ(many->vertex_value, one.vertex_value);
  EXPECT_EQ(many->facet_vertex, one.facet_vertex);
}

TEST(Facets, the_lady_bug_stays_within_half_a_code_value) {
  const std::optional<Document> document = test::shared_scene("lady_bug.xml");
  if (!document) GTEST_SKIP() << "no public scene lady_bug.xml";
  Context context;
  const Result<Picture> picture = diffuse(context, *document, {});
  ASSERT_TRUE(picture.ok());
  const PatchLayer& layer = picture->layers[0];
  const FacetMesh mesh = facets(layer, kHalfStep);
  // Where patches overshoot, cuts end at kMostClampedCuts.
  EXPECT_LE(largest_error(layer, mesh, {}, InterpolationSpace::srgb, 3), 8 * kHalfStep);
  EXPECT_LT(mesh.facet_vertex.size() / 3, 20 * std::size_t{layer.triangle_count()});
}

}  // namespace
}  // namespace sfumato::outputs
