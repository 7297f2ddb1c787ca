#include "solve/session/layer_session.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>
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

/// Curves that move while all others stay.
namespace sfumato::solve {
namespace {

const auto kLayerSessionDocuments =
    test::random_case_count<std::uint64_t>(SFUMATO_HAS_SANITIZER ? 3 : 10, 40);

/// Limit for the error of a frame, per moving curve. A gather skips windows too narrow to count;
/// the skipped ones depend on the mesh around a point.
constexpr float kMostDragMiss = 1.0f / 255;

/// Vertices move by up to the weld distance where a curve is inserted. A value may be that of a
/// point this far away.
constexpr double kAside = 1e-2;

/// Returns whether a point lies on one of the curves, apart from rounding.
bool is_on_a_curve(Vec2 p, std::span<const Curve> curves) {
  Context context;
  Result<curves::FlatCurves> flat = curves::flatten(context, curves, {.tolerance = 1e-3});
  EXPECT_TRUE(flat.ok());
  for (std::uint32_t v = 0; v < flat->vertex.size(); ++v) {
    if (!flat->begins_segment(v)) continue;
    const Vec2 a = flat->vertex[v], along = flat->vertex[v + 1] - a;
    const double t = std::clamp(dot(p - a, along) / std::max(1e-30, dot(along, along)), 0.0, 1.0);
    if (length(a + t * along - p) < kAside) return true;
  }
  return false;
}

/// The free nodes of a frame compared with gathering all of them.
struct Comparison {
  /// The curves at their first and at their new places. On a curve, the side is undefined, and so
  /// is the value at a vertex of the mesh, such as a free end.
  std::span<const Curve> undefined_on;
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
      if (miss > kMostDragMiss) miss = miss_around(context, gatherer, layout.position[n], value);
      if (miss > kMostDragMiss && is_on_a_curve(layout.position[n], undefined_on)) continue;
      if (!(miss <= worst)) worst = miss, place = layout.position[n];
    }
  }

  static float largest_miss(const float* a, const float* b, std::size_t channels) {
    float largest = 0;
    for (std::size_t c = 0; c < channels; ++c) largest = std::max(largest, std::fabs(a[c] - b[c]));
    return largest;
  }

