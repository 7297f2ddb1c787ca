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
  TableMemory memory;  ///< for the attributes
  gather::Gatherer gatherer;
  bool is_thinned = false;  ///< the gatherer's mesh lacks edges of the layer's visibility mesh
};

/// The nodes of a field of a solved layer, kept for edits.
struct RefinedField {
  NodeLayout layout;
  std::vector<std::uint8_t> node_hit;     ///< as in FieldSolver
  std::vector<std::uint32_t> node_place;  ///< as in FieldSolver
  std::vector<float> vertex_radius;       ///< as in FieldSolver
  TableMemory memory{"a solved layer"};
  std::optional<Seams> seams{};  ///< of the layer's patch mesh
};

/// The tables of a field after a frame of a drag. The next frame restores the rows that this frame
/// changed; all other rows are equal to the rows of the base, the field where all frames begin.
struct FieldFrame {
  std::optional<PreparedField> field{};
  std::optional<Seams> seams{};
  std::vector<float> vertex_radius{};  ///< as in FieldSolver
  NodeLayout layout{};
  LayoutHistory history{};
  std::vector<std::uint8_t> node_hit{};   ///< as in FieldSolver
  std::vector<std::uint32_t> gathered{};  ///< as in FieldSolver
  std::vector<std::uint32_t> left{};      ///< as in FieldSolver
  TableMemory layout_memory{"patches"};
  TableMemory memory{"patches"};  ///< for the other tables
};

/// The values of free nodes that the last frame gathered.
struct LastValues {
  std::vector<std::uint32_t> node{};  ///< ascending
  std::vector<float> value{};
  std::vector<std::uint8_t> hit{};  ///< as in FieldSolver
  TableMemory memory{"patches"};
};

/// The time limit of a frame, and the bound that orders its deferred nodes.
struct FrameLimit {
  FrameTime time;
  const gather::ShareBound& share;  ///< of the inserted curve
};

/// The known nodes of a field on another version of the mesh.
struct KnownNodes {
  const NodeLayout& layout;
  std::span<const std::uint8_t> node_hit;  ///< as in FieldSolver
  const PreparedField& field;
};

/// Solves one attribute, or colour and opacity in one field, on the patch mesh of its layer.
/// LayerSolver refines this mesh; FieldSolver updates the nodes after each round, and finds the
/// patches that miss.
class FieldSolver {
 public:
  /// Makes a solver.
  /// keeps_places   keeps the nodes' triangles in the visibility mesh, for copy_nodes() and
  ///                release()
  explicit FieldSolver(PreparedField prepared, bool keeps_places = false)
      : field_(std::move(prepared)), keeps_places_(keeps_places) {}

  /// Begins with a mesh, which must outlive this, and finds its seams. Errors: limit (memory),
  /// cancelled.
  Status start(Context& context, const mesh::TriangleMesh& mesh);

  /// Lays out the nodes and lists all free nodes to be gathered. Reserves room for `spare` more
  /// triangles. Errors: limit (memory), cancelled.
  Status lay_out(Context& context, const mesh::TriangleMesh& mesh, std::size_t spare = 0);

  /// Updates the seams after a change of the mesh, and the nodes if they are laid out. Free nodes
  /// of unchanged triangles keep their values; the other free nodes are listed to be gathered.
  /// changed   the triangles that changed, including new ones, ascending
  /// Errors    limit (memory), cancelled; this object is unusable then
  Status follow(Context& context, const mesh::TriangleMesh& mesh,
                std::span<const std::uint32_t> changed);

  /// Copies known values after lay_out(), for nodes with the same position in both fields. Nodes
  /// that a watched segment or free end of either field may reach stay listed to be gathered.
  /// before   the field before an edit of the mesh
  /// kept     per triangle of the mesh of `before`: its index in this mesh, or mesh::kNone
  /// bound    of the inserted curve, or null: nodes at which it holds keep their values
  /// Errors   limit (memory), cancelled
  Status carry_over(Context& context, const KnownNodes& before, std::span<const std::int32_t> kept,
                    const gather::ShareBound* bound);
  KnownNodes known() const { return {layout_, node_hit_, field_}; }

  /// Sets marks[t] of triangles with a node that the edit gathered. Errors: limit (memory),
  /// cancelled.
  Status mark_gathered(const Context& context, std::span<std::uint8_t> marks) const;

