#include "mesh/triangulation.hpp"

#include <algorithm>

#include "base/limit_error.hpp"
#include "base/try.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato::mesh {
namespace {

/// After this many steps a walk breaks ties at random: among chords it could go round in circles.
constexpr int kPatientSteps = 64;

}  // namespace

void Triangulation::start(std::int32_t domain_width, std::int32_t domain_height) {
  width = domain_width;
  height = domain_height;
  for (const Point p : {Point{0, 0}, Point{width, 0}, Point{width, height}, Point{0, height}}) {
    add_vertex(p);
  }
  triangle = {{{0, 1, 2}, 0, {kHull, kHull, 4 << 1}, 0, 0},
              {{0, 2, 3}, 0, {2 << 1, kHull, kHull}, 0, 0}};
  spoke = {0, 1, 2, 6};
}

Status Triangulation::grow(const Context& context, std::size_t vertex_count) {
  const std::size_t vertices =
      std::min(std::max(vertex_count, point.size() + 1), context.limits.triangles / 2);
  const std::size_t triangles = 2 * vertices;
  if (triangle.size() + 2 > triangles) {
    return limit_error(context.limits, &Limits::triangles, "triangles in one layer");
  }
  SFUMATO_TRY(memory_.reserve(context, point, vertices));
  SFUMATO_TRY(memory_.reserve(context, spoke, vertices));
  SFUMATO_TRY(memory_.reserve(context, triangle, triangles));
  SFUMATO_TRY(memory_.reserve(context, changed, triangle.capacity()));
  return memory_.resize(context, chord, 4 * triangle.capacity());
}

Status Triangulation::copy_from(const Context& context, const Triangulation& other) {
  clear_lists();
  triangle.clear();
  logged_slots_ = 0;
  SFUMATO_TRY(grow(context, other.point.size() * 9 / 8 + 256));
  SFUMATO_TRY(memory_.assign(context, other.point, point));
  SFUMATO_TRY(memory_.assign(context, other.spoke, spoke));
  SFUMATO_TRY(memory_.assign(context, other.triangle, triangle));
  SFUMATO_TRY(memory_.reserve(context, log_, triangle.size()));
  std::copy_n(other.chord.begin(), std::min(chord.size(), 4 * triangle.size()), chord.begin());
  for (Triangle& t : triangle) t.listed = 0;
  width = other.width;
  height = other.height;
  logged_slots_ = static_cast<std::int32_t>(triangle.size());
  return ok_status();
}

// A change of a triangle may change its neighbours' entries across the common edge, and the
// half-edge of each vertex that the triangle has or had.
void Triangulation::take_back(const Triangulation& other) {
  point.resize(other.point.size());
  spoke.resize(other.spoke.size());
  triangle.resize(other.triangle.size());
  for (const std::int32_t t : log_) {
    take_back_slot(other, t);
    const Triangle& then = other.triangle[t];
    for (int k = 0; k < 3; ++k) {
      spoke[then.vertex[k]] = other.spoke[then.vertex[k]];
      if (then.across[k] != kHull) take_back_slot(other, triangle_of(then.across[k] >> 1));
    }
  }
  clear_lists();
}

void Triangulation::take_back_slot(const Triangulation& other, std::int32_t t) {
  triangle[t] = other.triangle[t];
  triangle[t].listed = 0;
  std::copy_n(other.chord.begin() + 4 * static_cast<std::size_t>(t), 4,
              chord.begin() + 4 * static_cast<std::size_t>(t));
}

void Triangulation::set_across(HalfEdge e, std::int32_t value, std::int32_t chord_index) {
  triangle[triangle_of(e)].across[corner_of(e)] = value;
  if (value & 1) chord[e] = chord_index;
}

/// Makes e and the half-edge in `value` twins.
void Triangulation::set_adjacent(HalfEdge e, std::int32_t value, std::int32_t chord_index) {
  set_across(e, value, chord_index);
  if (value == kHull) return;
  const HalfEdge f = value >> 1;
  triangle[triangle_of(f)].across[corner_of(f)] = e << 1 | (value & 1);
}

void Triangulation::constrain(HalfEdge e, std::int32_t chord_index) {
  const HalfEdge f = twin(e);
  set_across(e, f << 1 | 1, chord_index);
  set_across(f, e << 1 | 1, chord_index);
  touch_sides(e);
}

