#include "mesh/refiner.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "base/limit_error.hpp"
#include "base/poll.hpp"
#include "base/try.hpp"
#include "mesh/triangle_mesh.hpp"

namespace sfumato::mesh {
namespace {

/// The shortest edge, as a share of the weld, that may be required for the sake of an angle: the
/// arrangement has hardly a detail below the weld. Without this bound angles above 25 degrees could
/// make it run forever.
constexpr double kShortestEdgePerWeld = 0.25;

/// Two vertices are on one shell where their distances from its centre differ by less than this
/// share, or by less than rounding to the lattice can cause.
constexpr double kShellShare = 0.0005;
constexpr double kShellSteps = 2;

/// An off-centre lies a little nearer than the point where the new triangle would just pass (Üngör
/// 2004).
constexpr double kOffCenterShare = 0.475;

constexpr int kShrinkAttempts = 3;
constexpr std::uint32_t kSplitsPerPoll = 1024;
constexpr double kPi = 3.14159265358979323846;

/// Returns the cosine by its series: the same bits with every libm. For 0 to 33 degrees.
double cosine_of_degrees(double degrees) {
  const double x = degrees * (kPi / 180);
  double term = 1, sum = 1;
  for (int k = 2; k <= 18; k += 2) {
    term *= -x * x / (k * (k - 1));
    sum += term;
  }
  return sum;
}

double squared_length(Point a, Point b) {
  return static_cast<double>(distance_squared(a, b));
}

}  // namespace

void Refiner::set_quality(double min_angle_deg, double doubled_area, double weld,
                          double small_edge) {
  shortest_edge_ = kShortestEdgePerWeld * weld;
  small_edge2_ = small_edge * small_edge;
  const double c = cosine_of_degrees(std::clamp(min_angle_deg, 0.0, 33.0));
  const double c2 = 2 * c * c - 1;
  sin2_ = 1 - c * c;
  lens_ = c2 * c2;
  off_center_ = min_angle_deg > 0 ? kOffCenterShare * std::sqrt((1 + c) / (1 - c))
                                  : std::numeric_limits<double>::infinity();
  doubled_area_ = doubled_area;
}

bool Refiner::make_room() {
  return mesh_.has_room() || make_room(mesh_.point.size() * 7 / 4 + 64);
}

bool Refiner::make_room(std::size_t vertex_count) {
  Status status = mesh_.grow(*context_, vertex_count);
  if (status) status = memory_.reserve(*context_, origin_, mesh_.point.capacity());
  if (!status && status_.ok()) status_ = status;
  charge_lists();
  return status_.ok();
}

void Refiner::charge_lists() {
  Status status = list_charge_.raise_to(*context_, list_bytes(), "the triangle mesh");
  if (!status && status_.ok()) status_ = status;
}

/// Returns the bytes of the queues and of the mesh's lists, which follow the size of its tables.
std::size_t Refiner::list_bytes() const {
  std::size_t bytes = capacity_bytes(encroached_) + mesh_.list_bytes();
  for (const Bucket& bucket : bucket_) bytes += capacity_bytes(bucket.items);
  return bytes;
}

/// Counts the pieces that a cut adds to the extracted mesh.
bool Refiner::count_pieces(const Chord& chord) {
  owner_pieces_ += static_cast<std::size_t>(chord.load.count);
  if (owner_pieces_ > kOwnersPerSegment * context_->limits.segments) {
    status_ =
        make_limit_error(&Limits::segments, "overlapping curves are cut into too many pieces");
    return false;
  }
  return true;
}

/// Queues a triangle inside the frame whose angle is too small or area too large. The smallest
/// angle faces the shortest edge: sin² = (2 area)² · l_min² / (l_0 l_1 l_2)².
void Refiner::check_triangle(std::int32_t t) {
  const Triangle& now = mesh_.triangle[t];
  if (!now.inside) return;
  const Point a = mesh_.point[now.vertex[0]];
  const Point b = mesh_.point[now.vertex[1]];
  const Point c = mesh_.point[now.vertex[2]];
  const double abx = b.x - a.x, aby = b.y - a.y;
  const double bcx = c.x - b.x, bcy = c.y - b.y;
  const double cax = a.x - c.x, cay = a.y - c.y;
  const double l0 = abx * abx + aby * aby;
  const double l1 = bcx * bcx + bcy * bcy;
  const double l2 = cax * cax + cay * cay;
  const double area2 = abx * bcy - aby * bcx;
  const double least = std::min(l0, std::min(l1, l2));
  const bool large = area2 > doubled_area_;
  if (!large && area2 * area2 * least >= sin2_ * (l0 * l1 * l2)) return;
  if (!large && std::max(l0, std::max(l1, l2)) <= small_edge2_) return;
  const HalfEdge shortest = 4 * t + (l0 == least ? 0 : l1 == least ? 1 : 2);
  if (!large && (least < shortest_edge_ * shortest_edge_ || spans_small_input_angle(shortest)))
    return;
  // Buckets by exponent and first bit of the mantissa: half a binade of squared length each.
  const int k = static_cast<int>(std::bit_cast<std::uint64_t>(least) >> 51) - 2 * 1023;
  const int index = std::clamp(k, 0, kBucketCount - 1);
  bucket_[index].items.push_back({shortest, now.stamp});
  lowest_ = std::min(lowest_, index);
}

/// Returns whether the edge joins two chords that meet at a vertex, on one shell around it:
/// splitting triangles in front of it would never end.
bool Refiner::spans_small_input_angle(HalfEdge e) const {
  if (mesh_.is_constrained(e)) return false;
  const Vertex u = mesh_.origin(e), w = mesh_.target(e);
  const std::int32_t chord_u = origin_[u].chord, chord_w = origin_[w].chord;
  if (chord_u < 0 || chord_w < 0 || chord_u == chord_w) return false;
  const Chord& a = chords_[chord_u];
  const Chord& b = chords_[chord_w];
  const Vertex joint = a.from == b.from || a.from == b.to ? a.from
                       : a.to == b.from || a.to == b.to   ? a.to
                                                          : kNone;
  if (joint == kNone) return false;
  const double r_u = std::sqrt(squared_length(mesh_.point[u], mesh_.point[joint]));
  const double r_w = std::sqrt(squared_length(mesh_.point[w], mesh_.point[joint]));
  return std::fabs(r_u - r_w) <= std::max(kShellShare * r_u, kShellSteps);
}

/// Returns whether the angle at p over the segment from a to b is at least 180° minus twice the
/// minimum angle.
bool Refiner::in_lens(Point a, Point b, Point p) const {
  const double ax = a.x - p.x, ay = a.y - p.y;
  const double bx = b.x - p.x, by = b.y - p.y;
  const double d = ax * bx + ay * by;
  return d < 0 && d * d >= lens_ * ((ax * ax + ay * ay) * (bx * bx + by * by));
}

bool Refiner::is_small(Vertex a, Vertex b) const {
  return squared_length(mesh_.point[a], mesh_.point[b]) <= small_edge2_;
}

void Refiner::check_encroachment(std::int32_t t) {
  const Triangle& now = mesh_.triangle[t];
  if (!now.inside || !((now.across[0] | now.across[1] | now.across[2]) & 1)) return;
  for (int k = 0; k < 3; ++k) {
    const HalfEdge e = 4 * t + k;
    if (!mesh_.is_constrained(e)) continue;
    const Vertex u = mesh_.origin(e), w = mesh_.target(e);
    if (in_lens(mesh_.point[u], mesh_.point[w], mesh_.apex_point(e)) && !is_small(u, w)) {
      encroached_.push_back({e, u, w});
    }
  }
}

void Refiner::check_touched() {
  mesh_.take_touched([this](std::int32_t t) {
    check_encroachment(t);
    check_triangle(t);
  });
}

/// Queues the walls of the cavity that p would encroach upon.
bool Refiner::cavity_encroaches(Point p) {
  if (!mesh_.cavity_has_chords) return false;
  bool any = false;
  const std::vector<CavityEdge>& cavity = mesh_.cavity;
  for (std::size_t i = 0; i < cavity.size(); ++i) {
    const CavityEdge& wall = cavity[i];
    if (!(wall.across & 1) || wall.across == kHull) continue;
    const Vertex from = wall.from;
    const Vertex to = cavity[i + 1 < cavity.size() ? i + 1 : 0].from;
    if (!in_lens(mesh_.point[from], mesh_.point[to], p) || is_small(from, to)) continue;
    encroached_.push_back({wall.across >> 1, to, from});
    any = true;
  }
  return any;
}

/// Returns the circumcentre, or the off-centre over the edge where that is nearer to it.
Point Refiner::steiner_point(HalfEdge edge, double off_center) const {
  const Point a = mesh_.origin_point(edge), b = mesh_.target_point(edge);
  const Point c = mesh_.apex_point(edge);
  const double bx = b.x - a.x, by = b.y - a.y;
  const double cx = c.x - a.x, cy = c.y - a.y;
  const double b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
  const double scale = 0.5 / (bx * cy - cx * by);
  double dx = (cy * b2 - by * c2) * scale;
  double dy = (bx * c2 - cx * b2) * scale;
  const double ox = 0.5 * bx - off_center * by;
  const double oy = 0.5 * by + off_center * bx;
  if (ox * ox + oy * oy < dx * dx + dy * dy) {
    dx = ox;
    dy = oy;
  }
  const double width = mesh_.width, height = mesh_.height;
  return {static_cast<std::int32_t>(std::clamp(a.x + dx, 0.0, width) + 0.5),
          static_cast<std::int32_t>(std::clamp(a.y + dy, 0.0, height) + 0.5)};
}

void Refiner::insert_free(Point p) {
  if (!make_room()) return;
  mesh_.star_cavity(p);
  origin_.push_back({VertexOrigin::kFree, 0});
}

void Refiner::refine_triangle(const Bad& bad) {
  const std::int32_t t = triangle_of(bad.shortest_edge);
  const Point p = steiner_point(bad.shortest_edge, off_center_);
  const Location at = mesh_.locate<true>(p, t);
  if (at.place == Place::on_vertex) return;
  bool changed = false;
  if (at.place == Place::blocked || (at.place == Place::on_edge && mesh_.is_wall(at.edge))) {
    if (is_small(mesh_.origin(at.edge), mesh_.target(at.edge))) return;
    changed = split_subsegment(at.edge);
  } else {
    mesh_.find_cavity(p, triangle_of(at.edge));
    if (!cavity_encroaches(p)) {
      insert_free(p);
      mesh_.take_touched([this](std::int32_t touched) { check_triangle(touched); });
      return;
    }
    changed = split_queued_subsegments();
  }
  if (changed && mesh_.triangle[t].stamp == bad.stamp) check_triangle(t);
}

/// Splits the subsegments in `encroached_` and the subsegments that become encroached by it.
/// Returns whether any was split.
bool Refiner::split_queued_subsegments() {
  bool any = false;
  while (!encroached_.empty() && status_.ok()) {
    const Subsegment s = encroached_.back();
    encroached_.pop_back();
    HalfEdge e = s.edge;
    if (mesh_.origin(e) != s.from || mesh_.target(e) != s.to) e = mesh_.find_edge(s.from, s.to);
    if (e != kNone && mesh_.is_constrained(e)) any |= split_subsegment(e);
  }
  return any;
}

/// Returns where to cut: in the middle, or at a power of two from an end where other chords begin.
/// Chords at a small angle are then cut at equal distances and do not encroach upon each other
/// forever.
double Refiner::split_fraction(HalfEdge e, double length) const {
  const HalfEdge f = mesh_.twin(e);
  const bool at_origin = mesh_.is_wall(previous(e)) || mesh_.is_wall(next(f));
  const bool at_target = mesh_.is_wall(next(e)) || mesh_.is_wall(previous(f));
  if (!at_origin && !at_target) return 0.5;
  double shell = 1;
  while (length > 3 * shell) shell *= 2;
  while (length < 1.5 * shell) shell *= 0.5;
  const double s = shell / length;
  return at_target ? 1 - s : s;
}

/// Finds the lattice point at fraction s of e, or one beside it where rounding would turn a
/// triangle over.
bool Refiner::split_point(HalfEdge e, double s, Point& p) const {
  const Point a = mesh_.origin_point(e), b = mesh_.target_point(e);
  const double x = a.x + s * (b.x - a.x);
  const double y = a.y + s * (b.y - a.y);
  p = {static_cast<std::int32_t>(x + 0.5), static_cast<std::int32_t>(y + 0.5)};
  if (mesh_.can_split_edge(e, p)) return true;
  for (int corner = 0; corner < 4; ++corner) {
    p = {static_cast<std::int32_t>(x) + (corner & 1), static_cast<std::int32_t>(y) + (corner >> 1)};
    if (mesh_.can_split_edge(e, p)) return true;
  }
  return false;
}

bool Refiner::split_subsegment(HalfEdge e) {
  const Vertex a = mesh_.origin(e), b = mesh_.target(e);
  const double length = std::sqrt(squared_length(mesh_.point[a], mesh_.point[b]));
  if (length < 2 * shortest_edge_) return false;
  const double s = split_fraction(e, length);
  Point p;
  if (!split_point(e, s, p) || !make_room()) return false;
  const std::int32_t index = mesh_.chord[e];
  const Chord& chord = chords_[index];
  if (!count_pieces(chord)) return false;
  const double at_a = fraction_at(chord, index, a, origin_[a]);
  const double at_b = fraction_at(chord, index, b, origin_[b]);
  mesh_.split_edge(e, p);
  origin_.push_back({index, static_cast<float>(at_a + (at_b - at_a) * s)});
  check_touched();
  return true;
}

bool Refiner::next_bad(Bad& bad) {
  for (; lowest_ < kBucketCount; ++lowest_) {
    Bucket& bucket = bucket_[lowest_];
    if (bucket.head < bucket.items.size()) {
      bad = bucket.items[bucket.head++];
      return true;
    }
    bucket.items.clear();
    bucket.head = 0;
  }
  return false;
}

/// Empties both queues.
Status Refiner::run(const Context& context) {
  context_ = &context;
  status_ = ok_status();
  mesh_.tracking = true;
  split_queued_subsegments();
  Bad bad;
  RarePoll<kSplitsPerPoll> poll(context);
  std::uint32_t step = 0;
  while (status_.ok() && next_bad(bad)) {
    if (mesh_.triangle[triangle_of(bad.shortest_edge)].stamp != bad.stamp) continue;
    if (poll.cancelled()) status_ = context.cancel_status();
    refine_triangle(bad);
    if (++step % kSplitsPerPoll == 0) charge_lists();
  }
  mesh_.tracking = false;
  mesh_.take_touched([](std::int32_t) {});
  encroached_.clear();
  for (Bucket& bucket : bucket_) {
    bucket.items.clear();
    bucket.head = 0;
  }
  lowest_ = kBucketCount;
  return status_;
}

/// Returns the least number of triangles of an area if none is too large. Near curves refinement
/// may end before that bound.
double Refiner::least_triangles(double area) const {
  const double finest = 2 * shortest_edge_;
  return area / std::max(0.5 * doubled_area_, finest * finest);
}

Status Refiner::refine_all(const Context& context, double area) {
  context_ = &context;
  status_ = ok_status();
  const double least = least_triangles(area);
  if (least > static_cast<double>(context.limits.triangles)) {
    return limit_error(context.limits, &Limits::triangles, "triangles in one layer");
  }
  const auto least_vertices = static_cast<std::size_t>(least / 2);
  if (!make_room(std::max(3 * mesh_.point.size(), least_vertices))) return status_;
  const auto count = static_cast<std::int32_t>(mesh_.triangle.size());
  RarePoll<4096> poll(context);
  for (std::int32_t t = 0; t < count; ++t) {
    if (poll.cancelled()) return context.cancel_status();
    check_encroachment(t);
    check_triangle(t);
  }
  return run(context);
}

Status Refiner::refine_touched(const Context& context) {
  context_ = &context;
  status_ = ok_status();
  check_touched();
  return run(context);
}

HalfEdge Refiner::longest_edge(std::int32_t t) const {
  HalfEdge longest = 4 * t;
  std::int64_t most = 0;
  for (HalfEdge e = 4 * t; e < 4 * t + 3; ++e) {
    const std::int64_t length2 = distance_squared(mesh_.origin_point(e), mesh_.target_point(e));
    if (length2 > most) {
      most = length2;
      longest = e;
    }
  }
  return longest;
}

void Refiner::halve_longest_edge(std::int32_t t) {
  const HalfEdge e = longest_edge(t);
  if (mesh_.is_constrained(e)) {
    split_subsegment(e);
    return;
  }
  const Point a = mesh_.origin_point(e), b = mesh_.target_point(e);
  const Point p{a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2};
  const Location at = mesh_.locate<true>(p, t);
  if (at.place == Place::inside || (at.place == Place::on_edge && !mesh_.is_wall(at.edge))) {
    mesh_.find_cavity(p, triangle_of(at.edge));
    insert_free(p);
    check_touched();
  }
}

/// Inserts a vertex at the circumcentre, or, where chords are in the way, in the middle of these
/// while they are longer than the bound; else in the middle of the longest edge.
void Refiner::shrink(Target target, double smallest_edge2) {
  const std::int32_t t = target.triangle;
  const auto is_long = [&](HalfEdge e) {
    return squared_length(mesh_.origin_point(e), mesh_.target_point(e)) > smallest_edge2;
  };
  for (int attempt = 0; attempt < kShrinkAttempts; ++attempt) {
    if (mesh_.triangle[t].stamp != target.stamp || !status_.ok()) return;
    if (!is_long(longest_edge(t))) return;
    const Point p = steiner_point(4 * t, std::numeric_limits<double>::infinity());
    const Location at = mesh_.locate<true>(p, t);
    if (at.place == Place::on_vertex) break;
    if (at.place == Place::blocked || (at.place == Place::on_edge && mesh_.is_wall(at.edge))) {
      if (!is_long(at.edge) || !split_subsegment(at.edge)) break;
      continue;
    }
    mesh_.find_cavity(p, triangle_of(at.edge));
    const std::size_t queued = encroached_.size();
    if (!cavity_encroaches(p)) {
      insert_free(p);
      check_touched();
      return;
    }
    const Subsegment wall = encroached_[queued];
    encroached_.resize(queued);
    if (!is_long(wall.edge) || !split_subsegment(wall.edge)) break;
  }
  if (mesh_.triangle[t].stamp == target.stamp && status_.ok()) halve_longest_edge(t);
}

Status Refiner::refine_targets(const Context& context, std::span<const Target> targets,
                               double smallest_edge) {
  context_ = &context;
  status_ = ok_status();
  mesh_.tracking = true;
  RarePoll<kSplitsPerPoll> poll(context);
  for (const Target& target : targets) {
    if (poll.cancelled()) return context.cancel_status();
    shrink(target, smallest_edge * smallest_edge);
    if (!status_.ok()) return status_;
  }
  SFUMATO_TRY(context.check());
  return run(context);
}

}  // namespace sfumato::mesh
