#include "solve/fields/miss_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "solve/layers/layer_solver.hpp"
#include "solve/layers/prepare_layer.hpp"
#include "support/drawing.hpp"

/// The search, which probes few triangles everywhere, compared with probes at every place of all
/// triangles.
namespace sfumato::solve {
namespace {

constexpr float kLimit = 1.0f / 255;

/// The windows that a point neglects depend on the points that are gathered with it.
constexpr float kSurelyGood = 0.9f;

/// Returns crossing curves of any colours, in one layer.
Document crossing_curves(std::mt19937& random) {
  std::uniform_real_distribution<float> unit(0, 1);
  const auto color = [&] { return Rgb{unit(random), unit(random), unit(random)}; };
  const auto place = [&] { return Vec2{100 * unit(random), 100 * unit(random)}; };
  std::vector<Curve> curves;
  for (int i = 0; i < 6; ++i) {
    curves.push_back({.control_points = {place(), place(), place(), place()}});
    curves.back() = test::colored(curves.back(), color(), color());
    if (i % 2 == 1) curves.back() = test::blurred(curves.back(), 8 * unit(random));
  }
  return test::one_layer(std::move(curves));
}

struct Count {
  std::size_t triangles = 0;
  std::size_t misses = 0;      ///< found by probes at every place
  std::size_t overlooked = 0;  ///< of these, not found by the search
  std::size_t wrong = 0;       ///< found only by the search
  float most_overlooked = 0;   ///< as a multiple of the limit
};

/// Errors per triangle, as multiples of the limit. If corners of neighbours have separate nodes,
/// their patches differ on the common edge.
struct WorstMisses {
  std::vector<float> own;   ///< of its own patch, at all its probes
  std::vector<float> near;  ///< includes its neighbours' patches, on the common edges
};

WorstMisses worst_misses(Context& context, const mesh::TriangleMesh& mesh,
                         const FieldSolver& field) {
  std::vector<std::uint32_t> all(mesh.triangle_count());
  for (std::uint32_t t = 0; t < all.size(); ++t) all[t] = t;
  const std::vector<ProbeChoice> choice(all.size(), kAllProbes);
  Result<ProbeSet> placed = place_probes(context, mesh, field.layout(), all, choice);
  ProbeSet& probes = *placed;
  const auto channels = static_cast<std::size_t>(field.channel_count());
  std::vector<float> exact(channels * probes.position.size()), patch(channels);
  EXPECT_TRUE(field.field().gatherer.gather(context, probes.position, {}, exact).ok());
  const auto miss_at = [&](std::size_t i) {
    patch_value_at_probe(probes, i, field.layout(), PatchOrder::cubic, patch.data());
    float most = 0;
    for (std::size_t c = 0; c < channels; ++c)
      most = std::max(most, std::fabs(patch[c] - exact[channels * i + c]) / kLimit);
    return most;
  };
  WorstMisses worst{std::vector<float>(all.size()), std::vector<float>(all.size())};
  const auto raise = [](float& most, float miss) { most = std::max(most, miss); };
  for (std::size_t i = 0; i < probes.position.size(); ++i) {
    const std::uint32_t half_edge = probes.half_edge[i];
    const std::int32_t twin = mesh.half_edge_twin[half_edge];
    const float miss = miss_at(i);
    raise(worst.own[half_edge / 3], miss);
    raise(worst.near[half_edge / 3], miss);
    if (probes.place[i] != kEdgePlace || twin == mesh::kNone) continue;
    const std::uint32_t other = probes.half_edge[i] = static_cast<std::uint32_t>(twin);
    const float miss_beyond = miss_at(i);
    raise(worst.own[other / 3], miss_beyond);
    raise(worst.near[other / 3], std::max(miss, miss_beyond));
    raise(worst.near[half_edge / 3], miss_beyond);
  }
  return worst;
}

void compare(Context& context, const mesh::TriangleMesh& mesh, const FieldSolver& field,
             Count& count) {
  std::vector<std::uint32_t> all(mesh.triangle_count());
  for (std::uint32_t t = 0; t < all.size(); ++t) all[t] = t;
  std::vector<std::uint8_t> found(all.size());
  const auto weight = [](std::uint32_t) { return 1.0f; };
  ASSERT_TRUE(
      field.find_misses(context, mesh, all, {kLimit, PatchOrder::cubic, weight}, found).ok());
  const WorstMisses worst = worst_misses(context, mesh, field);
  for (std::size_t t = 0; t < all.size(); ++t) {
    const bool misses = worst.own[t] > 1;
    ++count.triangles;
    count.misses += misses;
    count.wrong += found[t] && worst.near[t] < kSurelyGood;
    if (!misses || found[t]) continue;
    ++count.overlooked;
    count.most_overlooked = std::max(count.most_overlooked, worst.own[t]);
  }
}

TEST(MissSearch, finds_nearly_all_that_misses_and_nothing_else) {
  std::mt19937 random(3);
  Count count;
  for (int run = 0; run < 20; ++run) {
    Context context;
    const Document document = crossing_curves(random);
    const LayerSight sight = sight_of_layer(document, 0, document.artboard);
    const DiffuseOptions options{.pixels_per_unit = 4};
    Result<PreparedLayer> prepared =
        prepare_layer(context, document, 0, sight, options, nullptr, LayerUse::patches);
    ASSERT_TRUE(prepared.ok()) << prepared.status().message;
    const auto watch = [&](const mesh::TriangleMesh& mesh, const FieldSolver& color,
                           const FieldSolver*) { compare(context, mesh, color, count); };
    ASSERT_TRUE(LayerSolver(context, std::move(*prepared), options, nullptr, watch).solve().ok());
  }
  EXPECT_GT(count.misses, 1000u);
  EXPECT_LE(count.overlooked, count.misses / 200) << "of " << count.triangles << " triangles";
  EXPECT_EQ(count.wrong, 0u);
  RecordProperty("misses", std::to_string(count.misses));
  RecordProperty("overlooked", std::to_string(count.overlooked));
  RecordProperty("most_overlooked", std::to_string(count.most_overlooked));
}

}  // namespace
}  // namespace sfumato::solve