  /// Locates the free nodes in the visibility mesh. Call this after lay_out_without(), if the nodes
  /// have changed since. Errors: limit (memory), cancelled.
  Status locate_all(Context& context);

  /// Replaces start(): begins with a copy of the mesh of `before`, whose nodes are laid out.
  /// Errors: limit (memory), cancelled.
  /// frame      the tables that the last frame left, or empty ones
  /// changed    the triangles that the last frame changed
  /// remembers  keeps values of the last frame, for deferred nodes
  Status start_from(const Context& context, const FieldSolver& before,
                    const mesh::TriangleMesh& mesh, FieldFrame frame,
                    std::span<const std::uint32_t> changed, bool remembers);

  /// Replaces lay_out() after start_from() and follow(): takes over the layout of `before`, whose
  /// nodes were gathered and located, and updates it. Nodes keep their numbers and values. New
  /// nodes, and nodes that a watched segment or free end of either field may reach, are listed to
  /// be gathered.
  /// changed   all triangles that follow() got, and all triangles around the vertices of edges that
  ///           became constrained
  /// is_same   as gather::KnownPlaces
  /// bound     as gather::KnownPlaces: nodes at which it holds keep their values
  /// waiting   unless null: defers nodes that have a value already to gather_left(). The nodes that
  ///           the curve may change most by this bound are gathered first
  /// Errors    limit (memory), cancelled
  Status lay_out_from(Context& context, const FieldSolver& before, const mesh::TriangleMesh& mesh,
                      std::span<const std::uint32_t> changed, std::span<const std::uint8_t> is_same,
                      const gather::ShareBound* bound, const gather::ShareBound* waiting);

  /// Replaces start_from() and lay_out_from(): continues with the result of release_frame().
  void resume(FieldFrame frame);

  /// Gathers deferred nodes until the time is over, and returns their number. The remaining nodes
  /// show their value in the last frame if it is known, or else their value without the curve.
  /// advances   gathers one batch even if the time is over already
  /// Errors     limit (memory), cancelled
  Result<std::size_t> gather_left(Context& context, const FrameTime& time, bool advances);

  /// Ends the gather of a frame: deferred nodes that show their value in the last frame now count
  /// as gathered. Errors: limit (memory), cancelled.
  Status count_shown(const Context& context);

  std::size_t left_count() const { return left_.size(); }

  /// Replaces start(): begins with a copy of a mesh whose seams and radii are known. Errors: limit
  /// (memory), cancelled.
  Status start_from(const Context& context, const RefinedField& known,
                    const mesh::TriangleMesh& mesh);

  /// Replaces lay_out() after segments were removed from the mesh: takes over the known layout and
  /// updates it. Nodes keep their numbers and values. New nodes, and nodes that a watched segment
  /// or free end of either field may reach, are listed to be gathered. Other solvers can then
  /// lay_out_from() this one.
  /// known     the nodes of the mesh with these segments, and their places
  /// with      the field with these segments, which are watched
  /// changed   triangles of the mesh, as in lay_out_from()
  /// is_same   as gather::KnownPlaces, for this field and `with`
  /// bound     of the segments, or null: nodes at which it holds keep their values and weights
  /// Errors    limit (memory), cancelled
  Status lay_out_without(Context& context, const RefinedField& known, const PreparedField& with,
                         const mesh::TriangleMesh& mesh, std::span<const std::uint32_t> changed,
                         std::span<const std::uint8_t> is_same, const gather::ShareBound* bound);

  /// Moves the tables out, for the next frame. Call this after lay_out_from() and gather(), if
  /// nothing else has changed the nodes.
  FieldFrame release_frame();

  /// Lists the rows that differ from the base of lay_out_from() or lay_out_without(). Adds to
  /// `triangles` the unchanged triangles that have other nodes. Adds to `nodes` the nodes that are
  /// new or may have another position or value. May list a row twice. Errors: limit (memory),
  /// cancelled.
  Status list_rows(const Context& context, TableMemory& memory,
                   std::vector<std::uint32_t>& triangles, std::vector<std::uint32_t>& nodes) const;

  /// Frees the lists that list_rows() reads.
  void forget_rows() {
    history_.free(layout_memory_);
    memory_.free(gathered_);
  }

