#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "curves/attributes.hpp"
#include "gather/kernels/scene_layout.hpp"
#include "mesh/triangle_mesh.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::gather {

/// An end of a curve that touches no other curve and whose two sides differ.
struct FreeEnd {
  Vec2 position;    ///< layer frame
  Vec2 direction;   ///< unit vector, out of the curve
  double bend = 0;  ///< sin(angle by which the curve, at distance r, has left its tangent line) / r
  double reach = 0;     ///< ρ: the term is 0 from this distance on; no other curve is nearer
  double free_way = 0;  ///< the distance of the nearest curve in front of it, or less; at least ρ
  std::uint32_t vertex = 0;  ///< of the mesh
  /// The constraint that determines ρ. kNone: ρ is the curve's length to a junction or to its other
  /// end. The constraint of the end itself: its curve follows an arc no farther, or the search
  /// ended there.
  std::int32_t nearest = mesh::kNone;
  float weight = 1;  ///< k
  /// Values of the sides where cross(direction, unbent(p - position)) is positive and negative.
  curves::FieldValue positive, negative;
  float blur_positive = 0, blur_negative = 0;

  /// Returns d, relative to the end, rotated about it so that the curve is mapped to its tangent
  /// line; exact for a circular arc of radius 1 / (2 bend).
  Vec2 unbent(Vec2 d) const;
};

/// The share of a free end in a point's value (docs/mathematics.md), before blur. The positive side
/// gets the share 1/2 + sin(φ/2) (β - 1/2) of the weight. β: curves::front_share() of |across|,
/// with the radius of the side that the point lies on.
struct EndShare {
  double weight = 0;     ///< 0 from the reach on, and on the end itself
  double half_sine = 0;  ///< sin(φ/2)
  double across = 0;     ///< of the curve's line, user units; positive on the positive side

  bool is_positive() const { return across > 0; }
};
/// Returns the share of an end at a point; d is the vector from the end to the point.
EndShare end_share(const FreeEnd& end, Vec2 d);

/// The tables of a mesh for the search for free ends. The lower of its half-edges names an edge.
struct EndTables {
  /// The edges with curves that meet at a vertex.
  struct Meeting {
    std::uint32_t edges = 0;
    std::uint32_t all =
        0;  ///< the exclusive or of their names: with two edges it gives the other one
  };
  std::vector<Meeting> meeting{};     ///< per vertex
  std::vector<std::uint32_t> mark{};  ///< per half-edge: its place on the curves followed so far
  std::vector<std::uint32_t> seen{};  ///< per triangle: the last search that visited it
  std::uint32_t marks = 0;            ///< number of places that were assigned
  std::uint32_t searches = 0;
  TableMemory memory{"free ends of curves"};
};

/// Finds the free ends of a field, in the order of their vertices. Ends whose reach is below a
/// lattice step are left out. The list is allocated from `memory`.
///
/// tables   unless null: empty, and becomes that of this mesh
/// beside   as in GatherUse
///
/// Errors: limit (memory), cancelled.
/// Cost: O(triangles), and for each end the triangles within its reach. At most 1024 of these are
/// visited, and the reach is limited to the area that they cover.
Result<std::vector<FreeEnd>> find_free_ends(Context& context, const mesh::TriangleMesh& mesh,
                                            const curves::SegmentAttributes& attributes,
                                            TableMemory& memory, EndTables* tables = nullptr,
                                            const curves::SegmentAttributes* beside = nullptr);

/// The terms of a field's free ends, in a tree of boxes.
class FreeEnds {
 public:
  FreeEnds() = default;

  /// Makes the terms.
  ///
  /// origin       positions are relative to it
  /// weight_unit  weights are in units of it
  /// extendable   keeps the tables that extend() needs
  /// beside       as in GatherUse
  /// Errors       limit (memory), cancelled
  static Result<FreeEnds> create(Context& context, const mesh::TriangleMesh& mesh,
                                 const curves::SegmentAttributes& attributes, Vec2 origin,
                                 float weight_unit, bool extendable = false,
                                 const curves::SegmentAttributes* beside = nullptr);

