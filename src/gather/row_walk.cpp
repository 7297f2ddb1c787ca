#include "gather/row_walk.hpp"

#include <algorithm>
#include <cmath>

#include "base/half_edge.hpp"
#include "gather/kernels/end_tree.hpp"

namespace sfumato::gather {
namespace {

using mesh::TriangleMesh;

/// A point is found within few steps from the triangle that single precision gave.
constexpr int kSteps = 64;

/// A point on a curve is moved off it by so much of the edge: it sees little else.
constexpr double kOffSource = 1e-7;
/// One on a corner, by so much of the triangle, as when points are located in single precision.
constexpr double kOffCorner = 1e-3;

/// Where the ray cuts the edge, as a fraction from a to b.
double cut(Vec2 a, Vec2 b, Vec2 ray) {
  const double along = cross(ray, b - a);
  return along == 0 ? 0 : std::clamp(-cross(ray, a) / along, 0.0, 1.0);
}

}  // namespace

RowWalk::RowWalk(const Context& context, const TriangleMesh& mesh, const RowSources& sources,
                 const RowOptions& options)
    : poll_(context), mesh_(mesh), sources_(sources), options_(options) {}

void RowWalk::add(Vec2 p, std::uint32_t near, std::vector<RowTerm>& out) {
  const std::int32_t found = find(p, near);
  if (found == mesh::kNone) return;
  const auto triangle = static_cast<std::uint32_t>(found);
  p_ = off_corners_and_sources(triangle, p);
  found_.clear();
  for (std::uint32_t h = 3 * triangle; h < 3 * triangle + 3; ++h) {
    waiting_.push_back({h, seen(mesh_.origin(h)), seen(mesh_.target(h))});
  }
  while (!waiting_.empty()) {
    const Window window = waiting_.back();
    waiting_.pop_back();
    if (poll_.cancelled()) return waiting_.clear();
    follow(window);
  }
  add_ends();
  store(out);
}

/// The triangle that p lies in. Walks over the edge that has p farthest on its other side; where
/// that does not end, all are looked at.
std::int32_t RowWalk::find(Vec2 p, std::uint32_t near) const {
  std::uint32_t t = near;
  for (int step = 0; step < kSteps; ++step) {
    double farthest = 0;
    std::int32_t exit = -1;
    for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
      const Vec2 a = mesh_.vertex_position[mesh_.origin(h)];
      const double side = cross(mesh_.vertex_position[mesh_.target(h)] - a, p - a);
      if (side >= farthest) continue;
      farthest = side;
      exit = static_cast<std::int32_t>(h);
    }
    if (exit < 0) return static_cast<std::int32_t>(t);
    const std::int32_t twin = mesh_.half_edge_twin[static_cast<std::uint32_t>(exit)];
    if (twin == mesh::kNone) return mesh::kNone;  // the hull is convex
    t = static_cast<std::uint32_t>(twin) / 3;
  }
  return find_triangle(mesh_, p);
}

Vec2 RowWalk::off_corners_and_sources(std::uint32_t triangle, Vec2 p) const {
  Vec2 center;
  for (std::uint32_t h = 3 * triangle; h < 3 * triangle + 3; ++h)
    center = center + mesh_.vertex_position[mesh_.origin(h)] / 3;
  Vec2 moved = p;
  for (std::uint32_t h = 3 * triangle; h < 3 * triangle + 3; ++h) {
    const Vec2 a = mesh_.vertex_position[mesh_.origin(h)];
    const Vec2 along = mesh_.vertex_position[mesh_.target(h)] - a;
    if (p == a) return lerp(p, center, kOffCorner);
    if (sources_.at_half_edge[h] < 0 || cross(along, p - a) > 0) continue;
    moved = moved + kOffSource * Vec2{-along.y, along.x};
  }
  return moved;
}

void RowWalk::follow(const Window& window) {
  const std::int32_t source = sources_.at_half_edge[window.half_edge];
  if (source >= 0) return integrate(window, static_cast<std::uint32_t>(source));
  if (source == kBarrierSource) return;
  const std::int32_t twin = mesh_.half_edge_twin[window.half_edge];
  if (twin != mesh::kNone) pass(window, static_cast<std::uint32_t>(twin));
}

void RowWalk::pass(const Window& window, std::uint32_t twin) {
  const Vec2 apex = seen(mesh_.apex(twin));
  const bool reaches_right = cross(window.right, apex) > 0;
  const bool reaches_left = cross(apex, window.left) > 0;
  if (reaches_right) {
    waiting_.push_back({next_half_edge(twin), window.right, reaches_left ? apex : window.left});
  }
  if (reaches_left) {
    waiting_.push_back(
        {previous_half_edge(twin), reaches_right ? apex : window.right, window.left});
  }
}

void RowWalk::integrate(const Window& window, std::uint32_t source) {
  const Vec2 a = seen(mesh_.origin(window.half_edge));
  const Vec2 b = seen(mesh_.target(window.half_edge));
  const SeenPart part{a, b, window.right == a ? 0 : cut(a, b, window.right),
                      window.left == b ? 1 : cut(a, b, window.left)};
  const double distance = part.distance(), k = sources_.weight[source];
  const auto emit = [&](const PartMoment& m) {
    add_found(source, {k * m.weight, k * m.moment}, distance);
  };
  if (is_one_term(sources_.source[source], distance)) return emit(part_moment(part));
  split_by_radius(sources_.source[source], part, emit);
}

/// What is seen of one edge on both sides of a vertex in front of it comes in two windows, one
/// after the other: they are one term where the radius is the same.
void RowWalk::add_found(std::uint32_t source, const PartMoment& part, double distance) {
  if (!(part.weight > 0)) return;
  if (!found_.empty() && found_.back().source == source &&
      is_one_term(sources_.source[source], distance)) {
    found_.back().weight += part.weight;
    found_.back().moment += part.moment;
    return;
  }
  found_.push_back({source, part.weight, part.moment, distance, 1});
}

void RowWalk::add_ends() {
  const std::span<const FreeEnd> ends = sources_.ends.all();
  const auto x = static_cast<float>(p_.x), y = static_cast<float>(p_.y);
  visit_leaves(sources_.ends.view(), {x, y, x, y}, [&](std::uint32_t leaf) {
    const std::size_t first = std::size_t{kEndsPerLeaf} * leaf;
    for (std::size_t i = first; i < std::min(first + kEndsPerLeaf, ends.size()); ++i) {
      const EndShare share = end_share(ends[i], p_ - ends[i].position);
      if (!(share.weight > 0)) continue;
      found_.push_back({sources_.of_end(i, share.is_positive()), share.weight, 0,
                        std::fabs(share.across), std::fabs(share.half_sine)});
    }
    return true;
  });
}

void RowWalk::store(std::vector<RowTerm>& out) const {
  double all = 0, kept = 0;
  for (const Found& f : found_) all += f.weight;
  const double least = options_.negligible * all;
  for (const Found& f : found_) kept += f.weight >= least ? f.weight : 0;
  const bool keeps_all = !(kept > 0);  // a crowd of small ones
  for (const Found& f : found_) {
    if (!keeps_all && f.weight < least) continue;
    out.push_back({f.source, static_cast<float>(f.weight / (keeps_all ? all : kept)),
                   static_cast<float>(std::clamp(f.moment / f.weight, 0.0, 1.0)),
                   static_cast<float>(f.distance), static_cast<float>(f.lean)});
  }
}

}  // namespace sfumato::gather