  /// Returns the bytes of the tables that copy_nodes() copies.
  std::size_t bytes_of_nodes() const;

  /// Copies the nodes and their values, without seams. Errors: limit (memory), cancelled.
  Result<RefinedField> copy_nodes(const Context& context) const;

  /// Moves the nodes out, without seams.
  RefinedField release();

  /// Moves the field out. Call this and release_seams() last.
  PreparedField release_field() { return std::move(field_); }
  Seams release_seams() { return std::move(*seams_); }

  /// Copies known values after lay_out(), from nodes of the same mesh that were gathered from the
  /// same curves with the same values. Nodes that may have a response (curves::SegmentAttributes)
  /// stay listed to be gathered.
  /// first_channel  the first channel of `known` that belongs to this field
  /// base_channels  the number of base channels of `known`
  /// Errors         limit (memory), cancelled
  Status take_over(Context& context, const RefinedField& known, int first_channel,
                   int base_channels);

  /// Returns whether lay_out_from() can take over the layout of `other`.
  bool has_channels_of(const FieldSolver& other) const { return has_channels_of(other.field_); }

  /// Numbers the nodes as lay_out() would number them on the current mesh. Call this once, after
  /// the last follow(). Errors: limit (memory), cancelled.
  Status put_in_order(Context& context, const mesh::TriangleMesh& mesh);

  /// Gathers the listed nodes, or all free nodes, and returns their number. Errors: limit,
  /// cancelled.
  Result<std::size_t> gather(Context& context, const gather::GatherOptions& options, bool all);

  /// Sets misses[t] for the triangles in `triangles` (ascending) whose patches miss, and for their
  /// neighbours where that happens on the common edge. Errors: limit (memory), cancelled.
  Status find_misses(Context& context, const mesh::TriangleMesh& mesh,
                     std::span<const std::uint32_t> triangles, const MissLimit& limit,
                     std::span<std::uint8_t> misses) const;

  /// Sets coarse[t] for the triangles in `triangles` at a blurred curve whose longest edge exceeds
  /// edge_per_radius times the blur radius there. Their nodes are too far apart to resolve the
  /// transition.
  /// triangles   all triangles in the first call, then the triangles that changed
  /// Errors      limit (memory), cancelled
  Status find_coarse(Context& context, const mesh::TriangleMesh& mesh,
                     std::span<const std::uint32_t> triangles, double edge_per_radius,
                     std::span<std::uint8_t> coarse);

  /// Sets seen[i] to 0 where no curve is seen from points[i], and leaves it unchanged elsewhere.
  /// Errors: limit, cancelled.
  Status look(Context& context, std::span<const Vec2> points, std::span<std::uint8_t> seen) const;

  /// Adds the parts of triangles that were cut, after the triangles of the mesh. Lists their new
  /// nodes to be gathered. Errors: limit (memory), cancelled.
  Status add_parts(Context& context, const BorderCuts& cuts);

  /// Gives a value to nodes that see no curve in triangles that the border of the seen region
  /// crosses: in this triangle they get the mean of its other nodes. Nodes of triangles that see no
  /// curve at all stay 0. Call this last, after all queries below. Errors: limit (memory),
  /// cancelled.
  Status fill_unseen_nodes(Context& context);

  /// Returns the values on the sides of curves, on the mesh.
  const Seams& seams() const { return *seams_; }

  const PreparedField& field() const { return field_; }
  int channel_count() const { return field_.attributes.channel_count(); }
  const NodeLayout& layout() const { return layout_; }
  /// Returns whether a node of a triangle sees a curve; places as in PatchLayer.
  bool sees_curves(std::uint32_t triangle, std::size_t place = 9) const;
  bool sees_curves_everywhere() const;
  /// Returns the largest value of the channels from `first_channel` on at the triangle's nodes, at
  /// most `enough`.
  float largest_value(std::uint32_t triangle, std::size_t first_channel, float enough) const;

  /// Moves out the patches of the triangles with keep[t], in their order.
  PatchField take(std::span<const std::uint8_t> keep);

  /// Copies the same patches to tables from `memory`. Errors: limit (memory), cancelled.
  Result<PatchField> copy(const Context& context, std::span<const std::uint8_t> keep,
                          TableMemory& memory) const;

