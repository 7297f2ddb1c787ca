#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/context.hpp"
#include "base/status.hpp"
#include "curves/attributes.hpp"
#include "gather/gather.hpp"
#include "patches/border.hpp"
#include "patches/nodes.hpp"
#include "patches/picture.hpp"
#include "patches/seams.hpp"

namespace sfumato::patches {

/// One attribute of a layer, ready to be gathered.
struct FieldScene {
  curves::SegmentAttributes attributes;
  ScopedCharge charge;  ///< of the attributes
  gather::Gatherer gatherer;
};

/// The channel of opacity in a field of colour and opacity.
inline constexpr int kOpacityChannel = 3;

/// Solves one attribute, or colour and opacity as one, on the patch mesh of its layer, which
/// LayerSolver refines: node values that follow the mesh from round to round, and what they miss.
class FieldSolver {
 public:
  explicit FieldSolver(FieldScene scene) : scene_(std::move(scene)) {}

  /// Lays out the nodes of `mesh` and carries known values over from triangles that stayed.
  /// previous_triangle   as Mesher::patch_mesh gives it
  /// Errors              limit
  Status follow(Context& context, const mesh::TriangleMesh& mesh,
                std::span<const std::int32_t> previous_triangle);

  /// Gathers the free nodes whose value is not known yet, or all of them, and says how many.
  /// Errors: limit, cancelled.
  Result<std::size_t> gather(Context& context, const gather::GatherOptions& options, bool all);

  /// Sets misses[t] for new triangles (is_new) whose patch misses the exact gather by more than
  /// max_error (of code values from 0 to 1, or of a share of a shader), and for their neighbours
  /// where the miss lies on the common edge.
  /// color_weight   per triangle: what a miss of a colour counts there; empty: 1
  Status find_misses(Context& context, const mesh::TriangleMesh& mesh,
                     std::span<const std::uint8_t> is_new, float max_error, PatchOrder order,
                     std::span<const float> color_weight, std::span<std::uint8_t> misses) const;

  /// Sets coarse[t] for triangles at a blurred curve whose longest edge is longer than
  /// edge_per_radius times the blur radius there: their nodes could not tell its transition.
  void find_coarse(const Context& context, const mesh::TriangleMesh& mesh, double edge_per_radius,
                   std::span<std::uint8_t> coarse) const;

  /// seen[i]: 0 where no curve is seen from points[i], else as it was. Errors: limit, cancelled.
  Status look(Context& context, std::span<const Vec2> points, std::span<std::uint8_t> seen) const;

  /// Adds the parts of triangles that were cut, after those of the mesh; their new nodes are left
  /// to gather. Errors: limit (memory), cancelled.
  Status add_parts(Context& context, const BorderCuts& cuts);

  /// Where a triangle lies across the border of what sees a curve, its nodes beyond the border have
  /// no value: in this triangle they take the mean of the others. Nodes of triangles that see
  /// nothing at all stay 0. Comes last, after the questions below were asked. Errors: limit
  /// (memory), cancelled.
  Status fill_unseen_nodes(Context& context);

  /// What the sides of curves show on a mesh. Incomplete where the context is cancelled.
  Seams seams(const Context& context, const mesh::TriangleMesh& mesh) const {
    return {context, mesh, scene_.attributes};
  }

  const FieldScene& scene() const { return scene_; }
  int channel_count() const { return scene_.attributes.channel_count(); }
  const NodeLayout& layout() const { return layout_; }
  /// Whether a triangle's node (places as in PatchLayer) sees a curve.
  bool sees_curves(std::uint32_t triangle, std::size_t place = 9) const;
  /// The largest value of the channels from `first_channel` on at the triangle's nodes.
  float largest_value(std::uint32_t triangle, std::size_t first_channel) const;

  /// The field of the triangles with keep[t], in their order. Leaves nothing behind.
  PatchField take(std::span<const std::uint8_t> keep);

 private:
  /// Of the new triangles those whose patches are to be held against the exact gather.
  Status find_doubtful(const Context& context, std::span<const std::uint8_t> is_new,
                       float max_error, PatchOrder order, std::span<const float> color_weight,
                       std::span<std::uint8_t> doubtful) const;
  /// The largest of a value's misses, one a channel, where those of colours count color_weight.
  float worst_miss(std::span<const float> miss, float color_weight) const;
  bool is_opacity(std::size_t channel) const;
  void carry_over(const Context& context, const NodeLayout& old_layout,
                  const std::vector<std::uint8_t>& old_hit,
                  std::span<const std::int32_t> previous_triangle);
  /// Whether some of a triangle's nodes see a curve, and some do not.
  bool sees_some(const std::uint32_t* node) const;
  Status make_room_for_means(Context& context);
  bool is_to_gather(std::uint32_t node, bool all) const;
  std::size_t count_to_gather(bool all) const;
  /// The memory of `count` points and their values.
  std::size_t point_bytes(std::size_t count) const;
  bool has_code_values() const;
  void show_as_code_values(float* value) const;

  FieldScene scene_;
  NodeLayout layout_;
  ScopedCharge layout_charge_;
  std::vector<std::uint8_t> node_known_;  ///< value gathered in an earlier round, or fixed
  std::vector<std::uint8_t> node_hit_;    ///< 0 where a free node sees no curve
};

/// Takes one channel out of a field: a field of its own over the same nodes.
PatchField split_channel(PatchField& field, int channel);

}  // namespace sfumato::patches
