#pragma once

#include <cstdint>
#include <vector>

#include "base/table_memory.hpp"
#include "mesh/lattice.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::mesh {

using Vertex = std::int32_t;

/// A half-edge, 4 t + k: from corner k of triangle t to corner (k + 1) % 3. Its triangle lies where
/// orient2d is positive.
using HalfEdge = std::int32_t;

constexpr std::int32_t triangle_of(HalfEdge e) {
  return e >> 2;
}
constexpr int corner_of(HalfEdge e) {
  return e & 3;
}
constexpr int kNextCorner[3] = {1, 2, 0};
constexpr int kPreviousCorner[3] = {2, 0, 1};
constexpr HalfEdge next(HalfEdge e) {
  return (e & ~3) | kNextCorner[e & 3];
}
constexpr HalfEdge previous(HalfEdge e) {
  return (e & ~3) | kPreviousCorner[e & 3];
}

/// across[k] of the half-edge of corner k: its twin << 1 | (1 where a chord lies on the edge).
/// kHull reads as a wall without a twin.
struct alignas(32) Triangle {
  Vertex vertex[3];
  std::int32_t stamp;  ///< counts the changes of this slot
  std::int32_t across[3];
  std::int16_t inside;  ///< 1 where the triangle lies inside the frame
  std::int16_t listed;  ///< kTouched, kChanged, kLogged: the lists that contain it
};
inline constexpr std::int32_t kHull = -1;
inline constexpr std::int16_t kTouched = 1;
inline constexpr std::int16_t kChanged = 2;
inline constexpr std::int16_t kLogged = 4;

enum class Place : std::uint8_t { inside, on_edge, on_vertex, blocked };

/// edge   inside: any edge of the triangle; on_edge: that edge; on_vertex: starts at the vertex;
///        blocked: the wall that the walk could not cross.
struct Location {
  Place place;
  HalfEdge edge;
};

/// An edge on the boundary of the star-shaped cavity of a new vertex, seen from inside.
struct CavityEdge {
  Vertex from;
  std::int32_t across;  ///< as Triangle::across
  std::int32_t chord;   ///< meaningful where across is a wall with a twin
};

/// A constrained Delaunay triangulation of the lattice rectangle: storage, point location,
/// insertion (Bowyer–Watson with chords as walls) and flips. Slots are never freed. It does not
/// handle welding or quality. Every vertex except the four corners lies strictly inside the
/// rectangle.
struct Triangulation {
  std::vector<Point> point;
  std::vector<HalfEdge> spoke;  ///< per vertex: a half-edge that starts there
  std::vector<Triangle> triangle;
  std::vector<std::int32_t> chord;    ///< per half-edge: meaningful where it is constrained
  std::vector<std::int32_t> touched;  ///< triangles inside that changed while `tracking`
  std::vector<std::int32_t> changed;  ///< the same, emptied less often
  bool tracking = false;
  std::int32_t width = 0;
  std::int32_t height = 0;

  /// Starts with two triangles over [0, width] × [0, height]; vertices 0 to 3 are the corners.
  void start(std::int32_t domain_width, std::int32_t domain_height);

  Vertex origin(HalfEdge e) const { return triangle[triangle_of(e)].vertex[corner_of(e)]; }
  Vertex target(HalfEdge e) const {
    return triangle[triangle_of(e)].vertex[kNextCorner[corner_of(e)]];
  }
  Vertex apex(HalfEdge e) const {
    return triangle[triangle_of(e)].vertex[kPreviousCorner[corner_of(e)]];
  }
  std::int32_t across(HalfEdge e) const { return triangle[triangle_of(e)].across[corner_of(e)]; }
  HalfEdge twin(HalfEdge e) const { return across(e) >> 1; }
  bool is_wall(HalfEdge e) const { return across(e) & 1; }
  bool is_constrained(HalfEdge e) const { return is_wall(e) && across(e) != kHull; }
  Point origin_point(HalfEdge e) const { return point[origin(e)]; }
  Point target_point(HalfEdge e) const { return point[target(e)]; }
  Point apex_point(HalfEdge e) const { return point[apex(e)]; }

  /// Returns whether p lies strictly inside the circle of triangle t. Exact.
  bool circumcircle_contains(const Triangle& t, Point p) const {
    return in_circle(point[t.vertex[0]], point[t.vertex[1]], point[t.vertex[2]], p);
  }

  /// Puts a chord on an edge, or removes it. Not on the hull. The triangles on both sides count as
  /// changed.
  void constrain(HalfEdge e, std::int32_t chord_index);
  void unconstrain(HalfEdge e);

  /// Marks the sides of an edge as changed, for another load of its chord.
  void touch_sides(HalfEdge e) {
    touch(triangle_of(e));
    touch(triangle_of(twin(e)));
  }

  /// Marks all triangles around a vertex as changed.
  void touch_around(Vertex v);

