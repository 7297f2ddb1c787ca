#include "solve/session/layer_response.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "curves/response.hpp"
#include "sfumato/base/color_space.hpp"
#include "solve/layers/layer_units.hpp"
#include "solve/refined_layer.hpp"
#include "support/drawing.hpp"
#include "support/random_document.hpp"
#include "support/sanitizers.hpp"
#include "support/soak.hpp"

/// How the nodes of a layer respond to the value of a stop.
namespace sfumato::solve {
namespace {

const auto kResponseDocuments =
    test::random_case_count<std::uint64_t>(SFUMATO_HAS_SANITIZER ? 6 : 24, 60);

/// Limit for the error of a prediction.
constexpr float kMostResponseMiss = 0.01f / 255;

/// A stop of a curve whose two sides do not become equal by its change.
struct Changed {
  StopPlace place;
  Document document;
  float shift[3] = {};
};

Side& side_of(Document& document, const StopPlace& place) {
  Curve& curve = document.layers[place.layer].curves[place.curve];
  return place.side == CurveSide::left ? curve.left : curve.right;
}

void change_color(std::mt19937& random, Changed& changed) {
  std::vector<Stop<Rgb>>& stops = side_of(changed.document, changed.place).color.stops.stops;
  const InterpolationSpace space = changed.document.interpolation;
  Rgb& color = stops[*changed.place.index].value;
  const Rgb from = from_srgb(space, color);
  const auto next = [&] { return static_cast<float>(random() % 1009) / 1009; };
  color = {next(), next(), next()};
  const Rgb to = from_srgb(space, color);
  changed.shift[0] = to.r - from.r, changed.shift[1] = to.g - from.g;
  changed.shift[2] = to.b - from.b;
}

void change_opacity(std::mt19937& random, Changed& changed) {
  std::vector<Stop<float>>& stops = side_of(changed.document, changed.place).opacity.stops.stops;
  float& opacity = stops[*changed.place.index].value;
  const float from = opacity;
  opacity = static_cast<float>(random() % 1009) / 1009;
  changed.shift[0] = opacity - from;
}

/// Returns all stops of a layer's curves.
std::vector<StopPlace> stops_of(const Document& document, std::uint32_t layer) {
  std::vector<StopPlace> places;
  const std::vector<Curve>& curves = document.layers[layer].curves;
  for (std::uint32_t c = 0; c < curves.size(); ++c) {
    for (const CurveSide side : {CurveSide::left, CurveSide::right}) {
      for (const StopAttribute attribute : {StopAttribute::color, StopAttribute::opacity}) {
        StopPlace place{layer, c, side, attribute, 0};
        for (; curves::has_stop(curves, place); ++*place.index) places.push_back(place);
      }
    }
  }
  return places;
}

/// The marks of fixed nodes.
struct RefinedMarks {
  std::vector<std::uint8_t> color, opacity;
};

/// Clears the values, so that none is reused. Returns the data for restoring them.
RefinedMarks forget_values(RefinedLayer& refined) {
  RefinedMarks marks;
  RefinedNodes& nodes = refined.nodes;
  const auto forget = [](RefinedField& field) {
    std::vector<std::uint8_t> all(field.layout.is_fixed.size(), 1);
    field.layout.is_fixed.swap(all);
    return all;
  };
  marks.color = forget(nodes.color);
  if (nodes.opacity) marks.opacity = forget(*nodes.opacity);
  return marks;
}

bool have_the_same_tables(const PatchField& a, const PatchField& b) {
  return a.channel_count == b.channel_count && a.triangle_node == b.triangle_node &&
         a.node_value.size() == b.node_value.size();
}

/// Precondition: have_the_same_tables.
float largest_miss(const PatchField& was, std::span<const float> factor,
                   std::span<const float> shift, const PatchField& is) {
  const auto channels = static_cast<std::size_t>(was.channel_count);
  float largest = 0;
  for (std::size_t i = 0; i < was.node_value.size(); ++i) {
    const float more = i % channels < shift.size() ? shift[i % channels] : 0;
    const float foretold = was.node_value[i] + (factor.empty() ? 0 : factor[i / channels] * more);
    largest = std::max(largest, std::fabs(foretold - is.node_value[i]));
  }
  return largest;
}

/// A stop of a random document whose layer was solved.
struct Sample {
  const Document& document;
  StopPlace place;
  LayerSight sight;
  DiffuseOptions options;
  std::optional<RefinedLayer> refined;

