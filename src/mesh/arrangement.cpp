#include "mesh/arrangement.hpp"

#include "base/limit_error.hpp"

namespace sfumato::mesh {
namespace {

/// The number of steps after which a segment continues without welding; after twice as many it is
/// discarded. Every vertex costs a constraint that snaps to it a few steps at most.
constexpr std::uint32_t kMaxSteps = 20'000;
constexpr std::uint32_t kMaxStepsPerVertex = 8;

constexpr std::uint32_t kStepsPerPoll = 1024;

/// Sloan's flips take about as many steps as edges are crossed.
constexpr std::size_t kMaxFlips = 1000;
constexpr std::size_t kMaxFlipsPerEdge = 50;

/// Returns whether both parts are shorter than the whole. A segment from a to b may be split at v
/// only then.
bool shortens(Point a, Point b, Point v) {
  const std::int64_t whole = distance_squared(a, b);
  return distance_squared(a, v) < whole && distance_squared(v, b) < whole;
}

}  // namespace

void Arrangement::fail(StatusCode code, const char* message) {
  if (status_.ok()) status_ = make_error(code, message);
}

bool Arrangement::make_room() {
  if (!mesh_.has_room()) {
    Status status = mesh_.grow(context_, mesh_.point.size() * 3 / 2 + 64);
    if (!status && status_.ok()) status_ = status;
  }
  return status_.ok();
}

/// Charges the growth of the lists since the last constraint.
void Arrangement::charge_lists() {
  const std::size_t bytes = capacity_bytes(to_insert_, crossed_edges_, new_edges_);
  Status status = chords_.charge(context_);
  if (status) status = charge_.raise_to(context_, bytes + mesh_.list_bytes(), "curve pieces");
  if (!status && status_.ok()) status_ = status;
}

void Arrangement::end_if_cancelled() {
  if (status_.ok() && context_.cancelled()) status_ = context_.cancel_status();
}

Vertex Arrangement::insert_point(Point p) {
  if ((++steps_ & (kStepsPerPoll - 1)) == 0) end_if_cancelled();
  if (!status_.ok()) return 0;
  welding_ = true;
  const std::size_t vertex_count = mesh_.point.size();
  const Vertex v = insert_vertex(p, true);
  if (chords_.size() == 0) return v;
  if (mesh_.point.size() > vertex_count) snap_near_chords_to(v);
  insert_pending();
  return v;
}

void Arrangement::insert_segment(Vertex from, Vertex to, std::uint32_t segment) {
  if (!status_.ok() || from == to) return;
  insert_constraint({from, to, chords_.whole(segment)});
}

void Arrangement::insert_frame_side(Vertex from, Vertex to) {
  if (!status_.ok() || from == to) return;
  insert_constraint({from, to, {kNone, 0, true}});
}

void Arrangement::insert_constraint(Subsegment part) {
  welding_ = true;
  to_insert_.assign(1, part);
  insert_pending();
}

void Arrangement::insert_pending() {
  std::uint32_t steps = 0;
  while (!to_insert_.empty()) {
    const Subsegment now = to_insert_.back();
    to_insert_.pop_back();
    if ((++steps_ & (kStepsPerPoll - 1)) == 0) end_if_cancelled();
    charge_lists();
    if (!status_.ok()) return;
    const auto vertices = static_cast<std::uint32_t>(mesh_.point.size());
    const std::uint32_t max_steps = kMaxSteps + kMaxStepsPerVertex * vertices;
    if (steps > max_steps) welding_ = false;
    if (now.from == now.to || steps / 2 > max_steps) {
      discard(now);
    } else {
      insert_subsegment(now);
    }
  }
}

void Arrangement::discard(const Subsegment& part) {
  chords_.discard(part.load);
}

/// Replaces a subsegment by two, from its start to v and from v to its end.
void Arrangement::split_at(const Subsegment& part, Vertex v) {
  if (chords_.live_owner_count() + static_cast<std::size_t>(part.load.count) >
      kOwnersPerSegment * context_.limits.segments) {
    if (status_.ok()) {
      status_ =
          make_limit_error(&Limits::segments, "overlapping curves are cut into too many pieces");
    }
    return;
  }
  const Point a = mesh_.point[part.from], b = mesh_.point[part.to];
  const auto [first, second] = chords_.split(part.load, fraction_along(a, b, mesh_.point[v]));
  to_insert_.push_back({v, part.to, second});
  to_insert_.push_back({part.from, v, first});
}

/// Returns whether v lies within the weld of the subsegment, between its ends, and the subsegment
/// may be split there.
bool Arrangement::snaps_to(const Subsegment& part, Vertex v) const {
  if (!welding_) return false;
  const Point a = mesh_.point[part.from], b = mesh_.point[part.to], p = mesh_.point[v];
  const std::int64_t length2 = distance_squared(a, b);
  const std::int64_t along = dot_from(a, b, p);
  if (along <= 0 || along >= length2) return false;
  const auto off = static_cast<double>(orient2d(a, b, p));
  return off * off <= static_cast<double>(weld_squared_) * static_cast<double>(length2) &&
         may_split_at(part, v);
}

/// Returns whether both parts get shorter, and neither drifts too far.
bool Arrangement::may_split_at(const Subsegment& part, Vertex v) const {
  const Point p = mesh_.point[v];
  return shortens(mesh_.point[part.from], mesh_.point[part.to], p) && !drifts_too_far(part.load, p);
}

/// Returns whether snapping to p would let one of the load's segments drift farther than two welds
/// from its drawn place.
bool Arrangement::drifts_too_far(const Load& load, Point p) const {
  for (std::int32_t i = load.first; i != kNone; i = chords_.owner(i).next) {
    const std::uint32_t segment = chords_.owner(i).segment;
    const Point a = drawn_[segment], b = drawn_[segment + 1];
    const double s = a == b ? 0 : fraction_along(a, b, p);
    const double x = a.x + s * (b.x - a.x) - p.x;
    const double y = a.y + s * (b.y - a.y) - p.y;
    if (x * x + y * y > 4 * static_cast<double>(weld_squared_)) return true;
  }
  return false;
}

void Arrangement::insert_subsegment(const Subsegment& part) {
  const Direction direction = find_direction(part.from, part.to);
  switch (direction.meets) {
    case Meets::edge:
      return insert_along_edge(part, direction.edge);
    case Meets::vertex:
      return split_at(part, mesh_.target(direction.edge));
    case Meets::crossing:
      return walk_to_end(part, direction.edge);
    case Meets::lost:
      discard(part);
      return fail(StatusCode::internal, "mesh: a vertex without a full fan");
  }
}

Arrangement::Direction Arrangement::find_direction(Vertex a, Vertex b) const {
  const Point pa = mesh_.point[a], pb = mesh_.point[b];
  const HalfEdge first = mesh_.spoke[a];
  HalfEdge e = first;
  std::int64_t right = orient2d(pa, pb, mesh_.target_point(e));
  do {
    if (mesh_.target(e) == b) return {Meets::edge, e};
    if (right == 0 && dot_from(pa, pb, mesh_.target_point(e)) > 0) return {Meets::vertex, e};
    const std::int64_t left = orient2d(pa, pb, mesh_.apex_point(e));
    if (right < 0 && left > 0) return {Meets::crossing, next(e)};
    right = left;
    e = mesh_.twin(previous(e));
  } while (e != first && e >= 0);
  return {Meets::lost, kNone};
}

void Arrangement::insert_along_edge(const Subsegment& part, HalfEdge e) {
  if (!mesh_.is_constrained(e)) {
    for (const HalfEdge side : {e, mesh_.twin(e)}) {
      const Vertex v = mesh_.apex(side);
      if (snaps_to(part, v)) return split_at(part, v);
    }
  }
  constrain_edge(part, e);
}

/// Makes e, which starts at part.from, a chord with the subsegment's load, or adds the load to the
/// existing chord; loads that cancel out leave a free edge.
void Arrangement::constrain_edge(const Subsegment& part, HalfEdge e) {
  moved_frame_ |= part.load.frame;
  if (!mesh_.is_constrained(e)) {
    mesh_.constrain(e, chords_.add(mesh_.origin(e), mesh_.target(e), part.load));
    return;
  }
  const std::int32_t chord = mesh_.chord[e];
  chords_.merge(chord, part.from, part.load);
  mesh_.touch_sides(e);
  if (!chords_[chord].load.empty()) return;
  chords_.remove(chord);
  mesh_.unconstrain(e);
  mesh_.pending.push_back(e);
  mesh_.legalize();
}

/// Walks straight through the triangles that the subsegment crosses, from the edge opposite its
/// start to its end, a vertex that it meets, or a chord.
void Arrangement::walk_to_end(const Subsegment& part, HalfEdge first) {
  for (const Vertex v : {mesh_.origin(first), mesh_.target(first)}) {
    if (snaps_to(part, v)) return split_at(part, v);
  }
  const Point a = mesh_.point[part.from], b = mesh_.point[part.to];
  crossed_edges_.clear();
  HalfEdge e = first;
  for (;;) {
    if (mesh_.is_wall(e)) return intersect_chord(part, e);
    crossed_edges_.push_back({mesh_.origin(e), mesh_.target(e)});
    const HalfEdge f = mesh_.twin(e);
    const Vertex v = mesh_.apex(f);
    const std::int64_t side = orient2d(a, b, mesh_.point[v]);
    if (v == part.to || side == 0) return insert_by_flips(part, v);
    if (snaps_to(part, v)) return split_at(part, v);
    e = side > 0 ? next(f) : previous(f);
  }
}

/// Makes an edge from part.from to `end`, and constrains it. Precondition: all edges that it
/// crosses are free.
void Arrangement::insert_by_flips(const Subsegment& part, Vertex end) {
  const bool flipped =
      flip_crossed_edges(mesh_.point[part.from], mesh_.point[part.to], part.from, end);
  const HalfEdge e = flipped ? mesh_.find_edge(part.from, end) : kNone;
  if (e != kNone && end == part.to) {
    constrain_edge(part, e);
  } else if (e != kNone) {
    const double s = fraction_along(mesh_.point[part.from], mesh_.point[part.to], mesh_.point[end]);
    const auto [first, second] = chords_.split(part.load, s);
    constrain_edge({part.from, end, first}, e);
    to_insert_.push_back({end, part.to, second});
  }
  for (const Edge& edge : new_edges_) {
    const HalfEdge h = mesh_.find_edge(edge.from, edge.to);
    if (h != kNone) mesh_.pending.push_back(h);
    mesh_.legalize();
  }
  if (e != kNone) return;
  // The flips did not end: split in the middle.
  const Point a = mesh_.point[part.from], b = mesh_.point[part.to];
  const Vertex v = insert_vertex({a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2}, false);
  if (v == part.from || v == part.to) return discard(part);
  split_at(part, v);
}

/// Flips the crossed edges, and postpones edges of concave quadrilaterals (Sloan 1993). Returns
/// false if that did not end within the bound.
bool Arrangement::flip_crossed_edges(Point a, Point b, Vertex from, Vertex end) {
  new_edges_.clear();
  const std::size_t max_flips = kMaxFlips + kMaxFlipsPerEdge * crossed_edges_.size();
  for (std::size_t i = 0; i < crossed_edges_.size(); ++i) {
    const Edge edge = crossed_edges_[i];
    if (i > max_flips) {
      new_edges_.insert(new_edges_.end(), crossed_edges_.begin() + static_cast<std::ptrdiff_t>(i),
                        crossed_edges_.end());
      return false;
    }
    const HalfEdge e = mesh_.find_edge(edge.from, edge.to);
    const Vertex c = mesh_.apex(e), d = mesh_.apex(mesh_.twin(e));
    const Point u = mesh_.point[edge.from], w = mesh_.point[edge.to];
    const Point pc = mesh_.point[c], pd = mesh_.point[d];
    if (orient2d(pd, w, pc) <= 0 || orient2d(pc, u, pd) <= 0) {
      crossed_edges_.push_back(edge);
      continue;
    }
    mesh_.flip_edge(e);
    const bool touches_ends = c == from || c == end || d == from || d == end;
    const std::int64_t side_c = orient2d(a, b, pc), side_d = orient2d(a, b, pd);
    const bool crosses = (side_c > 0 && side_d < 0) || (side_c < 0 && side_d > 0);
    if (crosses && !touches_ends) {
      crossed_edges_.push_back({c, d});
    } else if (!((c == from && d == end) || (c == end && d == from))) {
      new_edges_.push_back({c, d});
    }
  }
  return true;
}

/// Returns the intersection with the chord on e, rounded to the lattice, or snapped to the end of
/// either within the weld.
Point Arrangement::snapped_intersection(const Subsegment& part, HalfEdge e) const {
  const Point a = mesh_.point[part.from], b = mesh_.point[part.to];
  const Point u = mesh_.origin_point(e), w = mesh_.target_point(e);
  const auto side_u = static_cast<double>(orient2d(a, b, u));
  const auto side_w = static_cast<double>(orient2d(a, b, w));
  const double s = side_u / (side_u - side_w);
  const double x = u.x + s * (w.x - u.x);
  const double y = u.y + s * (w.y - u.y);
  const Point crossing{static_cast<std::int32_t>(x + 0.5), static_cast<std::int32_t>(y + 0.5)};
  if (!welding_) return crossing;
  const Subsegment chord{mesh_.origin(e), mesh_.target(e), chords_[mesh_.chord[e]].load};
  Point nearest = crossing;
  std::int64_t least = weld_squared_;
  const auto try_end = [&](Vertex end, const Subsegment& other) {
    const std::int64_t distance = distance_squared(mesh_.point[end], crossing);
    if (distance > least || !may_split_at(other, end)) return;
    least = distance;
    nearest = mesh_.point[end];
  };
  for (const Vertex end : {chord.from, chord.to}) try_end(end, part);
  for (const Vertex end : {part.from, part.to}) try_end(end, chord);
  return nearest;
}

void Arrangement::intersect_chord(const Subsegment& part, HalfEdge e) {
  const Vertex u = mesh_.origin(e), w = mesh_.target(e);
  const Point x = snapped_intersection(part, e);
  if (x == mesh_.point[u]) return split_at(part, u);
  if (x == mesh_.point[w]) return split_at(part, w);
  const Subsegment chord = remove_constraint(e);
  const Vertex v = insert_intersection(part, chord, x);
  split_at(part, v);
  split_at(chord, v);
}

/// Removes the chord from an edge and restores the Delaunay property without it.
Arrangement::Subsegment Arrangement::remove_constraint(HalfEdge e) {
  const std::int32_t index = mesh_.chord[e];
  const Chord chord = chords_[index];
  moved_frame_ |= chord.load.frame;
  mesh_.unconstrain(e);
  mesh_.pending.push_back(e);
  mesh_.legalize();
  return {chord.from, chord.to, chords_.remove(index)};
}

/// Returns the vertex at the intersection x with a chord that was removed. Uses a vertex within the
/// weld where both may be split at it.
Vertex Arrangement::insert_intersection(const Subsegment& part, const Subsegment& chord, Point x) {
  if (x == mesh_.point[part.from]) return part.from;
  if (x == mesh_.point[part.to]) return part.to;
  const std::size_t vertex_count = mesh_.point.size();
  mesh_.last = triangle_of(mesh_.spoke[part.from]);
  Vertex v = insert_vertex(x, welding_);
  if (welding_ && !(mesh_.point[v] == x) && !(may_split_at(part, v) && may_split_at(chord, v))) {
    v = insert_vertex(x, false);
  }
  if (mesh_.point.size() > vertex_count) snap_near_chords_to(v);
  return v;
}

Vertex Arrangement::nearest_cavity_vertex(Point p) const {
  Vertex nearest = kNone;
  std::int64_t least = weld_squared_;
  for (const CavityEdge& edge : mesh_.cavity) {
    const std::int64_t distance = distance_squared(mesh_.point[edge.from], p);
    if (distance > least || (distance == least && nearest != kNone)) continue;
    least = distance;
    nearest = edge.from;
  }
  return nearest;
}

/// Returns the vertex at p; with `weld`, one within the weld if there is one. A chord through p is
/// split there: the caller must insert both parts again.
Vertex Arrangement::insert_vertex(Point p, bool weld) {
  Location at = mesh_.locate<false>(p, mesh_.last);
  if (at.place == Place::on_vertex) return mesh_.origin(at.edge);
  if (at.place == Place::blocked || !make_room()) {
    fail(StatusCode::internal, "mesh: a point outside the domain");
    return mesh_.origin(at.edge);
  }
  if (at.place == Place::on_edge && mesh_.is_constrained(at.edge)) {
    for (const Vertex v : {mesh_.origin(at.edge), mesh_.target(at.edge)}) {
      if (weld && distance_squared(mesh_.point[v], p) <= weld_squared_) return v;
    }
    const Subsegment chord = remove_constraint(at.edge);
    at = mesh_.locate<false>(p, mesh_.last);
    mesh_.find_cavity(p, triangle_of(at.edge));
    const Vertex v = mesh_.star_cavity(p);
    split_at(chord, v);
    return v;
  }
  mesh_.find_cavity(p, triangle_of(at.edge));
  const Vertex near = weld ? nearest_cavity_vertex(p) : kNone;
  return near != kNone ? near : mesh_.star_cavity(p);
}

/// Splits chords of the link of the new vertex v at v that lie within its weld.
void Arrangement::snap_near_chords_to(Vertex v) {
  if (!welding_) return;
  crossed_edges_.clear();
  const HalfEdge first = mesh_.spoke[v];
  HalfEdge e = first;
  do {
    const HalfEdge h = next(e);
    if (mesh_.is_constrained(h)) {
      const Subsegment chord{mesh_.origin(h), mesh_.target(h), chords_[mesh_.chord[h]].load};
      if (snaps_to(chord, v)) crossed_edges_.push_back({chord.from, chord.to});
    }
    e = mesh_.twin(previous(e));
  } while (e != first && e >= 0);
  for (const Edge& edge : crossed_edges_) {
    const HalfEdge h = mesh_.find_edge(edge.from, edge.to);
    if (h != kNone && mesh_.is_constrained(h)) split_at(remove_constraint(h), v);
  }
}

}  // namespace sfumato::mesh
