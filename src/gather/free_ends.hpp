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

/// Ends of a mesh into which the watched segments were inserted since. An end keeps its term, but
/// for FreeEnd::nearest, where these are farther away than what was found.
struct KnownEnds {
  std::span<const FreeEnd> end;              ///< their positions are not used
  std::span<const std::uint8_t> is_watched;  ///< per segment
};

/// The free ends of a field, in the order of their vertices. Those whose reach is below a lattice
/// step are left out. Cost: O(triangles), and for each end the triangles within its reach. Of these
/// at most 1024 are visited, and the reach is limited to what they cover; as many watched edges are
/// compared with a known end. The list is allocated from `memory`. Errors: limit (memory),
/// cancelled.
Result<std::vector<FreeEnd>> find_free_ends(Context& context, const mesh::TriangleMesh& mesh,
                                            const curves::SegmentAttributes& attributes,
                                            TableMemory& memory, const KnownEnds& known = {});

/// The terms of a field's free ends, in a tree of boxes.
class FreeEnds {
 public:
  FreeEnds() = default;

  /// origin       positions are relative to it
  /// weight_unit  weights are in units of it
  /// before       unless null: of the mesh before the segments with is_watched were inserted
  /// Errors       limit (memory), cancelled
  static Result<FreeEnds> create(Context& context, const mesh::TriangleMesh& mesh,
                                 const curves::SegmentAttributes& attributes, Vec2 origin,
                                 float weight_unit, const FreeEnds* before = nullptr,
                                 std::span<const std::uint8_t> is_watched = {});

  bool empty() const { return end_.empty(); }

  /// The terms as the exact gather's kernels read them, as long as this lives.
  EndTree view() const;

  /// Whether any end reaches p.
  bool reach(Vec2 p) const;

  /// Those of them that `other` has not at the same place with the same term, but for rounding.
  /// Both have the same origin. Errors: limit (memory), cancelled. Cost: O(n log n).
  Result<FreeEnds> without(Context& context, const FreeEnds& other) const;

  /// Adds the terms of the ends that reach p to a value of weight W: base channels, then shares of
  /// shaders. Returns whether there were any. EndTerms, in kernels/, does the same for packets.
  bool add(Vec2 p, float weight, std::span<float> value) const;

 private:
  Status build_tree(Context& context);
  EndTerm term_of(const FreeEnd& end) const;
  std::span<const FreeEnd> of_leaf(std::uint32_t leaf) const;
  template <class Visit>
  void visit_leaves_at(Vec2 p, Visit visit) const;

  /// Whether the other set has the same term at the same place.
  bool is_in(const FreeEnds& other, const FreeEnd& end) const;

  int base_channels_ = 3;
  float weight_unit_ = 1;
  std::vector<FreeEnd> end_;  ///< neighbours are near each other
  std::uint32_t leaf_count_ = 0;
  std::vector<EndTerm> term_;  ///< per end
  std::vector<EndBox> box_;    ///< per node of EndTree
  TableMemory memory_{"free ends of curves"};
};

}  // namespace sfumato::gather
