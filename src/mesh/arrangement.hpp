#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/charge.hpp"
#include "mesh/chords.hpp"
#include "mesh/lattice.hpp"
#include "mesh/triangulation.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::mesh {

/// Builds the arrangement of segments inside a triangulation, by incremental insertion and snap
/// rounding: vertices closer than the weld become one, a constraint closer than the weld to a
/// vertex is split at it, intersections become vertices, and subsegments that coincide share one
/// chord. The triangulation is constrained Delaunay between any two calls.
///
/// Bounded drift: no segment is snapped to a vertex farther than two welds from its drawn place.
///
/// Why it ends: a subsegment is split only into two strictly shorter ones, in exact arithmetic.
/// Where rounding leaves no shorter pair, the step is done without welding. The number of steps is
/// bounded; the rest of a segment after that many steps is discarded.
class Arrangement {
 public:
  Arrangement(const Context& context, Triangulation& mesh, ChordStore& chords,
              std::int64_t weld_squared)
      : context_(context), mesh_(mesh), chords_(chords), weld_squared_(weld_squared) {}

  /// Returns the vertex at p, or the one that p welds to. Call it for all points before the first
  /// segment that begins or ends there.
  Vertex insert_point(Point p);

  /// drawn   lattice points: segment s was drawn from drawn[s] to drawn[s + 1]. The arrangement
  /// keeps a copy.
  void set_segments(std::span<const Point> drawn) { drawn_ = drawn; }
  void insert_segment(Vertex from, Vertex to, std::uint32_t segment);
  void insert_frame_side(Vertex from, Vertex to);

  /// Returns whether a part of the frame was removed, even for a moment: triangles may have changed
  /// sides.
  bool moved_frame() const { return moved_frame_; }

  /// Returns the status. After limit, cancelled or internal all later calls do nothing.
  const Status& status() const { return status_; }
  const Context& context() const { return context_; }

 private:
  /// A part of a constraint that has not been inserted yet.
  struct Subsegment {
    Vertex from;
    Vertex to;
    Load load;
  };

  /// The first object that a subsegment meets from its start: an edge that leads to its end, a
  /// vertex on it (collinear), or an edge opposite its start that it crosses.
  enum class Meets : std::uint8_t { edge, vertex, crossing, lost };
  struct Direction {
    Meets meets;
    HalfEdge edge;  ///< edge: the edge itself; vertex: ends there; crossing: the crossed edge
  };

  void end_if_cancelled();  ///< polls the Context now
  void insert_constraint(Subsegment part);
  void insert_pending();
  void insert_subsegment(const Subsegment& part);
  Direction find_direction(Vertex a, Vertex b) const;
  void insert_along_edge(const Subsegment& part, HalfEdge e);
  void constrain_edge(const Subsegment& part, HalfEdge e);
  void walk_to_end(const Subsegment& part, HalfEdge first);
  void intersect_chord(const Subsegment& part, HalfEdge e);
  void insert_by_flips(const Subsegment& part, Vertex end);
  bool flip_crossed_edges(Point a, Point b, Vertex from, Vertex end);

  Point snapped_intersection(const Subsegment& part, HalfEdge e) const;
  Vertex insert_intersection(const Subsegment& part, const Subsegment& chord, Point x);
  Vertex insert_vertex(Point p, bool weld);
  Vertex nearest_cavity_vertex(Point p) const;
  Subsegment remove_constraint(HalfEdge e);
  void snap_near_chords_to(Vertex v);

  void split_at(const Subsegment& part, Vertex v);
  void discard(const Subsegment& part);
  bool snaps_to(const Subsegment& part, Vertex v) const;
  bool may_split_at(const Subsegment& part, Vertex v) const;
  bool drifts_too_far(const Load& load, Point p) const;
  bool make_room();
  void charge_lists();
  void fail(StatusCode code, const char* message);

  const Context& context_;
  Triangulation& mesh_;
  ChordStore& chords_;
  std::int64_t weld_squared_;
  std::span<const Point> drawn_;
  bool welding_ = true;
  bool moved_frame_ = false;
  Status status_;
  std::uint32_t steps_ = 0;

  struct Edge {
    Vertex from;
    Vertex to;
  };
  std::vector<Subsegment> to_insert_;
  std::vector<Edge> crossed_edges_;
  std::vector<Edge> new_edges_;
  ScopedCharge charge_;  ///< for these three and the mesh's lists
};

}  // namespace sfumato::mesh