  /// Returns the ends of the same field after the watched segments were inserted into its mesh, or
  /// removed. An end keeps its term where the changes are farther away than the edge that
  /// determines it.
  ///
  /// before       is extendable, and outlives this or forget_changes()
  /// with         the mesh with the watched segments: `mesh`, or that of `before`
  /// is_watched   per segment
  /// is_same      per triangle of the mesh of `before`: 1 where this one has the same at the same
  ///              index
  /// used         an object whose tables are reused, or null
  /// Errors       limit (memory), cancelled
  /// Cost         O(ends), copies of tables, and searches at ends that are new or not so far away
  static Result<FreeEnds> extend(Context& context, const mesh::TriangleMesh& mesh,
                                 const curves::SegmentAttributes& attributes,
                                 const FreeEnds& before, const mesh::TriangleMesh& with,
                                 std::span<const std::uint8_t> is_watched,
                                 std::span<const std::uint8_t> is_same, FreeEnds* used);

  /// Releases `before` and the results of gone() and fresh(). Call it after extend().
  void forget_changes();

  /// Returns whether this was made by extend() from `other`.
  bool extends(const FreeEnds& other) const { return extended_ == &other; }

  /// Returns the earlier terms of the ends that changed, and fresh() their new terms. Call it after
  /// extend(). Errors: limit (memory), cancelled.
  Result<FreeEnds> gone(Context& context) const { return part(context, gone_); }
  Result<FreeEnds> fresh(Context& context) const { return part(context, fresh_); }

  bool empty() const { return end_.empty(); }

  /// Returns the ends, in the order of the terms of view(); removed ends have no reach. Positions
  /// are relative to the origin, weights in units.
  std::span<const FreeEnd> all() const { return end_; }

  /// Returns the terms in the layout of the exact gather's kernels, valid while this lives.
  EndTree view() const;

  /// Returns whether any end reaches p.
  bool reach(Vec2 p) const;

  /// Returns a box that contains their reach, empty if there are none.
  EndBox box() const;

  /// Returns whether any end may reach a point of the box: never false if one does.
  bool may_reach(const EndBox& box) const;

  /// Returns the ends that `other` does not have at the same place with the same term, apart from
  /// rounding. Both have the same origin. Errors: limit (memory), cancelled. Cost: O(n log n).
  Result<FreeEnds> without(Context& context, const FreeEnds& other) const;

  /// Returns the ends with a value other than 0 in a channel, on either side. Errors: limit
  /// (memory), cancelled. Cost: O(n log n).
  Result<FreeEnds> with_channel(Context& context, int channel) const;

  /// Adds the terms of the ends that reach p to a value of weight W: base channels, then shares of
  /// shaders. Returns W with them. EndTerms, in kernels/, does the same for packets.
  float add(Vec2 p, float weight, std::span<float> value) const;

  /// Does TableMemory::leave_budget().
  std::size_t leave_budget() { return memory_.leave_budget() + tables_.memory.leave_budget(); }

 private:
  Status build_tree(Context& context, std::uint32_t spare);
  Status sort(Context& context);
  Result<FreeEnds> part(Context& context, std::span<const FreeEnd> ends) const;
  Status copy_from(const Context& context, const FreeEnds& before);
  Status find_again(Context& context, const mesh::TriangleMesh& mesh,
                    const curves::SegmentAttributes& attributes, const mesh::TriangleMesh& with,
                    std::span<const std::uint8_t> is_watched,
                    std::span<const std::uint8_t> is_same);
  void take_away(std::size_t i);
  Status add_fresh(Context& context, const FreeEnd& end);
  FreeEnd relative(FreeEnd end) const;
  template <class Test>
  Result<FreeEnds> those(Context& context, Test test) const;
  EndTerm term_of(const FreeEnd& end) const;
  std::span<const FreeEnd> of_leaf(std::uint32_t leaf) const;
  template <class Visit>
  void visit_leaves_at(Vec2 p, Visit visit) const;

  /// Returns whether the other set has the same term at the same place.
  bool is_in(const FreeEnds& other, const FreeEnd& end) const;

  int base_channels_ = 3;
  Vec2 origin_;
  float weight_unit_ = 1;
  std::vector<FreeEnd> end_;  ///< neighbours are near each other; removed ends have no reach
  std::uint32_t leaf_count_ = 0;
  std::vector<EndTerm> term_;  ///< per end
  std::vector<EndBox> box_;    ///< per node of EndTree
  EndTables tables_;           ///< of the mesh, if extendable or extended
  const FreeEnds* extended_ = nullptr;
  std::vector<FreeEnd> gone_, fresh_;
  TableMemory memory_{"free ends of curves"};
};

}  // namespace sfumato::gather
