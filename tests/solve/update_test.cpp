#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "solve/layers/layer_solver.hpp"
#include "solve/layers/prepare_layer.hpp"
#include "solve/same_layout.hpp"
#include "support/cancel_at.hpp"
#include "support/drawing.hpp"
#include "support/random_document.hpp"
#include "support/same_mesh.hpp"

/// Nodes that are updated with a mesh from round to round equal newly laid out nodes.
namespace sfumato::solve {
namespace {

PreparedLayer prepared(Context& context, const Document& document, std::uint32_t layer,
                       const DiffuseOptions& options = {}) {
  const LayerSight sight = sight_of_layer(document, layer, document.artboard);
  Result<PreparedLayer> prepared =
      prepare_layer(context, document, layer, sight, options, nullptr, LayerUse::patches);
  EXPECT_TRUE(prepared.ok()) << prepared.status().message;
  return std::move(*prepared);
}

/// A mesh and its fields, refined at random places.
class Followers {
 public:
  Followers(Context& context, PreparedLayer prepared)
      : context_(context), mesher_(std::move(prepared.mesher)) {
    smallest_edge_ = prepared.smallest_edges.missed;
    fields_.emplace_back(std::move(prepared.color));
    if (prepared.opacity) fields_.emplace_back(std::move(*prepared.opacity));
    EXPECT_TRUE(mesher_.refine(context_).ok());
    mesh_ = *mesher_.patch_mesh(context_);
    for (FieldSolver& field : fields_) EXPECT_TRUE(field.start(context_, mesh_).ok());
  }

  void refine_some(std::mt19937& random) {
    const std::uint32_t share = 2 + random() % 30;
    std::vector<std::uint32_t> triangles;
    for (std::uint32_t t = 0; t < mesh_.triangle_count(); ++t) {
      if (random() % share == 0) triangles.push_back(t);
    }
    EXPECT_TRUE(mesher_.refine_triangles(context_, triangles, smallest_edge_).ok());
    ASSERT_TRUE(mesher_.update_patch_mesh(context_, mesh_, memory_, changed_).ok());
  }

  Status follow(Context& context) {
    Status status = ok_status();
    for (FieldSolver& field : fields_)
      if (status) status = field.follow(context, mesh_, changed_);
    return status;
  }

  void lay_out_and_gather() {
    for (FieldSolver& field : fields_) {
      ASSERT_TRUE(field.lay_out(context_, mesh_).ok());
      ASSERT_TRUE(field.gather(context_, {}, false).ok());
    }
  }

  void expect_as_laid_out_anew() {
    const mesh::TriangleMesh anew = *mesher_.patch_mesh(context_);
    ASSERT_EQ(test::difference_of(mesh_, anew), "");
    for (const FieldSolver& field : fields_) {
      ASSERT_EQ(
          difference_from_new_layout(context_, anew, field.field().attributes, field.layout()), "");
    }
  }

  /// Gathers new nodes. Free nodes of unchanged triangles keep their values.
  void expect_to_keep_values(const std::vector<NodeLayout>& before) {
    std::vector<std::uint8_t> is_changed(mesh_.triangle_count(), 0);
    for (const std::uint32_t t : changed_) is_changed[t] = 1;
    for (std::size_t f = 0; f < fields_.size(); ++f) {
      ASSERT_TRUE(fields_[f].gather(context_, {}, false).ok());
      const NodeLayout &old = before[f], &now = fields_[f].layout();
      const auto channels = static_cast<std::size_t>(now.channel_count);
      for (std::size_t i = 0; i < now.triangle_node.size(); ++i) {
        const std::uint32_t node = now.triangle_node[i];
        if (is_changed[i / 10] || now.is_fixed[node]) continue;
        const float* value = now.value.data() + channels * node;
        ASSERT_TRUE(std::equal(value, value + channels,
                               old.value.data() + channels * old.triangle_node[i]));
      }
    }
  }

  /// Expects gathered values in free nodes that only changed triangles have. The last bits depend
  /// on the packets of points in which they are gathered.
  void expect_new_values_of_the_gather() {
    std::vector<std::uint8_t> is_changed(mesh_.triangle_count(), 0);
    for (const std::uint32_t t : changed_) is_changed[t] = 1;
    for (const FieldSolver& field : fields_) {
      const NodeLayout& layout = field.layout();
      const auto channels = static_cast<std::size_t>(layout.channel_count);
      std::vector<std::uint8_t> is_old(layout.node_count(), 0);
      for (std::size_t i = 0; i < layout.triangle_node.size(); ++i)
        is_old[layout.triangle_node[i]] |= !is_changed[i / 10];
      std::vector<float> values(channels * layout.node_count());
      std::vector<std::uint8_t> hits(layout.node_count());
      ASSERT_TRUE(field.field().gatherer.gather(context_, layout.position, {}, values, hits).ok());
      for (std::uint32_t i = 0; i < layout.triangle_node.size(); ++i) {
        const std::uint32_t node = layout.triangle_node[i];
        if (layout.is_fixed[node] || is_old[node]) continue;
        ASSERT_EQ(field.sees_curves(i / 10, i % 10), hits[node] != 0) << "node " << node;
        for (std::size_t c = 0; c < channels; ++c)
          ASSERT_NEAR(layout.value[channels * node + c], values[channels * node + c], 1e-3f);
      }
    }
  }

