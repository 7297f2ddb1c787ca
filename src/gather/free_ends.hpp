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
  double reach = 0;          ///< ρ: the term is 0 from this distance on; no other curve is nearer
  double free_way = 0;       ///< the distance of the nearest curve in its way, or less; at least ρ
  std::uint32_t vertex = 0;  ///< of the mesh
  /// The constraint that determines ρ. kNone: ρ is the curve's length to a junction or to its other
  /// end. The constraint of the end itself: its curve follows an arc no farther, or the search
  /// ended there.
  std::int32_t nearest = mesh::kNone;
  float weight = 1;  ///< k
  /// Values of the sides where cross(direction, unbent(p - position)) is positive and negative.
  curves::FieldValue positive, negative;
  float blur_positive = 0, blur_negative = 0;

  /// d, relative to the end, rotated about it so that the curve is mapped to its tangent line;
  /// exact for a circular arc of radius 1 / (2 bend).
  Vec2 unbent(Vec2 d) const;
};

/// What a point takes of a free end (docs/mathematics.md), before blur: of the weight, the share
/// 1/2 + sin(φ/2) (β - 1/2) is the positive side's. β: curves::front_share() of |across|, with the
/// radius of the side on which the point lies.
struct EndShare {
  double weight = 0;     ///< 0 from the reach on, and on the end itself
  double half_sine = 0;  ///< sin(φ/2)
  double across = 0;     ///< of the curve's line, user units; positive on the positive side

  bool is_positive() const { return across > 0; }
};
/// d   from the end to the point
EndShare end_share(const FreeEnd& end, Vec2 d);

/// What a search for free ends knows of a mesh. An edge is named by the lower of its half-edges.
struct EndTables {
  /// The edges with curves that meet at a vertex.
  struct Meeting {
    std::uint32_t edges = 0;
    std::uint32_t all = 0;  ///< their names, by exclusive or: of two, the other one
  };
  std::vector<Meeting> meeting{};     ///< per vertex
  std::vector<std::uint32_t> mark{};  ///< per half-edge: its place on the curves followed so far
  std::vector<std::uint32_t> seen{};  ///< per triangle: the search that looked at it last
  std::uint32_t marks = 0;            ///< places given out
  std::uint32_t searches = 0;
  TableMemory memory{"free ends of curves"};
};

/// The free ends of a field, in the order of their vertices. Those whose reach is below a lattice
/// step are left out. Cost: O(triangles), and for each end the triangles within its reach. Of these
/// at most 1024 are visited, and the reach is limited to what they cover. The list is allocated
/// from `memory`. Errors: limit (memory), cancelled.
/// tables   unless null: empty, and becomes that of this mesh
/// beside   as GatherUse
Result<std::vector<FreeEnd>> find_free_ends(Context& context, const mesh::TriangleMesh& mesh,
                                            const curves::SegmentAttributes& attributes,
                                            TableMemory& memory, EndTables* tables = nullptr,
                                            const curves::SegmentAttributes* beside = nullptr);

/// The terms of a field's free ends, in a tree of boxes.
class FreeEnds {
 public:
  FreeEnds() = default;

  /// origin       positions are relative to it
  /// weight_unit  weights are in units of it
  /// extendable   keeps what extend() asks for
  /// beside       as GatherUse
  /// Errors       limit (memory), cancelled
  static Result<FreeEnds> create(Context& context, const mesh::TriangleMesh& mesh,
                                 const curves::SegmentAttributes& attributes, Vec2 origin,
                                 float weight_unit, bool extendable = false,
                                 const curves::SegmentAttributes* beside = nullptr);

  /// Those of the same field after the watched segments were inserted into its mesh, or taken out.
  /// An end keeps its term where these are farther away than what was found for it.
  /// before       is extendable, and outlives this or forget_changes()
  /// with         the mesh that has the watched segments: `mesh`, or that of `before`
  /// is_watched   per segment
  /// is_same      per triangle of the mesh of `before`: 1 where this one has the same at the same
  ///              index
  /// used         whose tables are used again, or null
  /// Errors       limit (memory), cancelled
  /// Cost         O(ends), copies of tables, and searches at ends that are new or not so far away
  static Result<FreeEnds> extend(Context& context, const mesh::TriangleMesh& mesh,
                                 const curves::SegmentAttributes& attributes,
                                 const FreeEnds& before, const mesh::TriangleMesh& with,
                                 std::span<const std::uint8_t> is_watched,
                                 std::span<const std::uint8_t> is_same, FreeEnds* used);

  /// After extend(): lets go of `before` and of what gone() and fresh() return.
  void forget_changes();

  /// Whether this was made by extend() from `other`.
  bool extends(const FreeEnds& other) const { return extended_ == &other; }

  /// After extend(): the ends that are not as they were, and what they are now. Errors: limit
  /// (memory), cancelled.
  Result<FreeEnds> gone(Context& context) const { return part(context, gone_); }
  Result<FreeEnds> fresh(Context& context) const { return part(context, fresh_); }

  bool empty() const { return end_.empty(); }

  /// The ends, in the order of the terms of view(); of no reach: taken away. Positions are relative
  /// to the origin, weights in units.
  std::span<const FreeEnd> all() const { return end_; }

  /// The terms as the exact gather's kernels read them, as long as this lives.
  EndTree view() const;

  /// Whether any end reaches p.
  bool reach(Vec2 p) const;

  /// What they reach lies in this box, which is empty if there are none.
  EndBox box() const;

  /// Whether any may reach a point of the box: never too few.
  bool may_reach(const EndBox& box) const;

  /// Those of them that `other` has not at the same place with the same term, but for rounding.
  /// Both have the same origin. Errors: limit (memory), cancelled. Cost: O(n log n).
  Result<FreeEnds> without(Context& context, const FreeEnds& other) const;

  /// Those of them that have another value than 0 in a channel, on either side. Errors: limit
  /// (memory), cancelled. Cost: O(n log n).
  Result<FreeEnds> with_channel(Context& context, int channel) const;

  /// Adds the terms of the ends that reach p to a value of weight W: base channels, then shares of
  /// shaders. Returns W with them. EndTerms, in kernels/, does the same for packets.
  float add(Vec2 p, float weight, std::span<float> value) const;

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

  /// Whether the other set has the same term at the same place.
  bool is_in(const FreeEnds& other, const FreeEnd& end) const;

  int base_channels_ = 3;
  Vec2 origin_;
  float weight_unit_ = 1;
  std::vector<FreeEnd> end_;  ///< neighbours are near each other; of no reach: taken away
  std::uint32_t leaf_count_ = 0;
  std::vector<EndTerm> term_;  ///< per end
  std::vector<EndBox> box_;    ///< per node of EndTree
  EndTables tables_;           ///< of the mesh, if extendable or extended
  const FreeEnds* extended_ = nullptr;
  std::vector<FreeEnd> gone_, fresh_;
  TableMemory memory_{"free ends of curves"};
};

}  // namespace sfumato::gather
