#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "curves/attributes.hpp"
#include "gather/gather.hpp"
#include "gather/scene/share_bound.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/function_ref.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"
#include "solve/fields/border.hpp"
#include "solve/fields/frame_time.hpp"
#include "solve/fields/layout_update.hpp"
#include "solve/fields/miss_search.hpp"
#include "solve/fields/nodes.hpp"
#include "solve/fields/seams.hpp"

namespace sfumato::solve {

/// One attribute of a layer, ready to be gathered.
struct PreparedField {
  curves::SegmentAttributes attributes;
  TableMemory memory;  ///< of the attributes
  gather::Gatherer gatherer;
  bool is_thinned = false;  ///< the gatherer's mesh lacks edges of the layer's visibility mesh
};

/// The nodes of a field whose layer was solved, kept for those who edit it.
struct RefinedField {
  NodeLayout layout;
  std::vector<std::uint8_t> node_hit;     ///< as FieldSolver's
  std::vector<std::uint32_t> node_place;  ///< as FieldSolver's
  std::vector<float> vertex_radius;       ///< as FieldSolver's
  TableMemory memory{"a solved layer"};
  std::optional<Seams> seams{};  ///< of the layer's patch mesh
};

/// A field's tables as a frame of a drag left them: those of the field that it began from, but for
/// what the frame changed, which the next frame takes back.
struct FieldFrame {
  std::optional<PreparedField> field{};
  std::optional<Seams> seams{};
  std::vector<float> vertex_radius{};  ///< as FieldSolver's
  NodeLayout layout{};
  LayoutHistory history{};
  std::vector<std::uint8_t> node_hit{};   ///< as FieldSolver's
  std::vector<std::uint32_t> gathered{};  ///< nodes, or their values are those of a frame before
  std::vector<std::uint32_t> left{};      ///< as FieldSolver's
  TableMemory layout_memory{"patches"};
  TableMemory memory{"patches"};  ///< of the rest
};

/// Values of free nodes in the frame before, where that gathered them.
struct LastValues {
  std::vector<std::uint32_t> node{};  ///< ascending
  std::vector<float> value{};
  std::vector<std::uint8_t> hit{};  ///< as FieldSolver's
  TableMemory memory{"patches"};
};

/// Which nodes of a frame may wait, and how they are ordered.
struct FrameLimit {
  FrameTime time;
  const gather::ShareBound& share;  ///< of the curve that is inserted
};

/// The nodes of a field on another mesh, from which this one was edited.
struct KnownNodes {
  const NodeLayout& layout;
  std::span<const std::uint8_t> node_hit;  ///< as FieldSolver's
  const PreparedField& field;
};

/// Solves one attribute, or colour and opacity as one, on the patch mesh of its layer, which
/// LayerSolver refines. Keeps the node values up to date with the mesh from round to round, and
/// finds the patches' errors.
class FieldSolver {
 public:
  /// keeps_places   of the nodes in the visibility mesh, for copy_nodes() and release()
  explicit FieldSolver(PreparedField prepared, bool keeps_places = false)
      : field_(std::move(prepared)), keeps_places_(keeps_places) {}

  /// Begins with a mesh, which must outlive this, and finds the values that curves show on it.
  /// Errors: limit (memory), cancelled.
  Status start(Context& context, const mesh::TriangleMesh& mesh);

  /// Lays out the nodes and lists all free ones to be gathered. Reserves room for `spare` more
  /// triangles. Errors: limit (memory), cancelled.
  Status lay_out(Context& context, const mesh::TriangleMesh& mesh, std::size_t spare = 0);

  /// Follows the mesh, of which the triangles in `changed` (ascending, including new ones) have
  /// changed. If the nodes are laid out, they are updated: free nodes of other triangles keep their
  /// values, the rest is listed to be gathered.
  /// Errors   limit (memory), cancelled; this object is unusable then
  Status follow(Context& context, const mesh::TriangleMesh& mesh,
                std::span<const std::uint32_t> changed);

  /// After lay_out: takes over what `before`, whose mesh this one was edited from, knows of nodes
  /// that stand where they stood and that watched segments or free ends of neither reach. The rest
  /// stays listed to be gathered.
  /// kept     per triangle of the mesh of `before`: which of this mesh it is, or mesh::kNone
  /// bound    of what was inserted, or null: nodes at which it holds keep their values
  /// Errors   limit (memory), cancelled
  Status carry_over(Context& context, const KnownNodes& before, std::span<const std::int32_t> kept,
                    const gather::ShareBound* bound);
  KnownNodes known() const { return {layout_, node_hit_, field_}; }