  std::vector<NodeLayout> layouts() const {
    std::vector<NodeLayout> layouts;
    for (const FieldSolver& field : fields_) layouts.push_back(field.layout());
    return layouts;
  }

  std::uint32_t triangle_count() const { return mesh_.triangle_count(); }

 private:
  Context& context_;
  mesh::Mesher mesher_;
  mesh::TriangleMesh mesh_;
  double smallest_edge_;
  std::vector<FieldSolver> fields_;
  TableMemory memory_{"a test"};
  std::vector<std::uint32_t> changed_;
};

TEST(LayoutUpdate, after_every_round_it_is_the_layout_of_the_mesh_as_it_is) {
  int rounds = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Document document = test::random_document(seed);
    for (std::uint32_t layer = 0; layer < document.layers.size(); ++layer) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", layer " + std::to_string(layer));
      if (document.layers[layer].curves.empty()) continue;
      if (sight_of_layer(document, layer, document.artboard).viewport.empty()) continue;
      Context context;
      std::mt19937 random(static_cast<std::uint32_t>(seed));
      Followers followers(context, prepared(context, document, layer));
      // As for blurs, before there are nodes.
      ASSERT_NO_FATAL_FAILURE(followers.refine_some(random));
      ASSERT_TRUE(followers.follow(context).ok());
      ASSERT_NO_FATAL_FAILURE(followers.lay_out_and_gather());
      for (int round = 0; round < 4 && followers.triangle_count() < 20'000; ++round, ++rounds) {
        const std::vector<NodeLayout> before = followers.layouts();
        ASSERT_NO_FATAL_FAILURE(followers.refine_some(random));
        ASSERT_TRUE(followers.follow(context).ok());
        ASSERT_NO_FATAL_FAILURE(followers.expect_to_keep_values(before));
        ASSERT_NO_FATAL_FAILURE(followers.expect_as_laid_out_anew());
        ASSERT_NO_FATAL_FAILURE(followers.expect_new_values_of_the_gather());
      }
    }
  }
  EXPECT_GT(rounds, 100);
}

TEST(LayoutUpdate, whichever_look_sees_the_flag_the_answer_is_cancelled) {
  const Document document = test::one_layer(
      {test::colored(test::straight_curve({10, 10}, {90, 80}), test::kRed, test::kBlue),
       test::colored(test::straight_curve({20, 80}, {70, 9}), test::kWhite, test::kBlack)});
  bool is_done = false;
  std::uint64_t polls = 0;
  for (std::uint64_t k = 1; !is_done; k += 1 + k / 8) {
    Context context;
    std::mt19937 random(7);
    Followers followers(context, prepared(context, document, 0));
    ASSERT_NO_FATAL_FAILURE(followers.lay_out_and_gather());
    ASSERT_NO_FATAL_FAILURE(followers.refine_some(random));
    Context cancelled;
    test::CancelAt watch(k, cancelled.cancel);
    cancelled.poll_watch = &watch;
    const Status status = followers.follow(cancelled);
    is_done = !cancelled.cancel;
    EXPECT_EQ(status.code, is_done ? StatusCode::ok : StatusCode::cancelled) << k;
    polls = k;
  }
  EXPECT_GT(polls, 50u);
}

/// A blur finer than all rounds of refinement reach: nothing depends on the last round's result.
TEST(LayoutUpdate, nodes_are_laid_out_on_the_mesh_of_the_last_round_for_blur) {
  constexpr float kRadius = 4e-3f;
  const DiffuseOptions options{.pixels_per_unit = 2000, .max_error = 0};
  const Document document = test::one_layer({test::blurred(
      test::colored(test::straight_curve({10, 10}, {90, 80}), test::kWhite, test::kBlack),
      kRadius)});
  Context context;
  int rounds = 0;
  const auto watch = [&](const mesh::TriangleMesh& mesh, const FieldSolver& color,
                         const FieldSolver*) {
    const auto& attributes = color.field().attributes;
    const Result<Seams> seams = Seams::create(context, mesh, attributes);
    TableMemory memory("a test");
    const auto anew = lay_out_nodes(context, mesh, attributes, *seams, memory);
    EXPECT_EQ(difference_of(color.layout(), *anew), "");
    double longest = 0;
    for (std::uint32_t h = 0; h < mesh.half_edge_twin.size(); ++h) {
      const Vec2 along =
          mesh.vertex_position[mesh.target(h)] - mesh.vertex_position[mesh.origin(h)];
      if (seams->blur_radius(h, 0) > 0) longest = std::max(longest, length(along));
    }
    EXPECT_GT(longest, 4 * kRadius) << "the rounds came to an end by themselves";
    ++rounds;
  };
  LayerSolver solver(context, prepared(context, document, 0, options), options, nullptr, watch);
  EXPECT_TRUE(solver.solve().ok());
  EXPECT_EQ(rounds, 1);
}

}  // namespace
}  // namespace sfumato::solve
