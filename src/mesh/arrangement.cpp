#include "mesh/arrangement.hpp"

namespace sfumato::mesh {
namespace {

/// Steps that one segment may take before it goes on without welding; twice as many drop it.
/// Every vertex costs a passing constraint a few steps at most.
constexpr std::uint32_t kPatience = 20'000;
constexpr std::uint32_t kPatiencePerVertex = 8;

constexpr std::uint32_t kStepsPerCancelCheck = 1024;

/// Sloan's flips take about as many steps as edges are crossed.
constexpr std::size_t kFlipPatience = 1000;
constexpr std::size_t kFlipPatiencePerEdge = 50;

/// A detour from a to b through v is allowed only where both parts are shorter than the whole.
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
    Status status = mesh_.grow(context_, charge_, mesh_.point.size() * 3 / 2 + 64);
    if (!status && status_.ok()) status_ = status;
  }
  return status_.ok();
}

/// Charges for the tables of chords before they double.
void Arrangement::charge_chords() {
  if (chords_.bytes() <= charged_bytes_) return;
  Status status = charge_.add(context_, chords_.bytes() - charged_bytes_, "curve pieces");
  if (!status && status_.ok()) status_ = status;
  charged_bytes_ = chords_.bytes();
}

void Arrangement::end_if_cancelled() {
  if (status_.ok() && context_.cancelled()) status_ = context_.cancel_status();
}

Vertex Arrangement::add_point(Point p) {
  if ((++steps_ & (kStepsPerCancelCheck - 1)) == 0) end_if_cancelled();
  if (!status_.ok()) return 0;
  return place(p, true);
}

void Arrangement::add_segment(Vertex from, Vertex to, std::uint32_t segment) {
  if (!status_.ok() || from == to) return;
  run({from, to, chords_.whole(segment)});
}

void Arrangement::add_frame_side(Vertex from, Vertex to) {
  if (!status_.ok() || from == to) return;
  run({from, to, {kNone, 0, true}});
}

void Arrangement::run(Job job) {
  welding_ = true;
  std::uint32_t steps = 0;
  jobs_.assign(1, job);
  while (!jobs_.empty()) {
    const Job now = jobs_.back();
    jobs_.pop_back();
    if ((++steps_ & (kStepsPerCancelCheck - 1)) == 0) end_if_cancelled();
    charge_chords();
    if (!status_.ok()) return;
    const auto vertices = static_cast<std::uint32_t>(mesh_.point.size());
    const std::uint32_t patience = kPatience + kPatiencePerVertex * vertices;
    if (steps > patience) welding_ = false;
    if (now.from == now.to || steps / 2 > patience) {
      drop(now);
    } else {
      settle(now);
    }
  }
}

void Arrangement::drop(const Job& job) {
  chords_.discard(job.load);
}

/// Replaces the job by two, through a vertex.
void Arrangement::detour(const Job& job, Vertex through) {
  if (chords_.live_owner_count() + static_cast<std::size_t>(job.load.count) >
      kOwnersPerSegment * context_.limits.segments) {
    fail(StatusCode::limit, "overlapping curves are cut into too many pieces");
    return;
  }
  const Point a = mesh_.point[job.from], b = mesh_.point[job.to];
  const auto [first, second] = chords_.cut(job.load, fraction_along(a, b, mesh_.point[through]));
  jobs_.push_back({through, job.to, second});
  jobs_.push_back({job.from, through, first});
}

/// v lies within the weld of the job's open segment, and may serve as a detour.
bool Arrangement::passes(const Job& job, Vertex v) const {
  if (!welding_) return false;
  const Point a = mesh_.point[job.from], b = mesh_.point[job.to], p = mesh_.point[v];
  const std::int64_t length2 = distance_squared(a, b);
  const std::int64_t along = dot_from(a, b, p);
  if (along <= 0 || along >= length2) return false;
  const auto off = static_cast<double>(orient2d(a, b, p));
  return off * off <= static_cast<double>(weld_squared_) * static_cast<double>(length2) &&
         may_lead_through(job, v);
}

/// A detour through v shortens and does not stray.
bool Arrangement::may_lead_through(const Job& job, Vertex v) const {
  const Point p = mesh_.point[v];
  return shortens(mesh_.point[job.from], mesh_.point[job.to], p) && !strays(job.load, p);
}