  /// Clears is_known[t] where a node of the triangle is listed to be gathered. Errors: limit
  /// (memory), cancelled.
  Status clear_asked(const Context& context, std::span<std::uint8_t> is_known) const;

  /// In place of start(): on a copy of the mesh of `before`, which has been laid out. Errors: limit
  /// (memory), cancelled.
  /// frame      what the last frame left on this mesh, or nothing
  /// changed    the triangles that it changed
  /// remembers  its values, for nodes that wait
  Status start_from(const Context& context, const FieldSolver& before,
                    const mesh::TriangleMesh& mesh, FieldFrame frame,
                    std::span<const std::uint32_t> changed, bool remembers);

  /// In place of lay_out(), after start_from() and follow() of what was changed then: takes over
  /// the layout of `before`, whose nodes were gathered and located, and follows those changes.
  /// Nodes keep their numbers and values; those that are new, and those that watched segments or
  /// free ends of either may reach, are listed to be gathered.
  /// changed   what follow() was told, and all triangles around the vertices of edges that have
  ///           become constrained
  /// is_same   as gather::KnownPlaces
  /// bound     as there: nodes at which it holds keep their values
  /// waiting   unless null: nodes that have a value already are left to gather_left(), those first
  ///           that the curve, by this bound, may change most
  /// Errors    limit (memory), cancelled
  Status lay_out_from(Context& context, const FieldSolver& before, const mesh::TriangleMesh& mesh,
                      std::span<const std::uint32_t> changed, std::span<const std::uint8_t> is_same,
                      const gather::ShareBound* bound, const gather::ShareBound* waiting);

  /// In place of all that is above: goes on with what release_frame() gave.
  void resume(FieldFrame frame);

  /// Gathers nodes that were left, until the time is over, and returns their number. Those that
  /// remain show the value of the frame before, where that is known, or that without the curve.
  /// advances   even if the time is over already
  /// Errors     limit (memory), cancelled
  Result<std::size_t> gather_left(Context& context, const FrameTime& time, bool advances);

  /// Ends the frame's gather: nodes that remain with the value of the frame before count as
  /// gathered. Errors: limit (memory), cancelled.
  Status count_shown(const Context& context);

  std::size_t left_count() const { return left_.size(); }

  /// In place of start(), before follow(): on a copy of a mesh whose seams and radii are known.
  /// Errors: limit (memory), cancelled.
  Status start_from(const Context& context, const RefinedField& known,
                    const mesh::TriangleMesh& mesh);

  /// In place of lay_out(), where segments were taken out of the mesh since, for others to
  /// lay_out_from() this: takes over the nodes that are known from before that, and follows the
  /// change. Nodes keep their numbers, and their values but for those that are new and those that
  /// watched segments or free ends of either may reach: these are listed to be gathered.
  /// known     of the mesh with these segments, with the places of the nodes
  /// with      the field with them, which are watched
  /// changed   as for lay_out_from(): triangles of the mesh
  /// is_same   as gather::KnownPlaces, for this field and that one
  /// bound     of the segments, or null: nodes at which it holds keep their values, and the weights
  ///           that they have with these
  /// Errors    limit (memory), cancelled
  Status lay_out_without(Context& context, const RefinedField& known, const PreparedField& with,
                         const mesh::TriangleMesh& mesh, std::span<const std::uint32_t> changed,
                         std::span<const std::uint8_t> is_same, const gather::ShareBound* bound);

  /// After lay_out_from() and gather(), where nothing else was done: what the next frame may begin
  /// from.
  FieldFrame release_frame();

  /// Adds what release_frame() will list, or what lay_out_without() and gather() changed: triangles
  /// that have other nodes than in the field from which this was laid out, and nodes that are
  /// others or have other values, some of them twice. Errors: limit (memory), cancelled.
  Status list_rows(const Context& context, TableMemory& memory,
                   std::vector<std::uint32_t>& triangles, std::vector<std::uint32_t>& nodes) const;

  /// Gives up what list_rows() asks for.
  void forget_rows() {
    history_.free(layout_memory_);
    memory_.free(to_gather_);
  }

