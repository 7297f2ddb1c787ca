#include "gather/ends/free_ends.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "base/poll.hpp"
#include "base/spatial_order.hpp"
#include "base/try.hpp"
#include "curves/front_share.hpp"
#include "gather/ends/free_ends_search.hpp"
#include "gather/kernels/end_tree.hpp"

namespace sfumato::gather {
namespace {

/// Beside a long straight curve its own weight is g(φ)/r², with g(90°) = π/4: near it, the term
/// makes the turn from one side to the other nearly even.
constexpr double kWeight = 0.8;

/// Ends that an extension may add before the tree must be rebuilt: the curve that moves has two,
/// and each curve that it crosses may have two more.
constexpr std::uint32_t kSpareEnds = 60;

/// Returns the box of an end's reach, rounded outwards.
EndBox reach_box(const FreeEnd& end) {
  const auto [x, y] = end.position;
  const auto down = [](double v) { return std::nextafter(static_cast<float>(v), -HUGE_VALF); };
  const auto up = [](double v) { return std::nextafter(static_cast<float>(v), HUGE_VALF); };
  return {down(x - end.reach), down(y - end.reach), up(x + end.reach), up(y + end.reach)};
}

/// Compares terms apart from rounding, and from facts that the mesh around an end decides.
bool have_the_same_term(const FreeEnd& a, float unit_a, const FreeEnd& b, float unit_b) {
  constexpr double kSame = 1e-4;
  const auto about = [](double x, double y) { return std::fabs(x - y) <= kSame * std::fabs(x); };
  return a.position == b.position && a.positive == b.positive && a.negative == b.negative &&
         a.blur_positive == b.blur_positive && a.blur_negative == b.blur_negative &&
         length(a.direction - b.direction) <= kSame && about(a.reach, b.reach) &&
         std::fabs(a.bend - b.bend) * a.reach <= kSame &&
         about(double{a.weight} * unit_a, double{b.weight} * unit_b);
}

/// Returns the share τ of the positive side in z_e.
double positive_share(const FreeEnd& end, const EndShare& share) {
  const float radius = share.is_positive() ? end.blur_positive : end.blur_negative;
  // β at the distance from the line of the curve's last segment.
  const double front = curves::front_share(std::fabs(share.across), double{radius});
  return 0.5 + 0.5 * share.half_sine * (2 * front - 1);
}

}  // namespace

Vec2 FreeEnd::unbent(Vec2 d) const {
  const double sine = bend * length(d);
  const double cosine = std::sqrt(std::max(0.0, 1 - sine * sine));
  return {cosine * d.x + sine * d.y, cosine * d.y - sine * d.x};
}

EndShare end_share(const FreeEnd& end, Vec2 d) {
  const double r_squared = length_squared(d);
  const double x = r_squared / (end.reach * end.reach);
  if (!(x < 1) || !(r_squared > 0)) return {};
  const Vec2 u = end.unbent(d);
  const double r = length(u);
  const double across = cross(end.direction, u), ahead = dot(end.direction, u);
  // sin(φ/2), each form where it has no cancellation.
  const double half_sine = ahead > 0 ? across / std::sqrt(2 * r * (r + ahead))
                                     : std::copysign(std::sqrt(0.5 * (1 - ahead / r)), across);
  return {kWeight * end.weight / r_squared * ((1 - x) * (1 - x) / (1 + kEndKnee * x)), half_sine,
          across};
}

Result<FreeEnds> FreeEnds::create(Context& context, const mesh::TriangleMesh& mesh,
                                  const curves::SegmentAttributes& attributes, Vec2 origin,
                                  float weight_unit, bool extendable,
                                  const curves::SegmentAttributes* beside) {
  FreeEnds ends;
  SFUMATO_TRY_ASSIGN(
      auto&& found, find_free_ends(context, mesh, attributes, ends.memory_, &ends.tables_, beside));
  ends.base_channels_ = attributes.base_channels;
  ends.origin_ = origin;
  ends.weight_unit_ = weight_unit;
  ends.end_ = std::move(found);
  for (FreeEnd& end : ends.end_) end = ends.relative(end);
  if (!extendable) ends.tables_ = {};
  SFUMATO_TRY(ends.sort(context));
  SFUMATO_TRY(ends.build_tree(context, extendable ? kSpareEnds : 0));
  return ends;
}

/// Returns an end in its stored form: its position relative to the origin, its weight in units.
FreeEnd FreeEnds::relative(FreeEnd end) const {
  end.position = end.position - origin_;
  end.weight /= weight_unit_;
  return end;
}

/// Sorts the ends so that neighbours in the list are near each other.
Status FreeEnds::sort(Context& context) {
  TableMemory scratch("free ends of curves");
  std::vector<Vec2> position;
  std::vector<FreeEnd> sorted;
  SFUMATO_TRY(scratch.reserve(context, position, end_.size()));
  SFUMATO_TRY(memory_.reserve(context, sorted, end_.size()));
  for (const FreeEnd& end : end_) position.push_back(end.position);
  std::vector<std::uint32_t> order;
  SFUMATO_TRY(spatial_order(context, position, scratch, order));
  for (const std::uint32_t i : order) sorted.push_back(end_[i]);
  end_.swap(sorted);
  memory_.free(sorted);
  return ok_status();
}

/// Builds the tree, with leaves for some more ends.
Status FreeEnds::build_tree(Context& context, std::uint32_t spare) {
  const auto count = static_cast<std::uint32_t>(end_.size());
  leaf_count_ = std::bit_ceil((count + spare + kEndsPerLeaf - 1) / kEndsPerLeaf);
  if (count + spare == 0) {
    leaf_count_ = 0;
    return ok_status();
  }
  memory_.free(box_);
  SFUMATO_TRY(memory_.reserve(context, end_, count + spare));
  SFUMATO_TRY(memory_.reserve(context, term_, count + spare));
  SFUMATO_TRY(memory_.resize(context, box_, 2 * std::size_t{leaf_count_}));
  term_.clear();
  for (std::uint32_t i = 0; i < count; ++i) {
    term_.push_back(term_of(end_[i]));
    EndBox& leaf = box_[leaf_count_ + i / kEndsPerLeaf];
    leaf = united(leaf, reach_box(end_[i]));
  }
  for (std::uint32_t i = leaf_count_ - 1; i > 0; --i)
    box_[i] = united(box_[2 * i], box_[2 * i + 1]);
  return context.check();
}

EndTerm FreeEnds::term_of(const FreeEnd& end) const {
  EndTerm term{};
  term.x = static_cast<float>(end.position.x), term.y = static_cast<float>(end.position.y);
  term.direction_x = static_cast<float>(end.direction.x);
  term.direction_y = static_cast<float>(end.direction.y);
  term.bend = static_cast<float>(end.bend);
  term.inverse_reach_squared = end.reach > 0 ? static_cast<float>(1 / (end.reach * end.reach))
                                             : std::numeric_limits<float>::infinity();
  term.weight = static_cast<float>(kWeight * end.weight);
  term.blur_positive = end.blur_positive, term.blur_negative = end.blur_negative;
  std::ranges::copy(end.positive.channel, term.positive);
  std::ranges::copy(end.negative.channel, term.negative);
  return term;
}

EndTree FreeEnds::view() const {
  return {term_.data(), box_.data(), static_cast<std::uint32_t>(end_.size()), leaf_count_};
}

/// Does gather::visit_leaves.
template <class Visit>
void FreeEnds::visit_leaves_at(Vec2 p, Visit visit) const {
  const auto x = static_cast<float>(p.x), y = static_cast<float>(p.y);
  visit_leaves(view(), {x, y, x, y}, visit);
}

std::span<const FreeEnd> FreeEnds::of_leaf(std::uint32_t leaf) const {
  const std::size_t first = std::size_t{kEndsPerLeaf} * leaf;
  if (first >= end_.size()) return {};
  return std::span(end_).subspan(first, std::min<std::size_t>(kEndsPerLeaf, end_.size() - first));
}

bool FreeEnds::reach(Vec2 p) const {
  bool found = false;
  visit_leaves_at(p, [&](std::uint32_t leaf) {
    for (const FreeEnd& end : of_leaf(leaf)) {
      found |= length_squared(p - end.position) < end.reach * end.reach;
    }
    return !found;
  });
  return found;
}

EndBox FreeEnds::box() const {
  const EndTree tree = view();
  return tree.leaf_count > 0 ? tree.box[1] : EndBox{};
}

bool FreeEnds::may_reach(const EndBox& box) const {
  bool found = false;
  visit_leaves(view(), box, [&](std::uint32_t) {
    found = true;
    return false;
  });
  return found;
}

bool FreeEnds::is_in(const FreeEnds& other, const FreeEnd& end) const {
  bool found = false;
  other.visit_leaves_at(end.position, [&](std::uint32_t leaf) {
    for (const FreeEnd& candidate : other.of_leaf(leaf)) {
      found |= have_the_same_term(end, weight_unit_, candidate, other.weight_unit_);
    }
    return !found;
  });
  return found;
}

/// Returns the ends that pass the test.
template <class Test>
Result<FreeEnds> FreeEnds::those(Context& context, Test test) const {
  FreeEnds rest;
  rest.base_channels_ = base_channels_;
  rest.weight_unit_ = weight_unit_;
  RarePoll<1024> poll(context);
  for (const FreeEnd& end : end_) {
    if (poll.cancelled()) return context.cancel_status();
    if (!(end.reach > 0) || !test(end)) continue;
    SFUMATO_TRY(rest.memory_.push_back(context, rest.end_, end));
  }
  SFUMATO_TRY(rest.build_tree(context, 0));
  return rest;
}

Status FreeEnds::copy_from(const Context& context, const FreeEnds& before) {
  base_channels_ = before.base_channels_;
  origin_ = before.origin_;
  weight_unit_ = before.weight_unit_;
  leaf_count_ = before.leaf_count_;
  extended_ = &before;
  gone_.clear();
  fresh_.clear();
  SFUMATO_TRY(memory_.assign(context, before.end_, end_, kSpareEnds));
  SFUMATO_TRY(memory_.assign(context, before.term_, term_, kSpareEnds));
  SFUMATO_TRY(memory_.assign(context, before.box_, box_));
  const std::size_t vertices = before.tables_.meeting.size();
  return tables_.memory.assign(context, before.tables_.meeting, tables_.meeting, vertices / 8);
}

Result<FreeEnds> FreeEnds::extend(Context& context, const mesh::TriangleMesh& mesh,
                                  const curves::SegmentAttributes& attributes,
                                  const FreeEnds& before, const mesh::TriangleMesh& with,
                                  std::span<const std::uint8_t> is_watched,
                                  std::span<const std::uint8_t> is_same, FreeEnds* used) {
  FreeEnds ends;
  if (used) ends = std::move(*used);
  SFUMATO_TRY(ends.copy_from(context, before));
  SFUMATO_TRY(ends.find_again(context, mesh, attributes, with, is_watched, is_same));
  return ends;
}

void FreeEnds::forget_changes() {
  extended_ = nullptr;
  memory_.free(gone_);
  memory_.free(fresh_);
}

namespace {

/// Returns the watched edges of triangles that changed, each once.
Result<std::vector<std::uint32_t>> watched_edges(const Context& context,
                                                 const mesh::TriangleMesh& mesh,
                                                 std::span<const std::uint8_t> is_watched,
                                                 std::span<const std::uint8_t> is_same,
                                                 TableMemory& memory) {
  std::vector<std::uint32_t> edges;
  RarePoll<4096> poll(context);
  for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t) {
    if (t < is_same.size() && is_same[t]) continue;
    if (poll.cancelled()) return context.cancel_status();
    for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
      const std::int32_t twin = mesh.half_edge_twin[h];
      if (twin != mesh::kNone && static_cast<std::uint32_t>(twin) < h) continue;
      if (!mesh.has_segment(h, is_watched)) continue;
      SFUMATO_TRY(memory.push_back(context, edges, h));
    }
  }
  return edges;
}