  bool is_color() const { return place.attribute == StopAttribute::color; }
  bool is_blurred() const {
    const Curve& curve = document.layers[place.layer].curves[place.curve];
    return !curve.left.blur_radius.empty() || !curve.right.blur_radius.empty();
  }
  /// The flattening of a blurred curve depends on its colours.
  bool has_polylines_of(Context& context, const Document& other) const {
    const LayerUnits units(document.artboard, sight, options);
    const auto is = flatten_layer(context, document.layers[place.layer], sight, units);
    const auto want = flatten_layer(context, other.layers[place.layer], sight, units);
    return is.ok() && want.ok() && is->vertex == want->vertex;
  }
  Result<LayerResponse> respond(Context& context, const Document& of) {
    return solve::respond(context, of, place, sight, options, refined);
  }
};

/// Calls `visit` for some stops of each layer of random documents.
template <class Visit>
void for_samples(Context& context, Visit visit) {
  for (std::uint64_t seed = 0; seed < kResponseDocuments; ++seed) {
    const Document document = test::random_document(seed);
    std::mt19937 random(static_cast<std::uint32_t>(seed));
    DiffuseOptions options;
    options.max_error = seed % 2 == 0 ? 0 : 4;
    for (std::uint32_t layer = 0; layer < document.layers.size(); ++layer) {
      const std::vector<StopPlace> places = stops_of(document, layer);
      const LayerSight sight = sight_of_layer(document, layer, document.artboard);
      if (places.empty() || sight.views.empty()) continue;
      Sample sample{
          document, {}, sight, options, refined_layer(context, document, layer, sight, options)};
      for (int i = 0; i < 3 && sample.refined; ++i) {
        sample.place = places[random() % places.size()];
        SCOPED_TRACE("document " + std::to_string(seed) + ", layer " + std::to_string(layer) +
                     ", curve " + std::to_string(sample.place.curve));
        ASSERT_NO_FATAL_FAILURE(visit(sample, random));
      }
    }
  }
}

/// Nodes that the stop does not reach keep their values in both. The others are gathered together,
/// because the windows that are too narrow to count depend on the neighbouring points.
TEST(LayerResponse, foretells_what_the_gather_finds) {
  Context context;
  std::size_t stops = 0, blurred = 0, nodes = 0;
  float worst = 0;
  for_samples(context, [&](Sample& sample, std::mt19937& random) {
    const Result<LayerResponse> was = sample.respond(context, sample.document);
    ASSERT_TRUE(was.ok()) << was.status().message;
    Changed changed{sample.place, sample.document};
    sample.is_color() ? change_color(random, changed) : change_opacity(random, changed);
    if (!sample.has_polylines_of(context, changed.document)) return;
    const Result<LayerResponse> is = sample.respond(context, changed.document);
    ASSERT_TRUE(is.ok()) << is.status().message;
    const std::span<const float> shift(changed.shift, sample.is_color() ? 3 : 1);
    ASSERT_TRUE(was->layer.triangle_vertex == is->layer.triangle_vertex);
    ASSERT_TRUE(have_the_same_tables(was->layer.color, is->layer.color));
    ASSERT_TRUE(have_the_same_tables(was->layer.opacity, is->layer.opacity));
    const std::vector<float> none;
    const float miss =
        std::max(largest_miss(was->layer.color, sample.is_color() ? was->factor : none, shift,
                              is->layer.color),
                 largest_miss(was->layer.opacity, sample.is_color() ? none : was->factor, shift,
                              is->layer.opacity));
    EXPECT_LE(miss, kMostResponseMiss);
    worst = std::max(worst, miss);
    ++stops;
    blurred += sample.is_blurred();
    nodes += was->factor.size();
  });
  EXPECT_GT(stops, 2 * kResponseDocuments);
  EXPECT_GT(blurred, kResponseDocuments / 4);
  EXPECT_GT(nodes, 100 * kResponseDocuments);
  RecordProperty("largest_miss_in_code_values", std::to_string(255 * worst));
}

TEST(LayerResponse, misses_no_node_that_answers) {
  Context context;
  std::size_t answering = 0, silent = 0;
  for_samples(context, [&](Sample& sample, std::mt19937&) {
    const Result<LayerResponse> some = sample.respond(context, sample.document);
    ASSERT_TRUE(some.ok()) << some.status().message;
    RefinedLayer& refined = *sample.refined;
    RefinedMarks marks = forget_values(refined);
    const Result<LayerResponse> all = sample.respond(context, sample.document);
    ASSERT_TRUE(all.ok()) << all.status().message;
    refined.nodes.color.layout.is_fixed.swap(marks.color);
    if (refined.nodes.opacity) refined.nodes.opacity->layout.is_fixed.swap(marks.opacity);
    if (some->factor.size() != all->factor.size()) return;  // another node sees nothing
    for (std::size_t node = 0; node < some->factor.size(); ++node) {
      ASSERT_GE(some->factor[node], -kMostResponseMiss);
      ASSERT_LE(some->factor[node], 1 + kMostResponseMiss);
      ++(some->factor[node] > 0 ? answering : silent);
      if (some->factor[node] == 0) {
        ASSERT_LE(all->factor[node], 1.0f / 255) << node;
      }
    }
  });
  EXPECT_GT(answering, 100 * kResponseDocuments);
  EXPECT_GT(silent, 100 * kResponseDocuments);
}

}  // namespace
}  // namespace sfumato::solve