  /// What copy_nodes() takes.
  std::size_t bytes_of_nodes() const;

  /// A copy of the nodes and their values, without seams. Errors: limit (memory), cancelled.
  Result<RefinedField> copy_nodes(const Context& context) const;

  /// Moves the nodes out, without seams.
  RefinedField release();

  /// Moves field and seams out. Call last.
  PreparedField release_field() { return std::move(field_); }
  Seams release_seams() { return std::move(*seams_); }

  /// After lay_out: takes over what is known of nodes of the same mesh, gathered from the same
  /// curves with the same values. Nodes that have, or may have, a response
  /// (curves::SegmentAttributes) stay listed to be gathered.
  /// known          the nodes' values are in channels `first_channel` and following
  /// base_channels  of `known`
  /// Errors         limit (memory), cancelled
  Status take_over(Context& context, const RefinedField& known, int first_channel,
                   int base_channels);

  /// Whether another's layout can be taken over.
  bool has_channels_of(const FieldSolver& other) const { return has_channels_of(other.field_); }

  /// Numbers the nodes as lay_out would now. Call once, after the last `follow`.
  Status put_in_order(Context& context, const mesh::TriangleMesh& mesh);

  /// Gathers the free nodes whose value is not known yet, or all free nodes, and returns their
  /// number.
  /// Errors: limit, cancelled.
  Result<std::size_t> gather(Context& context, const gather::GatherOptions& options, bool all);

  /// Sets misses[t] for those of `triangles` (ascending) whose patches miss, and for their
  /// neighbours where that happens on the common edge. Errors: limit (memory), cancelled.
  Status find_misses(Context& context, const mesh::TriangleMesh& mesh,
                     std::span<const std::uint32_t> triangles, const MissLimit& limit,
                     std::span<std::uint8_t> misses) const;

  /// Sets coarse[t] for those of `triangles` at a blurred curve whose longest edge exceeds
  /// edge_per_radius times the blur radius there, whose nodes are too far apart to resolve the
  /// transition.
  /// triangles   all in the first call, then those that changed
  /// Errors      limit (memory), cancelled
  Status find_coarse(Context& context, const mesh::TriangleMesh& mesh,
                     std::span<const std::uint32_t> triangles, double edge_per_radius,
                     std::span<std::uint8_t> coarse);

  /// Sets seen[i] to 0 where no curve is seen from points[i], and leaves it unchanged elsewhere.
  /// Errors: limit, cancelled.
  Status look(Context& context, std::span<const Vec2> points, std::span<std::uint8_t> seen) const;

  /// Adds the parts of triangles that were cut, after the triangles of the mesh; their new nodes
  /// are listed to be gathered. Errors: limit (memory), cancelled.
  Status add_parts(Context& context, const BorderCuts& cuts);

  /// Where the border of the region that sees a curve crosses a triangle, its nodes beyond the
  /// border have no value; in this triangle they take the mean of the others. Nodes of triangles
  /// that see no curve at all stay 0. Call last, after all queries below. Errors: limit (memory),
  /// cancelled.
  Status fill_unseen_nodes(Context& context);

  /// The values that the sides of curves show on the mesh.
  const Seams& seams() const { return *seams_; }

  const PreparedField& field() const { return field_; }
  int channel_count() const { return field_.attributes.channel_count(); }
  const NodeLayout& layout() const { return layout_; }
  /// Whether a triangle's node (places as in PatchLayer) sees a curve.
  bool sees_curves(std::uint32_t triangle, std::size_t place = 9) const;
  bool sees_curves_everywhere() const;
  /// The largest value of the channels from `first_channel` on at the triangle's nodes, but at most
  /// `enough`.
  float largest_value(std::uint32_t triangle, std::size_t first_channel, float enough) const;

  /// Moves out the field of the triangles with keep[t], in their order.
  PatchField take(std::span<const std::uint8_t> keep);

  /// The same as a copy, allocated from `memory`. Errors: limit (memory), cancelled.
  Result<PatchField> copy(const Context& context, std::span<const std::uint8_t> keep,
                          TableMemory& memory) const;

