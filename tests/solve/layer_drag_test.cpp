#include "solve/session/layer_drag.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "solve/refined_layer.hpp"
#include "solve/same_layout.hpp"
#include "support/cancel_at.hpp"
#include "support/drawing.hpp"
#include "support/random_document.hpp"
#include "support/same_picture.hpp"
#include "support/sanitizers.hpp"
#include "support/soak.hpp"

/// A curve that moves while all others stay.
namespace sfumato::solve {
namespace {

const auto kLayerDragDocuments =
    test::random_case_count<std::uint64_t>(SFUMATO_HAS_SANITIZER ? 4 : 14, 40);

/// Limit for the error of a frame. A gather skips windows too narrow to count; the skipped ones
/// depend on the mesh around a point.
constexpr float kMostDragMiss = 1.0f / 255;

/// At a point where two curves nearly touch, its side of them is undefined.
constexpr double kAside = 1e-3;

/// The free nodes of a frame compared with gathering all of them.
struct Comparison {
  std::size_t nodes = 0;
  float worst = 0;
  Vec2 place{};

  void add(Context& context, const FieldSolver& field) {
    const NodeLayout& layout = field.layout();
    const auto channels = static_cast<std::size_t>(layout.channel_count);
    std::vector<float> exact(layout.value.size());
    std::vector<std::uint32_t> free = layout.triangle_node;
    std::ranges::sort(free);
    free.erase(std::unique(free.begin(), free.end()), free.end());
    std::erase_if(free, [&](std::uint32_t n) { return layout.is_fixed[n] != 0; });
    const gather::Gatherer& gatherer = field.field().gatherer;
    ASSERT_TRUE(gatherer.gather(context, {layout.position, free}, {}, exact).ok());
    nodes += free.size();
    for (const std::uint32_t n : free) {
      const float* const value = layout.value.data() + channels * n;
      float miss = largest_miss(value, exact.data() + channels * n, channels);
      if (miss > kMostDragMiss)
        miss = least_miss_around(context, gatherer, layout.position[n], value);
      if (!(miss <= worst)) worst = miss, place = layout.position[n];
    }
  }

  static float largest_miss(const float* a, const float* b, std::size_t channels) {
    float largest = 0;
    for (std::size_t c = 0; c < channels; ++c) largest = std::max(largest, std::fabs(a[c] - b[c]));
    return largest;
  }