/// p is farther than two welds from one of the segments of the load as they were drawn.
bool Arrangement::strays(const Load& load, Point p) const {
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

void Arrangement::settle(const Job& job) {
  const View view = look(job.from, job.to);
  switch (view.kind) {
    case Ahead::edge:
      return take_edge(job, view.edge);
    case Ahead::vertex:
      return detour(job, mesh_.target(view.edge));
    case Ahead::crossing:
      return cross_triangles(job, view.edge);
    case Ahead::lost:
      drop(job);
      return fail(StatusCode::internal, "mesh: a vertex without a full fan");
  }
}

Arrangement::View Arrangement::look(Vertex a, Vertex b) const {
  const Point pa = mesh_.point[a], pb = mesh_.point[b];
  const HalfEdge first = mesh_.spoke[a];
  HalfEdge e = first;
  std::int64_t right = orient2d(pa, pb, mesh_.target_point(e));
  do {
    if (mesh_.target(e) == b) return {Ahead::edge, e};
    if (right == 0 && dot_from(pa, pb, mesh_.target_point(e)) > 0) return {Ahead::vertex, e};
    const std::int64_t left = orient2d(pa, pb, mesh_.apex_point(e));
    if (right < 0 && left > 0) return {Ahead::crossing, next(e)};
    right = left;
    e = mesh_.twin(previous(e));
  } while (e != first && e >= 0);
  return {Ahead::lost, kNone};
}

void Arrangement::take_edge(const Job& job, HalfEdge e) {
  if (!mesh_.is_constrained(e)) {
    for (const HalfEdge side : {e, mesh_.twin(e)}) {
      const Vertex v = mesh_.apex(side);
      if (passes(job, v)) return detour(job, v);
    }
  }
  lay(job, e);
}

/// Puts the job's load on an edge from job.from to its end.
void Arrangement::lay(const Job& job, HalfEdge e) {
  if (!mesh_.is_constrained(e)) {
    mesh_.constrain(e, chords_.add(mesh_.origin(e), mesh_.target(e), job.load));
    return;
  }
  const std::int32_t chord = mesh_.chord[e];
  chords_.merge(chord, job.from, job.load);
  if (!chords_[chord].load.empty()) return;
  chords_.remove(chord);
  mesh_.release(e);
  mesh_.pending.push_back(e);
  mesh_.legalize();
}

/// Follows the job through the triangles that it crosses, from the edge opposite its start.
void Arrangement::cross_triangles(const Job& job, HalfEdge first) {
  for (const Vertex v : {mesh_.origin(first), mesh_.target(first)}) {
    if (passes(job, v)) return detour(job, v);
  }
  const Point a = mesh_.point[job.from], b = mesh_.point[job.to];
  crossed_.clear();
  HalfEdge e = first;
  for (;;) {
    if (mesh_.is_wall(e)) return cross_chord(job, e);
    crossed_.push_back({mesh_.origin(e), mesh_.target(e)});
    const HalfEdge f = mesh_.twin(e);
    const Vertex v = mesh_.apex(f);
    const std::int64_t side = orient2d(a, b, mesh_.point[v]);
    if (v == job.to || side == 0) return carve(job, v);
    if (passes(job, v)) return detour(job, v);
    e = side > 0 ? next(f) : previous(f);
  }
}

/// Makes the stretch from job.from to `end`, which crosses only free edges, an edge.
void Arrangement::carve(const Job& job, Vertex end) {
  const bool carved = flip_crossed(mesh_.point[job.from], mesh_.point[job.to], job.from, end);
  const HalfEdge e = carved ? mesh_.find(job.from, end) : kNone;
  if (e != kNone && end == job.to) {
    lay(job, e);
  } else if (e != kNone) {
    const double s = fraction_along(mesh_.point[job.from], mesh_.point[job.to], mesh_.point[end]);
    const auto [first, second] = chords_.cut(job.load, s);
    lay({job.from, end, first}, e);
    jobs_.push_back({end, job.to, second});
  }
  for (const Edge& edge : fresh_) {
    const HalfEdge h = mesh_.find(edge.from, edge.to);
    if (h != kNone) mesh_.pending.push_back(h);
    mesh_.legalize();
  }
  if (e != kNone) return;
  // The flips did not settle: halve the way.
  const Point a = mesh_.point[job.from], b = mesh_.point[job.to];
  const Vertex v = place({a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2}, false);
  if (v == job.from || v == job.to) return drop(job);
  detour(job, v);
}

/// Sloan 1993: flips the crossed edges away, those of concave quadrilaterals later.
bool Arrangement::flip_crossed(Point a, Point b, Vertex from, Vertex end) {
  fresh_.clear();
  const std::size_t patience = kFlipPatience + kFlipPatiencePerEdge * crossed_.size();
  for (std::size_t i = 0; i < crossed_.size(); ++i) {
    const Edge edge = crossed_[i];
    if (i > patience) {
      fresh_.insert(fresh_.end(), crossed_.begin() + static_cast<std::ptrdiff_t>(i),
                    crossed_.end());
      return false;
    }
    const HalfEdge e = mesh_.find(edge.from, edge.to);
    const Vertex c = mesh_.apex(e), d = mesh_.apex(mesh_.twin(e));
    const Point u = mesh_.point[edge.from], w = mesh_.point[edge.to];
    const Point pc = mesh_.point[c], pd = mesh_.point[d];
    if (orient2d(pd, w, pc) <= 0 || orient2d(pc, u, pd) <= 0) {
      crossed_.push_back(edge);
      continue;
    }
    mesh_.flip(e);
    const bool touches_ends = c == from || c == end || d == from || d == end;
    const std::int64_t side_c = orient2d(a, b, pc), side_d = orient2d(a, b, pd);
    const bool crosses = (side_c > 0 && side_d < 0) || (side_c < 0 && side_d > 0);
    if (crosses && !touches_ends) {
      crossed_.push_back({c, d});
    } else if (!((c == from && d == end) || (c == end && d == from))) {
      fresh_.push_back({c, d});
    }
  }
  return true;
}

/// Where the job crosses the chord on e: rounded to the lattice, or the end of either within the
/// weld.
Point Arrangement::snapped_crossing(const Job& job, HalfEdge e) const {
  const Point a = mesh_.point[job.from], b = mesh_.point[job.to];
  const Point u = mesh_.origin_point(e), w = mesh_.target_point(e);
  const auto side_u = static_cast<double>(orient2d(a, b, u));
  const auto side_w = static_cast<double>(orient2d(a, b, w));
  const double s = side_u / (side_u - side_w);
  const double x = u.x + s * (w.x - u.x);
  const double y = u.y + s * (w.y - u.y);
  const Point crossing{static_cast<std::int32_t>(x + 0.5), static_cast<std::int32_t>(y + 0.5)};
  if (!welding_) return crossing;
  const Job chord{mesh_.origin(e), mesh_.target(e), chords_[mesh_.chord[e]].load};
  Point nearest = crossing;
  std::int64_t least = weld_squared_;
  const auto try_end = [&](Vertex end, const Job& other) {
    const std::int64_t distance = distance_squared(mesh_.point[end], crossing);
    if (distance > least || !may_lead_through(other, end)) return;
    least = distance;
    nearest = mesh_.point[end];
  };
  for (const Vertex end : {chord.from, chord.to}) try_end(end, job);
  for (const Vertex end : {job.from, job.to}) try_end(end, chord);
  return nearest;
}

void Arrangement::cross_chord(const Job& job, HalfEdge e) {
  const Vertex u = mesh_.origin(e), w = mesh_.target(e);
  const Point x = snapped_crossing(job, e);
  if (x == mesh_.point[u]) return detour(job, u);
  if (x == mesh_.point[w]) return detour(job, w);
  const Job chord = lift(e);
  const Vertex v = crossing_vertex(job, chord, x);
  detour(job, v);
  detour(chord, v);
}

/// Takes the chord off an edge; the mesh is Delaunay without it.
Arrangement::Job Arrangement::lift(HalfEdge e) {
  const std::int32_t index = mesh_.chord[e];
  const Chord chord = chords_[index];
  mesh_.release(e);
  mesh_.pending.push_back(e);
  mesh_.legalize();
  return {chord.from, chord.to, chords_.remove(index)};
}

/// The vertex at the crossing x of the job with a chord that was lifted. A vertex within the weld
/// serves where it shortens both.
Vertex Arrangement::crossing_vertex(const Job& job, const Job& chord, Point x) {
  if (x == mesh_.point[job.from]) return job.from;
  if (x == mesh_.point[job.to]) return job.to;
  const std::size_t vertex_count = mesh_.point.size();
  mesh_.last = triangle_of(mesh_.spoke[job.from]);
  Vertex v = place(x, welding_);
  if (welding_ && !(mesh_.point[v] == x) &&
      !(may_lead_through(job, v) && may_lead_through(chord, v))) {
    v = place(x, false);
  }
  if (mesh_.point.size() > vertex_count) lead_near_chords_through(v);
  return v;
}

Vertex Arrangement::nearest_of_cavity(Point p) const {
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

/// The vertex at p; with `weld`, one within the weld if there is one. A chord that p falls on goes
/// back to the jobs, in two parts.
Vertex Arrangement::place(Point p, bool weld) {
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
    const Job chord = lift(at.edge);
    at = mesh_.locate<false>(p, mesh_.last);
    mesh_.dig(p, triangle_of(at.edge));
    const Vertex v = mesh_.fill(p);
    detour(chord, v);
    return v;
  }
  mesh_.dig(p, triangle_of(at.edge));
  const Vertex near = weld ? nearest_of_cavity(p) : kNone;
  return near != kNone ? near : mesh_.fill(p);
}

/// Chords that pass the new vertex v within the weld go back to the jobs, through v.
void Arrangement::lead_near_chords_through(Vertex v) {
  if (!welding_) return;
  crossed_.clear();
  const HalfEdge first = mesh_.spoke[v];
  HalfEdge e = first;
  do {
    const HalfEdge h = next(e);
    if (mesh_.is_constrained(h)) {
      const Job chord{mesh_.origin(h), mesh_.target(h), chords_[mesh_.chord[h]].load};
      if (passes(chord, v)) crossed_.push_back({chord.from, chord.to});
    }
    e = mesh_.twin(previous(e));
  } while (e != first && e >= 0);
  for (const Edge& edge : crossed_) {
    const HalfEdge h = mesh_.find(edge.from, edge.to);
    if (h != kNone && mesh_.is_constrained(h)) detour(lift(h), v);
  }
}

}  // namespace sfumato::mesh
