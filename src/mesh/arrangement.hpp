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

/// Builds the arrangement of segments inside a triangulation: vertices closer than the weld become
/// one, a constraint that passes a vertex closer than the weld is led through it, crossings become
/// vertices, and what falls onto one edge shares one chord. The triangulation is constrained
/// Delaunay between any two calls.
///
/// A detour or a weld that would lead a segment farther than two welds from where it was drawn is
/// not made.
///
/// Why it ends: a constraint is replaced only by two strictly shorter ones, in exact arithmetic.
/// Where rounding leaves no shorter pair the step is done without welding; should that still not
/// settle within a bound on the steps, what is left of the segment is dropped.
class Arrangement {
 public:
  Arrangement(Context& context, Triangulation& mesh, ChordStore& chords, ScopedCharge& charge,
              std::int64_t weld_squared)
      : context_(context),
        mesh_(mesh),
        chords_(chords),
        charge_(charge),
        weld_squared_(weld_squared) {}

  /// The vertex at p, or the one that p welds to. Call for all points before the first segment.
  Vertex add_point(Point p);

  /// drawn   lattice points: segment s was drawn from drawn[s] to drawn[s + 1]. Kept.
  void set_segments(std::span<const Point> drawn) { drawn_ = drawn; }
  void add_segment(Vertex from, Vertex to, std::uint32_t segment);
  void add_frame_side(Vertex from, Vertex to);

  void end_if_cancelled();  ///< asks the Context now

  /// limit, cancelled, internal: all later calls do nothing.
  const Status& status() const { return status_; }
  const Context& context() const { return context_; }

 private:
  /// A constraint that is yet to be inserted.
  struct Job {
    Vertex from;
    Vertex to;
    Load load;
  };

  /// What a constraint meets first on its way from its start: an edge that is all or (collinear)
  /// its beginning, or an edge opposite the start that it crosses.
  enum class Ahead : std::uint8_t { edge, vertex, crossing, lost };
  struct View {
    Ahead kind;
    HalfEdge edge;  ///< edge: the edge itself; vertex: ends there; crossing: the crossed edge
  };

  void run(Job job);
  void settle(const Job& job);
  View look(Vertex a, Vertex b) const;
  void take_edge(const Job& job, HalfEdge e);
  void lay(const Job& job, HalfEdge e);
  void cross_triangles(const Job& job, HalfEdge first);
  void cross_chord(const Job& job, HalfEdge e);
  void carve(const Job& job, Vertex end);
  bool flip_crossed(Point a, Point b, Vertex from, Vertex end);

  Point snapped_crossing(const Job& job, HalfEdge e) const;
  Vertex crossing_vertex(const Job& job, const Job& chord, Point x);
  Vertex place(Point p, bool weld);
  Vertex nearest_of_cavity(Point p) const;
  Job lift(HalfEdge e);
  void lead_near_chords_through(Vertex v);

  void detour(const Job& job, Vertex through);
  void drop(const Job& job);
  bool passes(const Job& job, Vertex v) const;
  bool may_lead_through(const Job& job, Vertex v) const;
  bool strays(const Load& load, Point p) const;
  bool make_room();
  void charge_chords();
  void fail(StatusCode code, const char* message);

  Context& context_;
  Triangulation& mesh_;
  ChordStore& chords_;
  ScopedCharge& charge_;
  std::int64_t weld_squared_;
  std::span<const Point> drawn_;
  bool welding_ = true;
  Status status_;
  std::uint32_t steps_ = 0;
  std::size_t charged_bytes_ = 0;

  struct Edge {
    Vertex from;
    Vertex to;
  };
  std::vector<Job> jobs_;
  std::vector<Edge> crossed_;
  std::vector<Edge> fresh_;
};

}  // namespace sfumato::mesh