/// Returns whether any of the edges comes nearer to p than the distance.
bool is_near(const mesh::TriangleMesh& mesh, std::span<const std::uint32_t> edges, const Box& box,
             Vec2 p, double distance) {
  const Vec2 beside{std::max({box.min.x - p.x, p.x - box.max.x, 0.0}),
                    std::max({box.min.y - p.y, p.y - box.max.y, 0.0})};
  if (!(length_squared(beside) <= distance * distance)) return false;
  return std::ranges::any_of(edges, [&](std::uint32_t h) {
    return segment_distance(mesh.vertex_position[mesh.origin(h)] - p,
                            mesh.vertex_position[mesh.target(h)] - p) <= distance;
  });
}

}  // namespace

/// Searches again at the ends that a watched segment is or was near, and where one of these
/// segments ends.
Status FreeEnds::find_again(Context& context, const mesh::TriangleMesh& mesh,
                            const curves::SegmentAttributes& attributes,
                            const mesh::TriangleMesh& with,
                            std::span<const std::uint8_t> is_watched,
                            std::span<const std::uint8_t> is_same) {
  TableMemory scratch("free ends of curves");
  EndSearch search(context, mesh, attributes, tables_);
  Status status = search.update_meetings(is_same);
  SFUMATO_TRY_ASSIGN(const std::vector<std::uint32_t>& watched,
                     watched_edges(context, with, is_watched, is_same, scratch));
  Box box;
  std::vector<std::uint32_t> vertices;  // the vertices to search
  for (const std::uint32_t h : watched) {
    for (const std::uint32_t v : {with.origin(h), with.target(h)}) {
      box.extend(with.vertex_position[v]);
      if (status) status = scratch.push_back(context, vertices, v);
    }
  }
  const bool looks_at_all = watched.size() > EndSearch::kMostTriangles;  // the faster way
  RarePoll<64> poll(context);
  for (std::size_t i = 0; status && i < end_.size(); ++i) {
    if (poll.cancelled()) return context.cancel_status();
    const FreeEnd& end = end_[i];
    const Vec2 p = mesh.vertex_position[end.vertex];
    if (!looks_at_all && !is_near(with, watched, box, p, end.free_way)) continue;
    status = memory_.push_back(context, gone_, end);
    if (status) status = scratch.push_back(context, vertices, end.vertex);
    take_away(i);
  }
  if (status) status = TableMemory::sort(context, vertices, std::less<>());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  std::vector<FreeEnd> found;
  for (std::size_t i = 0; status && i < vertices.size(); ++i)
    if (search.may_end(vertices[i])) status = search.add_end(vertices[i], scratch, found);
  for (std::size_t i = 0; status && i < found.size(); ++i)
    status = add_fresh(context, relative(found[i]));
  return status;
}