  /// Returns the half-edge from u to w, or kNone.
  HalfEdge find_edge(Vertex u, Vertex w) const;

  /// Walks towards a point from triangle `start` (visibility walk). A walk that is blocked by walls
  /// stops at the first wall.
  template <bool blocked_by_walls>
  Location locate(Point p, std::int32_t start_triangle);

  /// Finds the triangles whose circumcircles contain p, starting from the triangle of p
  /// (Bowyer–Watson); `cavity` becomes the boundary of their union, in positive order.
  void find_cavity(Point p, std::int32_t start_triangle);

  /// Replaces the cavity of the last `find_cavity` by the star of a new vertex at p.
  Vertex star_cavity(Point p);

  /// Splits a constrained edge at p, which may lie slightly off the edge but must see the four
  /// edges around it (`can_split_edge`). Both parts keep the chord. The result is Delaunay again.
  Vertex split_edge(HalfEdge e, Point p);
  bool can_split_edge(HalfEdge e, Point p) const;

  /// Replaces the edge by the other diagonal. Precondition: free, convex quadrilateral.
  void flip_edge(HalfEdge e);

  /// Flips the edges in `pending`, and the edges that become illegal by that, until the mesh is
  /// constrained Delaunay (Lawson).
  void legalize();
  std::vector<HalfEdge> pending;

  /// Calls visit(t) for each triangle in `touched` and empties the list.
  template <class Visit>
  void take_touched(Visit visit) {
    take(touched, kTouched, visit);
  }

  /// Does the same for `changed`.
  template <class Visit>
  void take_changed(Visit visit) {
    take(changed, kChanged, visit);
  }

  /// Returns whether there is room for one more insertion; `grow` makes it. `grow` reserves the
  /// chords last, so room for them implies room in the other tables.
  bool has_room() const {
    return 4 * (triangle.size() + 2) <= chord.size() && point.size() < point.capacity();
  }
  Status grow(const Context& context, std::size_t vertex_count);

  /// Copies a mesh, with room for some more, in the existing memory where that is large enough, and
  /// logs its changes from then on. Not while triangles of `other` are listed as touched. Errors:
  /// limit (memory), cancelled.
  Status copy_from(const Context& context, const Triangulation& other);

  /// Returns whether it still knows all changes since copy_from().
  bool knows_changes() const { return logged_slots_ > 0; }
  void forget_changes() { logged_slots_ = 0; }

  /// Does copy_from(), by undoing the logged changes since then. Precondition: knows_changes(), and
  /// `other` has not changed. Cost: O(changes).
  void take_back(const Triangulation& other);

  /// Returns the bytes of the lists that grow during an insertion.
  std::size_t list_bytes() const { return capacity_bytes(touched, pending, cavity, dead_, stack_); }

  std::vector<CavityEdge> cavity;  ///< boundary of the last `find_cavity`
  bool cavity_has_chords = false;
  std::int32_t last = 0;  ///< a triangle near the last change or search

 private:
  template <class Visit>
  void take(std::vector<std::int32_t>& list, std::int16_t bit, Visit visit) {
    for (const std::int32_t t : list) {
      triangle[t].listed &= ~bit;
      visit(t);
    }
    list.clear();
  }

  Vertex add_vertex(Point p) {
    point.push_back(p);
    spoke.push_back(kNone);
    return static_cast<Vertex>(point.size()) - 1;
  }
  std::int32_t add_triangle() {
    triangle.push_back({});
    return static_cast<std::int32_t>(triangle.size()) - 1;
  }
  void set_across(HalfEdge e, std::int32_t across, std::int32_t chord_index);
  void set_adjacent(HalfEdge e, std::int32_t across, std::int32_t chord_index);
  HalfEdge bisect_triangle(HalfEdge e, Vertex v);
  void touch(std::int32_t t) {
    Triangle& now = triangle[t];
    ++now.stamp;
    if (t < logged_slots_ && !(now.listed & kLogged)) {
      log_.push_back(t);
      now.listed |= kLogged;
    }
    constexpr std::int16_t kBoth = kTouched | kChanged;
    if (!tracking || (now.listed & kBoth) == kBoth || !now.inside) return;
    if (!(now.listed & kTouched)) touched.push_back(t);
    if (!(now.listed & kChanged)) changed.push_back(t);
    now.listed |= kBoth;
  }
  void clear_lists() {
    for (auto* list : {&touched, &changed, &pending, &log_}) list->clear();
    last = 0;
    walk_state_ = 1;
  }
  void take_back_slot(const Triangulation& other, std::int32_t t);

  std::vector<std::int32_t> log_;  ///< the triangles among the first logged_slots_ that changed
  std::int32_t logged_slots_ = 0;
  std::vector<std::int32_t> dead_;
  std::vector<HalfEdge> stack_;
  std::uint32_t walk_state_ = 1;
  TableMemory memory_{"the triangle mesh"};
};

}  // namespace sfumato::mesh