  static float least_miss_around(Context& context, const gather::Gatherer& gatherer, Vec2 p,
                                 const float* value) {
    const auto channels = static_cast<std::size_t>(gatherer.channel_count());
    const std::vector<Vec2> around{p + Vec2{kAside, kAside}, p + Vec2{-kAside, kAside},
                                   p + Vec2{kAside, -kAside}, p + Vec2{-kAside, -kAside}};
    std::vector<float> exact(channels * around.size());
    EXPECT_TRUE(gatherer.gather(context, around, {}, exact).ok());
    float least = 1;
    for (std::size_t i = 0; i < around.size(); ++i) {
      least = std::min(least, largest_miss(value, exact.data() + channels * i, channels));
    }
    return least;
  }
};

Curve moved(const Curve& curve, Vec2 by, std::mt19937& random) {
  Curve result = curve;
  const std::size_t count = result.control_points.size();
  const std::size_t only = random() % (2 * count);  // one point, or the whole curve
  for (std::size_t i = 0; i < count; ++i) {
    if (only >= count || only == i) result.control_points[i] = result.control_points[i] + by;
  }
  return result;
}

struct LayerCurve {
  std::uint32_t layer;
  std::uint32_t curve;
};

/// Returns visible layers, with one of their curves each.
std::vector<LayerCurve> some_curves(const Document& document, std::mt19937& random) {
  std::vector<LayerCurve> chosen;
  for (std::uint32_t l = 0; l < document.layers.size(); ++l) {
    const auto count = static_cast<std::uint32_t>(document.layers[l].curves.size());
    if (count == 0 || sight_of_layer(document, l, document.artboard).views.empty()) continue;
    chosen.push_back({l, static_cast<std::uint32_t>(random() % count)});
  }
  return chosen;
}

Picture picture_of(const PatchLayer& layer) {
  Picture picture;
  picture.layers.push_back(layer);
  return picture;
}

void expect_exact_frames(const Document& document, LayerCurve at, const DiffuseOptions& options,
                         bool was_solved, std::mt19937& random) {
  Context context;
  const LayerSight sight = sight_of_layer(document, at.layer, document.artboard);
  std::optional<RefinedLayer> refined;
  PatchLayer shown;  // the last frame, or the solved layer
  if (was_solved) refined = refined_layer(context, document, at.layer, sight, options, &shown);
  const bool is_known = refined.has_value();
  Result<LayerDrag> drag =
      LayerDrag::begin(context, document, at.layer, at.curve, sight, options, refined, 0);
  if (!drag && drag.status().code == StatusCode::limit) return;
  ASSERT_TRUE(drag.ok()) << drag.status().message;
  EXPECT_EQ(refined.has_value(), is_known);
  EXPECT_EQ(drag->has_room(), !is_known);
  std::optional<FrameRows> rows = drag->take_rows_of_solved();  // rows of `shown`
  for (int frame = 0; frame < 5; ++frame) {
    SCOPED_TRACE("frame " + std::to_string(frame));
    const Vec2 by{double(random() % 21) - 10, double(random() % 21) - 10};
    const Curve curve = moved(document.layers[at.layer].curves[at.curve], by, random);
    Comparison seen;
    const auto watch = [&](const mesh::TriangleMesh& mesh, const FieldSolver& color,
                           const FieldSolver* opacity) {
      for (const FieldSolver* field : {&color, opacity}) {
        if (!field) continue;
        seen.add(context, *field);
        const NodeLayout& layout = field->layout();
        const bool has_parts =
            layout.triangle_node.size() > kNodesPerTriangle * mesh.triangle_count();
        if (has_parts) continue;
        EXPECT_EQ(difference_from_new_layout(context, mesh, field->field().attributes, layout), "");
      }
    };
    Result<FramePatches> made =
        drag->frame(context, curve, {.wants_rows = rows.has_value(), .watch = watch});
    Context other;  // shares nothing with the earlier frames
    const Result<FramePatches> anew = drag->frame(other, curve);
    EXPECT_EQ(other.budget.used(), 0u);
    ASSERT_EQ(made.status().code, anew.status().code);
    if (!made && made.status().code == StatusCode::bad_input) continue;
    ASSERT_TRUE(made.ok()) << made.status().message;
    if (made->is_whole) {
      shown = std::move(made->layer);
    } else {
      ASSERT_TRUE(drag->make_room(context, shown).ok());
      drag->write(*made, *rows, shown);
    }
    rows = std::move(made->rows);
    EXPECT_EQ(test::difference_of(picture_of(shown), picture_of(anew->layer)), "");
    EXPECT_LE(seen.worst, kMostDragMiss) << "at " << seen.place.x << ", " << seen.place.y;
  }
}

TEST(LayerDrag, has_the_exact_values_at_all_nodes_of_its_frames) {
  for (std::uint64_t seed = 0; seed < kLayerDragDocuments; ++seed) {
    const Document document = test::random_document(seed);
    std::mt19937 random(static_cast<std::uint32_t>(seed));
    DiffuseOptions options;
    options.max_error = seed % 2 == 0 ? 0 : 4;
    for (const LayerCurve at : some_curves(document, random)) {
      SCOPED_TRACE("document " + std::to_string(seed) + ", layer " + std::to_string(at.layer) +
                   ", curve " + std::to_string(at.curve));
      for (const bool was_solved : {false, true}) {
        ASSERT_NO_FATAL_FAILURE(expect_exact_frames(document, at, options, was_solved, random));
      }
    }
  }
}

void expect_small_misses(const Document& document, LayerCurve at, double most, std::mt19937& random,
                         int& missed) {
  Context context;
  const LayerSight sight = sight_of_layer(document, at.layer, document.artboard);
  DiffuseOptions options;
  options.max_error = 0;
  std::optional<RefinedLayer> refined = refined_layer(context, document, at.layer, sight, options);
  Result<LayerDrag> quick =
      LayerDrag::begin(context, document, at.layer, at.curve, sight, options, refined, most);
  if (!quick && quick.status().code == StatusCode::limit) return;
  Result<LayerDrag> slow =
      LayerDrag::begin(context, document, at.layer, at.curve, sight, options, refined, 0);
  ASSERT_TRUE(quick.ok() && slow.ok()) << quick.status().message << slow.status().message;
  for (int frame = 0; frame < 3; ++frame) {
    const Vec2 by{double(random() % 41) - 20, double(random() % 41) - 20};
    Curve curve = moved(document.layers[at.layer].curves[at.curve], by, random);
    if (random() % 3 == 0) curve.weight *= 20;
    const Result<FramePatches> about = quick->frame(context, curve);
    const Result<FramePatches> exact = slow->frame(context, curve);
    if (!about && about.status().code == StatusCode::bad_input) continue;
    ASSERT_TRUE(about.ok() && exact.ok());
    // A border lies where it is seen, and triangles cut there have other nodes.
    if (about->layer.color.triangle_node != exact->layer.color.triangle_node) continue;
    const float miss = test::largest_difference(about->layer.color, exact->layer.color);
    EXPECT_LE(miss, 1.5 * most + kMostDragMiss) << "frame " << frame;
    missed += miss > 0;
  }
}

TEST(LayerDrag, misses_no_more_than_it_may) {
  int missed = 0;
  for (std::uint64_t seed = 0; seed < kLayerDragDocuments; ++seed) {
    const Document document = test::random_document(seed);
    std::mt19937 random(static_cast<std::uint32_t>(seed));
    const double most = seed % 2 == 0 ? 0.02 : 0.2;
    for (const LayerCurve at : some_curves(document, random)) {
      SCOPED_TRACE("document " + std::to_string(seed) + ", layer " + std::to_string(at.layer) +
                   ", curve " + std::to_string(at.curve));
      ASSERT_NO_FATAL_FAILURE(expect_small_misses(document, at, most, random, missed));
    }
  }
  EXPECT_GT(missed, 0) << "nothing was left as it was";
}

}  // namespace
}  // namespace sfumato::solve