void Triangulation::unconstrain(HalfEdge e) {
  const HalfEdge f = twin(e);
  set_across(e, f << 1, kNone);
  set_across(f, e << 1, kNone);
  touch_sides(e);
}

void Triangulation::touch_around(Vertex v) {
  const HalfEdge first = spoke[v];
  HalfEdge e = first;
  do {
    touch(triangle_of(e));
    e = twin(previous(e));
  } while (e != first && e >= 0);
  if (e == first) return;
  // v is a corner of the domain: the other way round.
  for (HalfEdge f = twin(first); f >= 0; f = twin(next(f))) touch(triangle_of(f));
}

HalfEdge Triangulation::find_edge(Vertex u, Vertex w) const {
  const HalfEdge first = spoke[u];
  HalfEdge e = first;
  do {
    if (target(e) == w) return e;
    e = twin(previous(e));
  } while (e != first && e >= 0);
  if (e == first) return kNone;
  // u is a corner of the domain: the other way round.
  for (HalfEdge f = twin(first); f >= 0; f = twin(e)) {
    e = next(f);
    if (target(e) == w) return e;
  }
  return kNone;
}

template <bool blocked_by_walls>
Location Triangulation::locate(Point p, std::int32_t start_triangle) {
  std::int32_t t = start_triangle;
  HalfEdge entered = kNone;
  for (int step = 0;; ++step) {
    const Triangle& here = triangle[t];
    int first = 0;
    if (step >= kPatientSteps) {
      walk_state_ = walk_state_ * 1664525u + 1013904223u;
      first = static_cast<int>((walk_state_ >> 16) % 3);
    }
    HalfEdge exit = kNone;
    HalfEdge on[3];
    int on_count = 0;
    for (int j = 0; j < 3; ++j) {
      const int k = first + j < 3 ? first + j : first + j - 3;
      const HalfEdge e = 4 * t + k;
      if (e == entered) continue;
      const std::int64_t side =
          orient2d(point[here.vertex[k]], point[here.vertex[kNextCorner[k]]], p);
      if (side < 0) {
        exit = e;
        break;
      }
      if (side == 0) on[on_count++] = e;
    }
    if (exit == kNone) {
      last = t;
      if (on_count == 0) return {Place::inside, 4 * t};
      if (on_count == 1) return {Place::on_edge, on[0]};
      return {Place::on_vertex, target(on[0]) == origin(on[1]) ? on[1] : on[0]};
    }
    const std::int32_t beyond = here.across[corner_of(exit)];
    if (beyond == kHull || (blocked_by_walls && (beyond & 1))) return {Place::blocked, exit};
    entered = beyond >> 1;
    t = triangle_of(entered);
  }
}

template Location Triangulation::locate<true>(Point, std::int32_t);
template Location Triangulation::locate<false>(Point, std::int32_t);

void Triangulation::find_cavity(Point p, std::int32_t start_triangle) {
  cavity.clear();
  cavity_has_chords = false;
  dead_.clear();
  dead_.push_back(start_triangle);
  stack_.clear();
  for (int k = 2; k >= 0; --k) stack_.push_back(4 * start_triangle + k);
  while (!stack_.empty()) {
    const HalfEdge e = stack_.back();
    stack_.pop_back();
    const Triangle& t = triangle[triangle_of(e)];
    const std::int32_t beyond = t.across[corner_of(e)];
    std::int32_t wall_chord = kNone;
    if (beyond & 1) {
      wall_chord = chord[e];
      cavity_has_chords |= beyond != kHull;
    } else {
      const HalfEdge f = beyond >> 1;
      if (circumcircle_contains(triangle[triangle_of(f)], p)) {
        dead_.push_back(triangle_of(f));
        stack_.push_back(previous(f));
        stack_.push_back(next(f));
        continue;
      }
    }
    cavity.push_back({t.vertex[corner_of(e)], beyond, wall_chord});
  }
}