 private:
  /// As copy_values(), which lists the nodes in `carried`.
  Status copy_known(const Context& context, const RefinedField& known, int first_channel,
                    int base_channels, std::span<std::uint8_t> asks,
                    std::vector<std::uint32_t>& carried);
  Status size_places(const Context& context);
  /// Whether some of a triangle's nodes see a curve and others do not.
  bool sees_some(const std::uint32_t* node) const;
  Status make_room_for_means(Context& context);
  /// Lists all free nodes, in a list that is allocated from `memory`.
  Status list_free_nodes(const Context& context, TableMemory& memory,
                         std::vector<std::uint32_t>& free) const;
  /// Per node: 1 for those that are listed to be gathered.
  Result<std::vector<std::uint8_t>> asked_nodes(const Context& context, TableMemory& memory) const;
  /// Takes the nodes without asks[node] off that list.
  void keep_asked(std::span<const std::uint8_t> asks) {
    std::erase_if(to_gather_, [&](std::uint32_t node) { return !asks[node]; });
  }
  Status copy_layout(const Context& context, const NodeLayout& from,
                     std::span<const std::uint8_t> node_hit, std::size_t changed);
  /// Makes the nodes of the last frame those of `before` again.
  Status take_back_nodes(const Context& context, const FieldSolver& before,
                         std::span<const std::uint32_t> changed);
  Status remember_values(const Context& context, const FieldFrame& frame, std::size_t nodes);
  Status order_left(const Context& context, const FieldSolver& before,
                    const gather::ShareBound& share);
  Status gather_last_of_left(Context& context, std::size_t count);
  bool show_last_value(std::uint32_t node, std::size_t& at);
  /// Lists in to_gather_ the free nodes of `old` that the update met and that do not stand where
  /// they stood. Those that do count as not met from here on.
  Status list_moved(const Context& context, const NodeLayout& old);
  /// Finds where the free nodes lie that did not lie there before, or whose triangle is no more.
  Status locate_nodes(Context& context, const RefinedField& known,
                      std::span<const std::uint8_t> is_same);
  /// Lists in `changed` nodes of `without` whose values are others with the watched segments.
  static Status list_changed(Context& context, const PreparedField& with,
                             const FieldSolver& without, std::span<const std::uint8_t> is_same,
                             const gather::ShareBound* bound, TableMemory& memory,
                             std::vector<std::uint32_t>& changed);
  /// Adds those to `listed`.
  Status list_to_gather(Context& context, const PreparedField& with, const FieldSolver& without,
                        std::span<const std::uint8_t> is_same, const gather::ShareBound* bound,
                        std::vector<std::uint32_t>& listed);
  /// Copies values of nodes of `before` that are at the same place, free in both, lists these in
  /// `carried` and clears asks[node]. Errors: limit (memory), cancelled.
  bool has_channels_of(const PreparedField& other) const;
  Status copy_values(const Context& context, const KnownNodes& before,
                     std::span<const std::int32_t> kept, std::span<std::uint8_t> asks,
                     TableMemory& memory, std::vector<std::uint32_t>& carried);

  PreparedField field_;
  std::optional<Seams> seams_;
  std::vector<float> vertex_radius_;  ///< for find_coarse
  NodeLayout layout_;
  TableMemory layout_memory_{"patches"};
  LayoutHistory history_;
  std::vector<std::uint32_t> to_gather_;  ///< free nodes whose value is not known
  /// Of a frame: nodes that have the value of a frame before, those last that are gathered first.
  std::vector<std::uint32_t> left_;
  std::size_t shown_left_ = 0;  ///< of those, the first ones, that show the last frame's value
  LastValues last_;
  std::vector<std::uint8_t> node_hit_;  ///< 0 where a free node sees no curve
  gather::PointPlaces free_place_;      ///< where the free nodes lie; empty: unknown
  bool keeps_places_;
  /// Per node, if they are kept: the triangle of the visibility mesh in which it was gathered.
  std::vector<std::uint32_t> node_place_;
  std::optional<FieldFrame> frame_;  ///< from start_from() on; until lay_out_from() with all
  TableMemory memory_{"patches"};    ///< for lists of nodes, node_hit_, node_place_, vertex_radius_
};

/// Moves one channel out of a field into a field of its own over the same nodes, allocated from
/// `memory`. Errors: limit (memory), cancelled; the field is unusable then.
Result<PatchField> split_channel(const Context& context, PatchField& field, int channel,
                                 TableMemory& memory);

}  // namespace sfumato::solve
