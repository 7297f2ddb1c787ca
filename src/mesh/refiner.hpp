#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "mesh/chords.hpp"
#include "mesh/triangulation.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::mesh {

/// The origin of a vertex: the arrangement, the inside of a chord, or neither (free).
struct VertexOrigin {
  static constexpr std::int32_t kArrangement = -1;
  static constexpr std::int32_t kFree = -2;

  std::int32_t chord = kArrangement;  ///< or a chord index
  float fraction = 0;                 ///< of that chord
};

/// Returns the fraction of chord `c` (whose index is `chord_index`) at one of its vertices.
inline float fraction_at(const Chord& c, std::int32_t chord_index, Vertex v, VertexOrigin origin) {
  if (v == c.from) return 0;
  if (v == c.to) return 1;
  return origin.chord == chord_index ? origin.fraction : 0;
}

/// Delaunay refinement of the triangles inside the frame, after Ruppert 1995 and Shewchuk 2002:
/// off-centres (Üngör 2004), encroachment by diametral lenses, splits on concentric shells around
/// vertices where chords meet, and no splitting of triangles that span a small input angle between
/// two shells (Miller, Pav, Walkington 2003). Shortest edges come first. Chords are cut on their
/// straight lines, so that the mesh keeps the arrangement's shape. A small chord is not cut because
/// of a point inserted beside it. Such a point keeps its distance to all vertices, so that only a
/// flat small triangle results.
class Refiner {
 public:
  /// Charges its memory to `budget`.
  Refiner(Triangulation& mesh, const ChordStore& chords, Budget& budget)
      : mesh_(mesh), chords_(chords), memory_("the triangle mesh", budget), list_charge_(budget) {}

  /// min_angle_deg  0 to 33
  /// doubled_area   largest 2 · area in steps², or infinity
  /// weld           steps
  /// small_edge     steps: a triangle whose longest edge is at most this is not refined for its
  ///                angles, and a chord of at most this length is not cut because of a point near
  ///                it
  void set_quality(double min_angle_deg, double doubled_area, double weld, double small_edge);

  /// Copies the origins of another mesh's vertices; this mesh must be a copy of that one. Errors:
  /// limit (memory), cancelled.
  Status copy_origins(const Context& context, const Refiner& other) {
    owner_pieces_ = 0;
    return memory_.assign(context, other.origin_, origin_);
  }

  /// Refines all triangles inside. Errors: limit, cancelled.
  /// area   of the frame, steps². If the frame needs more triangles than the limit, this fails at
  ///        once.
  Status refine_all(const Context& context, double area);

  /// A triangle to be made smaller, unless its stamp has changed.
  struct Target {
    std::int32_t triangle;
    std::int32_t stamp;
  };
  /// Makes those targets smaller whose longest edge exceeds `smallest_edge` steps, then restores
  /// the quality around them.
  Status refine_targets(const Context& context, std::span<const Target> targets,
                        double smallest_edge);

  /// Refines the triangles that changed while the mesh was tracked, and what this changes. Errors:
  /// limit, cancelled.
  Status refine_touched(const Context& context);

  /// Returns the origins, per vertex of the triangulation.
  const std::vector<VertexOrigin>& origins() const { return origin_; }
  std::vector<VertexOrigin>& origins() { return origin_; }
  /// Starts. Call it before everything except set_quality, and whenever an arrangement has added
  /// vertices. Errors: limit (memory), cancelled.
  Status start(const Context& context) {
    return memory_.resize(context, origin_, mesh_.point.size());
  }

 private:
  struct Bad {
    HalfEdge shortest_edge;
    std::int32_t stamp;
  };
  struct Subsegment {
    HalfEdge edge;
    Vertex from;
    Vertex to;
  };
  struct Bucket {
    std::vector<Bad> items;
    std::size_t head = 0;
  };

  double least_triangles(double area) const;
  void check_triangle(std::int32_t t);
  void check_encroachment(std::int32_t t);
  void check_touched();
  bool spans_small_input_angle(HalfEdge e) const;
  bool in_lens(Point a, Point b, Point p) const;
  bool is_small(Vertex a, Vertex b) const;
  bool cavity_encroaches(Point p);
  Point steiner_point(HalfEdge shortest, double off_center) const;

  Status run(const Context& context);
  bool next_bad(Bad& bad);
  void refine_triangle(const Bad& bad);
  bool split_queued_subsegments();
  bool split_subsegment(HalfEdge e);
  double split_fraction(HalfEdge e, double length) const;
  bool split_point(HalfEdge e, double s, Point& p) const;
  void insert_free(Point p);
  void shrink(Target target, double smallest_edge2);
  void halve_longest_edge(std::int32_t t);
  HalfEdge longest_edge(std::int32_t t) const;
  bool make_room();
  bool make_room(std::size_t vertex_count);
  void charge_lists();
  std::size_t list_bytes() const;
  bool count_pieces(const Chord& chord);

  Triangulation& mesh_;
  const ChordStore& chords_;
  TableMemory memory_;
  ScopedCharge list_charge_;
  const Context* context_ = nullptr;
  Status status_;
  std::vector<VertexOrigin> origin_;

  double sin2_ = 0;        ///< for the minimum angle
  double lens_ = 0;        ///< cos² of twice the minimum angle
  double off_center_ = 0;  ///< height of an off-centre over its edge, in edge lengths
  double doubled_area_ = 0;
  double shortest_edge_ = 4;
  double small_edge2_ = 0;
  std::size_t owner_pieces_ = 0;

  static constexpr int kBucketCount = 128;
  std::array<Bucket, kBucketCount> bucket_;
  int lowest_ = kBucketCount;
  std::vector<Subsegment> encroached_;
};

}  // namespace sfumato::mesh