Vertex Triangulation::star_cavity(Point p) {
  const Vertex v = add_vertex(p);
  const std::int16_t inside = triangle[dead_[0]].inside;
  const std::size_t count = cavity.size();
  while (dead_.size() < count) dead_.push_back(add_triangle());
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t after = i + 1 < count ? i + 1 : 0;
    const std::size_t before = i > 0 ? i - 1 : count - 1;
    const std::int32_t t = dead_[i];
    Triangle& fan = triangle[t];
    fan.vertex[0] = cavity[i].from;
    fan.vertex[1] = cavity[after].from;
    fan.vertex[2] = v;
    fan.across[1] = (4 * dead_[after] + 2) << 1;
    fan.across[2] = (4 * dead_[before] + 1) << 1;
    fan.inside = inside;
    set_adjacent(4 * t, cavity[i].across, cavity[i].chord);
    spoke[cavity[i].from] = 4 * t;
    touch(t);
  }
  spoke[v] = 4 * dead_[0] + 2;
  last = dead_[0];
  return v;
}

void Triangulation::flip_edge(HalfEdge e) {
  const HalfEdge f = twin(e);
  const HalfEdge e_next = next(e), f_next = next(f);
  Triangle& t = triangle[triangle_of(e)];
  Triangle& u = triangle[triangle_of(f)];
  const Vertex a = origin(e), b = origin(f), c = apex(e), d = apex(f);
  const std::int32_t across_bc = across(e_next), chord_bc = chord[e_next];
  const std::int32_t across_ad = across(f_next), chord_ad = chord[f_next];
  // (a, b, c) + (b, a, d) become (a, d, c) + (b, c, d); e is now a → d and f is b → c.
  t.vertex[corner_of(e_next)] = d;
  u.vertex[corner_of(f_next)] = c;
  set_adjacent(e, across_ad, chord_ad);
  set_adjacent(f, across_bc, chord_bc);
  t.across[corner_of(e_next)] = f_next << 1;
  u.across[corner_of(f_next)] = e_next << 1;
  spoke[a] = e;
  spoke[b] = f;
  spoke[c] = previous(e);
  spoke[d] = previous(f);
  touch(triangle_of(e));
  touch(triangle_of(f));
}

void Triangulation::legalize() {
  while (!pending.empty()) {
    const HalfEdge e = pending.back();
    pending.pop_back();
    const std::int32_t beyond = across(e);
    if (beyond & 1) continue;
    const HalfEdge f = beyond >> 1;
    if (!circumcircle_contains(triangle[triangle_of(e)], apex_point(f))) continue;
    flip_edge(e);
    for (const HalfEdge outer : {e, previous(e), f, previous(f)}) pending.push_back(outer);
  }
}

bool Triangulation::can_split_edge(HalfEdge e, Point p) const {
  const auto sees = [&](HalfEdge h) {
    return orient2d(origin_point(h), p, apex_point(h)) > 0 &&
           orient2d(p, target_point(h), apex_point(h)) > 0;
  };
  return sees(e) && sees(twin(e));
}

/// Makes (a, v, apex) and a new (v, b, apex) of (a, b, apex). Returns the half-edge v → b.
HalfEdge Triangulation::bisect_triangle(HalfEdge e, Vertex v) {
  const std::int32_t n = add_triangle();
  const std::int32_t t = triangle_of(e);
  const HalfEdge e_next = next(e);
  const Vertex a = origin(e), b = target(e), c = apex(e);
  triangle[n] = {{v, b, c}, 0, {kHull, kHull, kHull}, triangle[t].inside, 0};
  triangle[t].vertex[corner_of(e_next)] = v;
  set_adjacent(4 * n + 1, across(e_next), chord[e_next]);
  set_adjacent(4 * n + 2, e_next << 1, kNone);
  spoke[a] = e;
  spoke[b] = 4 * n + 1;
  spoke[c] = 4 * n + 2;
  spoke[v] = 4 * n;
  touch(t);
  touch(n);
  return 4 * n;
}

Vertex Triangulation::split_edge(HalfEdge e, Point p) {
  const HalfEdge f = twin(e);
  const std::int32_t line = chord[e];
  const Vertex v = add_vertex(p);
  const HalfEdge e_far = bisect_triangle(e, v);
  const HalfEdge f_far = bisect_triangle(f, v);
  set_adjacent(e, f_far << 1 | 1, line);
  set_adjacent(f, e_far << 1 | 1, line);
  chord[e_far] = line;
  chord[f_far] = line;
  // p may lie off the edge: the spokes to the two apexes can be illegal too.
  for (const HalfEdge h : {e_far, f_far}) {
    pending.push_back(next(h));
    pending.push_back(previous(h));
  }
  pending.push_back(previous(e));
  pending.push_back(previous(f));
  legalize();
  last = triangle_of(spoke[v]);
  return v;
}

}  // namespace sfumato::mesh
