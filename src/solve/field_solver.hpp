#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "curves/attributes.hpp"
#include "gather/gather.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/function_ref.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"
#include "solve/border.hpp"
#include "solve/layout_update.hpp"
#include "solve/nodes.hpp"
#include "solve/probes.hpp"
#include "solve/seams.hpp"

namespace sfumato::solve {

/// One attribute of a layer, ready to be gathered.
struct PreparedField {
  curves::SegmentAttributes attributes;
  TableMemory memory;  ///< of the attributes
  gather::Gatherer gatherer;
};

/// The channel of opacity in a field of colour and opacity.
inline constexpr int kOpacityChannel = 3;

/// Solves one attribute, or colour and opacity as one, on the patch mesh of its layer, which
/// LayerSolver refines: node values that follow the mesh from round to round, and what they miss.
class FieldSolver {
 public:
  explicit FieldSolver(PreparedField prepared) : field_(std::move(prepared)) {}

  /// Begins with a mesh, which must outlive this: what curves show on it. Errors: limit (memory),
  /// cancelled.
  Status start(Context& context, const mesh::TriangleMesh& mesh);

  /// Lays out the nodes; all free ones are left to gather. There is room for `spare` triangles
  /// more. Errors: limit (memory), cancelled.
  Status lay_out(Context& context, const mesh::TriangleMesh& mesh, std::size_t spare = 0);

  /// Follows the mesh, of which the triangles of `changed` (ascending, new ones among them) are not
  /// what they were. If the nodes are laid out, they are updated: free nodes of other triangles
  /// keep their values, the rest is left to gather.
  /// Errors   limit (memory), cancelled: nothing else can be asked then
  Status follow(Context& context, const mesh::TriangleMesh& mesh,
                std::span<const std::uint32_t> changed);

  /// Numbers the nodes as lay_out would do it now. Comes after the last `follow`, and once.
  Status put_in_order(Context& context, const mesh::TriangleMesh& mesh);

  /// Gathers the free nodes whose value is not known yet, or all of them, and says how many.
  /// Errors: limit, cancelled.
  Result<std::size_t> gather(Context& context, const gather::GatherOptions& options, bool all);

  /// Sets misses[t] for those of some triangles (ascending) whose patch misses the exact gather by
  /// more than max_error (of code values from 0 to 1, or of a share of a shader), and for their
  /// neighbours where the miss lies on the common edge.
  /// color_weight   what a miss of a colour counts in a triangle, at most 1
  Status find_misses(Context& context, const mesh::TriangleMesh& mesh,
                     std::span<const std::uint32_t> triangles, float max_error, PatchOrder order,
                     FunctionRef<float(std::uint32_t triangle)> color_weight,
                     std::span<std::uint8_t> misses) const;

  /// Sets coarse[t] for those of some triangles at a blurred curve whose longest edge is longer
  /// than edge_per_radius times the blur radius there: their nodes could not tell its transition.
  /// triangles   all at first, then those that changed
  /// Errors      limit (memory), cancelled
  Status find_coarse(Context& context, const mesh::TriangleMesh& mesh,
                     std::span<const std::uint32_t> triangles, double edge_per_radius,
                     std::span<std::uint8_t> coarse);

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

  /// What the sides of curves show on the mesh.
  const Seams& seams() const { return *seams_; }

  const PreparedField& field() const { return field_; }
  int channel_count() const { return field_.attributes.channel_count(); }
  const NodeLayout& layout() const { return layout_; }
  /// Whether a triangle's node (places as in PatchLayer) sees a curve.
  bool sees_curves(std::uint32_t triangle, std::size_t place = 9) const;
  bool sees_curves_everywhere() const;
  /// The largest value of the channels from `first_channel` on at the triangle's nodes, or `enough`
  /// where it is at least that.
  float largest_value(std::uint32_t triangle, std::size_t first_channel, float enough) const;

  /// The field of the triangles with keep[t], in their order. Leaves nothing behind.
  PatchField take(std::span<const std::uint8_t> keep);

 private:
  /// Of some triangles those whose patches are to be held against the exact gather, in room from
  /// `memory`. Errors: limit (memory), cancelled.
  Result<std::vector<std::uint32_t>> find_doubtful(const Context& context,
                                                   std::span<const std::uint32_t> triangles,
                                                   float max_error, PatchOrder order,
                                                   FunctionRef<float(std::uint32_t)> color_weight,
                                                   TableMemory& memory) const;
  /// By how much the patch misses at probe i, for each channel; changes the exact value, too.
  void measure_miss(const ProbeSet& probes, std::size_t i, PatchOrder order, float* exact,
                    float* miss) const;
  /// Whether one of a value's misses, one a channel, is more than max_error where those of colours
  /// count color_weight, which is asked only if it matters.
  bool is_more(std::span<const float> miss, float max_error, std::uint32_t triangle,
               FunctionRef<float(std::uint32_t)> color_weight) const;
  bool is_opacity(std::size_t channel) const;
  /// Whether some of a triangle's nodes see a curve, and some do not.
  bool sees_some(const std::uint32_t* node) const;
  Status make_room_for_means(Context& context);
  /// Leaves all free nodes to gather.
  Status list_free_nodes(const Context& context);
  bool has_code_values() const;
  void show_as_code_values(float* value) const;

  PreparedField field_;
  std::optional<Seams> seams_;
  std::vector<float> vertex_radius_;  ///< of find_coarse
  NodeLayout layout_;
  TableMemory layout_memory_{"patches"};
  LayoutHistory history_;
  std::vector<std::uint32_t> to_gather_;  ///< free nodes whose value is not known
  std::vector<std::uint8_t> node_hit_;    ///< 0 where a free node sees no curve
  TableMemory memory_{"patches"};         ///< of these two and vertex_radius_
};

/// Takes one channel out of a field: a field of its own over the same nodes, in room from `memory`.
/// Errors: limit (memory), cancelled; the field is good for nothing then.
Result<PatchField> split_channel(const Context& context, PatchField& field, int channel,
                                 TableMemory& memory);

}  // namespace sfumato::solve