  /// Returns by how much the value lies outside the range of values around p.
  static float miss_around(Context& context, const gather::Gatherer& gatherer, Vec2 p,
                           const float* value) {
    constexpr int kDirections = 16;
    const auto channels = static_cast<std::size_t>(gatherer.channel_count());
    std::vector<Vec2> around;
    for (int i = 0; i < kDirections; ++i) {
      const double angle = (2 * i + 0.5) * std::numbers::pi / kDirections;
      around.push_back(p + kAside * Vec2{std::cos(angle), std::sin(angle)});
    }
    std::vector<float> exact(channels * around.size());
    EXPECT_TRUE(gatherer.gather(context, around, {}, exact).ok());
    float miss = 0;
    for (std::size_t c = 0; c < channels; ++c) {
      float least = value[c], most = value[c];
      for (std::size_t i = c; i < exact.size(); i += channels) {
        least = i == c ? exact[i] : std::min(least, exact[i]);
        most = i == c ? exact[i] : std::max(most, exact[i]);
      }
      miss = std::max({miss, least - value[c], value[c] - most});
    }
    return miss;
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

/// A layer and some of its curves.
struct Moving {
  std::uint32_t layer;
  std::vector<std::uint32_t> curves;
};

/// Returns the visible layers, with one to three of their curves each.
std::vector<Moving> some_curves(const Document& document, std::mt19937& random) {
  std::vector<Moving> chosen;
  for (std::uint32_t l = 0; l < document.layers.size(); ++l) {
    const auto count = static_cast<std::uint32_t>(document.layers[l].curves.size());
    if (count == 0 || sight_of_layer(document, l, document.artboard).views.empty()) continue;
    std::set<std::uint32_t> curves;
    const std::size_t most = 1 + random() % 3;
    for (std::size_t i = 0; i < most; ++i)
      curves.insert(static_cast<std::uint32_t>(random() % count));
    chosen.push_back({l, {curves.begin(), curves.end()}});
  }
  return chosen;
}

/// Returns the curves at new places.
std::vector<Curve> moved(const Document& document, const Moving& at, int most,
                         std::mt19937& random) {
  std::vector<Curve> curves;
  const auto step = [&] { return double(random() % static_cast<unsigned>(2 * most + 1)) - most; };
  for (const std::uint32_t curve : at.curves) {
    const Vec2 by{step(), step()};
    curves.push_back(moved(document.layers[at.layer].curves[curve], by, random));
  }
  return curves;
}

std::string name_of(std::uint64_t seed, const Moving& at) {
  std::string name = "document " + std::to_string(seed) + ", layer " + std::to_string(at.layer);
  for (const std::uint32_t curve : at.curves) name += ", curve " + std::to_string(curve);
  return name;
}

Picture picture_of(const PatchLayer& layer) {
  Picture picture;
  picture.layers.push_back(layer);
  return picture;
}

void expect_exact_frames(const Document& document, const Moving& at, const DiffuseOptions& options,
                         bool was_solved, bool holds_bound, std::mt19937& random) {
  Context context;
  const LayerSight sight = sight_of_layer(document, at.layer, document.artboard);
  std::optional<RefinedLayer> refined;
  PatchLayer shown;  // the last frame, or the solved layer
  if (was_solved) refined = refined_layer(context, document, at.layer, sight, options, &shown);
  const bool is_known = refined.has_value();
  Result<LayerSession> drag =
      LayerSession::open(context, input_of(document, at.layer, sight, options), at.curves, refined,
                         {.most_missed = 0, .holds_bound = holds_bound});
  if (!drag && drag.status().code == StatusCode::limit) return;
  ASSERT_TRUE(drag.ok()) << drag.status().message;
  EXPECT_EQ(refined.has_value(), is_known);
  EXPECT_EQ(drag->has_room(), !is_known);
  std::optional<FrameRows> rows = drag->take_rows_of_solved();  // rows of `shown`
  for (int frame = 0; frame < 5; ++frame) {
    SCOPED_TRACE("frame " + std::to_string(frame));
    const std::vector<Curve> curves = moved(document, at, 10, random);
    std::vector<Curve> both = curves;
    const std::vector<Curve>& first = document.layers[at.layer].curves;
    both.insert(both.end(), first.begin(), first.end());
    Comparison seen{both};
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
    Result<std::optional<FramePatches>> made =
        drag->frame(context, curves, {.wants_rows = rows.has_value(), .watch = watch});
    Context other;  // shares nothing with the earlier frames
    const Result<std::optional<FramePatches>> again = drag->frame(other, curves);
    EXPECT_EQ(other.budget.used(), 0u);
    ASSERT_TRUE(made.ok() && again.ok()) << made.status().message << again.status().message;
    ASSERT_EQ(made->has_value(), again->has_value());
    if (!*made) continue;
    FramePatches& patches = **made;
    if (patches.is_whole) {
      shown = std::move(patches.layer);
    } else {
      ASSERT_TRUE(drag->make_room(context, shown).ok());
      drag->write(patches, *rows, shown);
    }
    rows = std::move(patches.rows);
    EXPECT_EQ(test::difference_of(picture_of(shown), picture_of((*again)->layer)), "");
    EXPECT_LE(seen.worst, kMostDragMiss * static_cast<float>(at.curves.size()))
        << "at " << seen.place.x << ", " << seen.place.y;
  }
}

TEST(LayerSession, has_the_exact_values_at_all_nodes_of_its_frames) {
  for (std::uint64_t seed = 0; seed < kLayerSessionDocuments; ++seed) {
    const Document document = test::random_document(seed);
    std::mt19937 random(static_cast<std::uint32_t>(seed));
    DiffuseOptions options;
    options.max_error = seed % 2 == 0 ? 0 : 4;
    for (const Moving& at : some_curves(document, random)) {
      SCOPED_TRACE(name_of(seed, at));
      for (const bool was_solved : {false, true}) {
        const bool holds_bound = (seed / 2 % 2 == 0) == was_solved;
        SCOPED_TRACE(std::string(was_solved ? "solved" : "not solved") +
                     (holds_bound ? ", holds the bound" : ""));
        ASSERT_NO_FATAL_FAILURE(
            expect_exact_frames(document, at, options, was_solved, holds_bound, random));
      }
    }
  }
}

void expect_small_misses(const Document& document, const Moving& at, double most,
                         std::mt19937& random, int& missed) {
  Context context;
  const LayerSight sight = sight_of_layer(document, at.layer, document.artboard);
  DiffuseOptions options;
  options.max_error = 0;
  std::optional<RefinedLayer> refined = refined_layer(context, document, at.layer, sight, options);
  const LayerInput input = input_of(document, at.layer, sight, options);
  Result<LayerSession> quick =
      LayerSession::open(context, input, at.curves, refined, {.most_missed = most});
  if (!quick && quick.status().code == StatusCode::limit) return;
  Result<LayerSession> slow =
      LayerSession::open(context, input, at.curves, refined, {.most_missed = 0});
  ASSERT_TRUE(quick.ok() && slow.ok()) << quick.status().message << slow.status().message;
  for (int frame = 0; frame < 3; ++frame) {
    std::vector<Curve> curves = moved(document, at, 20, random);
    if (random() % 3 == 0) curves.back().weight *= 20;
    const Result<std::optional<FramePatches>> about_result = quick->frame(context, curves);
    const Result<std::optional<FramePatches>> exact_result = slow->frame(context, curves);
    ASSERT_TRUE(about_result.ok() && exact_result.ok());
    if (!*about_result) continue;
    const FramePatches *about = &**about_result, *exact = &**exact_result;
    // A border lies where it is seen, and triangles cut there have other nodes.
    if (about->layer.color.triangle_node != exact->layer.color.triangle_node) continue;
    const float miss = test::largest_difference(about->layer.color, exact->layer.color);
    EXPECT_LE(miss, 1.5 * most + kMostDragMiss) << "frame " << frame;
    missed += miss > 0;
  }
}

TEST(LayerSession, misses_no_more_than_it_may) {
  int missed = 0;
  for (std::uint64_t seed = 0; seed < kLayerSessionDocuments; ++seed) {
    const Document document = test::random_document(seed);
    std::mt19937 random(static_cast<std::uint32_t>(seed));
    const double most = seed % 2 == 0 ? 0.02 : 0.2;
    for (const Moving& at : some_curves(document, random)) {
      SCOPED_TRACE(name_of(seed, at));
      ASSERT_NO_FATAL_FAILURE(expect_small_misses(document, at, most, random, missed));
    }
  }
  EXPECT_GT(missed, 0) << "nothing was left as it was";
}

}  // namespace
}  // namespace sfumato::solve