void FreeEnds::take_away(std::size_t i) {
  end_[i].reach = 0;
  term_[i] = term_of(end_[i]);
}

Status FreeEnds::add_fresh(Context& context, const FreeEnd& end) {
  SFUMATO_TRY(memory_.push_back(context, fresh_, end));
  SFUMATO_TRY(memory_.push_back(context, end_, end));
  SFUMATO_TRY(memory_.push_back(context, term_, term_of(end)));
  const auto i = static_cast<std::uint32_t>(end_.size() - 1);
  if (i / kEndsPerLeaf >= leaf_count_) return build_tree(context, kSpareEnds);
  for (std::uint32_t node = leaf_count_ + i / kEndsPerLeaf; node > 0; node /= 2)
    box_[node] = united(box_[node], reach_box(end));
  return ok_status();
}

/// Returns some of the ends as a separate set.
Result<FreeEnds> FreeEnds::part(Context& context, std::span<const FreeEnd> ends) const {
  FreeEnds some;
  some.base_channels_ = base_channels_;
  some.origin_ = origin_;
  some.weight_unit_ = weight_unit_;
  SFUMATO_TRY(some.memory_.append(context, ends, some.end_));
  SFUMATO_TRY(some.build_tree(context, 0));
  return some;
}

Result<FreeEnds> FreeEnds::without(Context& context, const FreeEnds& other) const {
  return those(context, [&](const FreeEnd& end) { return !is_in(other, end); });
}

Result<FreeEnds> FreeEnds::with_channel(Context& context, int channel) const {
  const auto c = static_cast<std::size_t>(channel);
  return those(context, [&](const FreeEnd& end) {
    return end.positive.channel[c] != 0 || end.negative.channel[c] != 0;
  });
}

float FreeEnds::add(Vec2 p, float weight, std::span<float> value) const {
  double sum = weight;
  visit_leaves_at(p, [&](std::uint32_t leaf) {
    for (const FreeEnd& end : of_leaf(leaf)) {
      const EndShare share = end_share(end, p - end.position);
      if (!(share.weight > 0)) continue;
      sum += share.weight;
      const auto mixed = static_cast<float>(share.weight / sum);
      const auto turned = static_cast<float>(positive_share(end, share));
      const auto z = lerp(end.negative, end.positive, turned);
      for (std::size_t c = 0; c < value.size(); ++c) {
        const bool is_base = c < static_cast<std::size_t>(base_channels_);
        value[c] += mixed * ((is_base ? z.channel[c] : 0.0f) - value[c]);
      }
    }
    return true;
  });
  return static_cast<float>(sum);
}

}  // namespace sfumato::gather