 private:
  /// Does the same as copy_values(), for take_over().
  Status copy_known(const Context& context, const RefinedField& known, int first_channel,
                    int base_channels, std::span<std::uint8_t> asks,
                    std::vector<std::uint32_t>& carried);
  Status size_places(const Context& context);
  /// Returns whether some of a triangle's nodes see a curve and others do not.
  bool sees_some(const std::uint32_t* node) const;
  Status make_room_for_means(Context& context);
  /// Lists all free nodes. The list is allocated from `memory`.
  Status list_free_nodes(const Context& context, TableMemory& memory,
                         std::vector<std::uint32_t>& free) const;
  /// Returns per node: 1 if it is listed to be gathered.
  Result<std::vector<std::uint8_t>> asked_nodes(const Context& context, TableMemory& memory) const;
  /// Removes the nodes without asks[node] from the list of nodes to be gathered.
  void keep_asked(std::span<const std::uint8_t> asks) {
    std::erase_if(to_gather_, [&](std::uint32_t node) { return !asks[node]; });
  }
  Status copy_layout(const Context& context, const NodeLayout& from,
                     std::span<const std::uint8_t> node_hit, std::size_t changed);
  /// Restores the nodes of the last frame to the nodes of `before`.
  Status take_back_nodes(const Context& context, const FieldSolver& before,
                         std::span<const std::uint32_t> changed);
  Status remember_values(const Context& context, const FieldFrame& frame, std::size_t nodes);
  Status order_left(const Context& context, const FieldSolver& before,
                    const gather::ShareBound& share);
  Status gather_last_of_left(Context& context, std::size_t count);
  bool show_last_value(std::uint32_t node, std::size_t& at);
  /// Lists in to_gather_ the free nodes of `old` that the update met and that have another position
  /// now. Nodes with the same position then count as not met.
  Status list_moved(const Context& context, const NodeLayout& old);
  Status locate_free(Context& context, std::span<const std::uint32_t> known);
  /// Locates the free nodes in the visibility mesh. Uses their known places, except where the node
  /// moved or its triangle changed.
  Status locate_nodes(Context& context, const RefinedField& known,
                      std::span<const std::uint8_t> is_same);
  /// Lists in `changed` the free nodes of `without` whose values the watched segments may change.
  static Status list_changed(Context& context, const PreparedField& with,
                             const FieldSolver& without, std::span<const std::uint8_t> is_same,
                             const gather::ShareBound* bound, TableMemory& memory,
                             std::vector<std::uint32_t>& changed);
  /// Adds these nodes to `listed`.
  Status list_to_gather(Context& context, const PreparedField& with, const FieldSolver& without,
                        std::span<const std::uint8_t> is_same, const gather::ShareBound* bound,
                        std::vector<std::uint32_t>& listed);
  bool has_channels_of(const PreparedField& other) const;
  /// Copies the values of nodes of `before` that are free in both fields and have the same
  /// position. Lists these nodes in `carried` and clears asks[node]. Errors: limit (memory),
  /// cancelled.
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
  /// The nodes that were gathered, or that show an older frame, if history_.is_logged.
  std::vector<std::uint32_t> gathered_;
  /// The deferred nodes of a frame. The last nodes in the list are gathered first.
  std::vector<std::uint32_t> left_;
  std::size_t shown_left_ = 0;  ///< how many nodes, at the front of left_, show the last frame
  LastValues last_;
  std::vector<std::uint8_t> node_hit_;  ///< 0 where a free node sees no curve
  gather::PointPlaces free_place_;      ///< where the free nodes lie; empty: unknown
  bool keeps_places_;
  /// Per node, if keeps_places_: the triangle of the visibility mesh that contains it.
  std::vector<std::uint32_t> node_place_;
  std::optional<FieldFrame> frame_;  ///< the last frame, until lay_out_from() takes its tables
  TableMemory memory_{"patches"};    ///< for lists of nodes, node_hit_, node_place_, vertex_radius_
};

/// Moves one channel of a field to a new field with the same nodes, allocated from `memory`.
/// Errors: limit (memory), cancelled; `field` is then unusable.
Result<PatchField> split_channel(const Context& context, PatchField& field, int channel,
                                 TableMemory& memory);

}  // namespace sfumato::solve
