#include "gather/free_ends.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "base/poll.hpp"
#include "base/spatial_order.hpp"
#include "curves/front_share.hpp"
#include "gather/kernels/end_tree.hpp"

namespace sfumato::gather {
namespace {

/// Beside a long straight curve its own weight is g(φ)/r², with g(90°) = π/4: near it, the term
/// makes the turn from one side to the other nearly even.
constexpr double kWeight = 0.8;

/// Rounded outwards.
EndBox reach_box(const FreeEnd& end) {
  const auto [x, y] = end.position;
  const auto down = [](double v) { return std::nextafter(static_cast<float>(v), -HUGE_VALF); };
  const auto up = [](double v) { return std::nextafter(static_cast<float>(v), HUGE_VALF); };
  return {down(x - end.reach), down(y - end.reach), up(x + end.reach), up(y + end.reach)};
}

/// But for rounding, and for what the mesh around an end decides.
bool have_the_same_term(const FreeEnd& a, float unit_a, const FreeEnd& b, float unit_b) {
  constexpr double kSame = 1e-4;
  const auto about = [](double x, double y) { return std::fabs(x - y) <= kSame * std::fabs(x); };
  return a.position == b.position && a.positive == b.positive && a.negative == b.negative &&
         a.blur_positive == b.blur_positive && a.blur_negative == b.blur_negative &&
         length(a.direction - b.direction) <= kSame && about(a.reach, b.reach) &&
         std::fabs(a.bend - b.bend) * a.reach <= kSame &&
         about(double{a.weight} * unit_a, double{b.weight} * unit_b);
}

/// The share τ of the positive side in z_e, at d from the end, unbent.
double positive_share(const FreeEnd& end, Vec2 d) {
  const double r = length(d);
  const double across = cross(end.direction, d), ahead = dot(end.direction, d);
  // sin(φ/2), each form where nothing cancels in it.
  const double half_sine = ahead > 0 ? across / std::sqrt(2 * r * (r + ahead))
                                     : std::copysign(std::sqrt(0.5 * (1 - ahead / r)), across);
  const float radius = across > 0 ? end.blur_positive : end.blur_negative;
  // β at the distance from the line of the curve's last segment.
  const double front = curves::front_share(std::fabs(across), double{radius});
  return 0.5 + 0.5 * half_sine * (2 * front - 1);
}

}  // namespace

Vec2 FreeEnd::unbent(Vec2 d) const {
  const double sine = bend * length(d);
  const double cosine = std::sqrt(std::max(0.0, 1 - sine * sine));
  return {cosine * d.x + sine * d.y, cosine * d.y - sine * d.x};
}

Result<FreeEnds> FreeEnds::create(Context& context, const mesh::TriangleMesh& mesh,
                                  const curves::SegmentAttributes& attributes, Vec2 origin,
                                  float weight_unit, const FreeEnds* before,
                                  std::span<const std::uint8_t> is_watched) {
  FreeEnds ends;
  KnownEnds known;
  if (before) known = {before->end_, is_watched};
  Result<std::vector<FreeEnd>> found =
      find_free_ends(context, mesh, attributes, ends.memory_, known);
  if (!found) return found.status();
  ends.base_channels_ = attributes.base_channels;
  ends.weight_unit_ = weight_unit;
  ends.end_ = std::move(*found);
  for (FreeEnd& end : ends.end_) {
    end.position = end.position - origin;
    end.weight /= weight_unit;
  }
  if (Status status = ends.build_tree(context); !status) return status;
  return ends;
}

Status FreeEnds::build_tree(Context& context) {
  if (end_.empty()) return ok_status();
  const auto count = static_cast<std::uint32_t>(end_.size());
  leaf_count_ = std::bit_ceil((count + kEndsPerLeaf - 1) / kEndsPerLeaf);
  TableMemory scratch("free ends of curves");
  std::vector<Vec2> position;
  std::vector<FreeEnd> sorted;
  Status status = scratch.reserve(context, position, count);
  if (status) status = memory_.reserve(context, sorted, count);
  if (status) status = memory_.reserve(context, term_, count);
  if (status) status = memory_.resize(context, box_, 2 * std::size_t{leaf_count_});
  if (!status) return status;
  for (const FreeEnd& end : end_) position.push_back(end.position);
  std::vector<std::uint32_t> order;
  if (status = spatial_order(context, position, scratch, order); !status) return status;
  for (const std::uint32_t i : order) sorted.push_back(end_[i]);
  end_.swap(sorted);
  memory_.free(sorted);
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
  term.inverse_reach_squared = static_cast<float>(1 / (end.reach * end.reach));
  term.weight = static_cast<float>(kWeight * end.weight);
  term.blur_positive = end.blur_positive, term.blur_negative = end.blur_negative;
  std::ranges::copy(end.positive.channel, term.positive);
  std::ranges::copy(end.negative.channel, term.negative);
  return term;
}

EndTree FreeEnds::view() const {
  return {term_.data(), box_.data(), static_cast<std::uint32_t>(end_.size()), leaf_count_};
}

/// As gather::visit_leaves.
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

Result<FreeEnds> FreeEnds::without(Context& context, const FreeEnds& other) const {
  FreeEnds rest;
  rest.base_channels_ = base_channels_;
  rest.weight_unit_ = weight_unit_;
  RarePoll<1024> poll(context);
  for (const FreeEnd& end : end_) {
    if (poll.cancelled()) return context.cancel_status();
    if (is_in(other, end)) continue;
    Status status = rest.memory_.push_back(context, rest.end_, end);
    if (!status) return status;
  }
  if (Status status = rest.build_tree(context); !status) return status;
  return rest;
}

bool FreeEnds::add(Vec2 p, float weight, std::span<float> value) const {
  double sum = weight;
  bool any = false;
  visit_leaves_at(p, [&](std::uint32_t leaf) {
    for (const FreeEnd& end : of_leaf(leaf)) {
      const Vec2 d = p - end.position;
      const double r_squared = length_squared(d);
      const double x = r_squared / (end.reach * end.reach);
      if (!(x < 1) || !(r_squared > 0)) continue;
      const double more =
          kWeight * end.weight / r_squared * ((1 - x) * (1 - x) / (1 + kEndKnee * x));
      sum += more;
      const auto mixed = static_cast<float>(more / sum);
      const auto turned = static_cast<float>(positive_share(end, end.unbent(d)));
      const auto z = lerp(end.negative, end.positive, turned);
      for (std::size_t c = 0; c < value.size(); ++c) {
        const bool is_base = c < static_cast<std::size_t>(base_channels_);
        value[c] += mixed * ((is_base ? z.channel[c] : 0.0f) - value[c]);
      }
      any = true;
    }
    return true;
  });
  return any;
}

}  // namespace sfumato::gather
