#include "import/boundary_check.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/boxes.hpp"
#include "base/poll.hpp"
#include "base/segment.hpp"
#include "base/try.hpp"
#include "curves/bezier.hpp"
#include "import/chords.hpp"
#include "import/curve_crossing.hpp"
#include "import/loop_area.hpp"
#include "import/shape_limits.hpp"
#include "sfumato/base/box.hpp"

namespace sfumato::svg_import {
namespace {

using curves::Cubic;

constexpr const char* kCheckPurpose = "the check of a boundary";
constexpr std::uint64_t kPairsFactor =
    2;                                ///< pairs that are compared, counted for Limits::chord_pairs
constexpr double kFlat = 1.0 / 4096;  ///< of the weld: where straight lines cross or coincide
/// A multiple of the weld: crossings nearer to a common point of curves count as that point.
constexpr double kPoint = 1.0 / 8;
/// A multiple of the weld: the tolerance of the renderer's chords.
constexpr double kDrawnOff = 1.6;
/// A multiple of the weld: two parts of a loop may come near if less of the loop lies between them,
/// and parts of two loops if they are no farther from a point where the loops touch.
constexpr double kNeighbors = 8;
/// The least number of parts of a loop. Two parts then have at most one common end.
constexpr std::size_t kLeastParts = 4;

/// A part of a piece of a loop that deviates from its chord no more than the renderer allows.
struct Part {
  Cubic curve;
  LoopPiece of;
  double begin = 0;  ///< lengths along the loop
  double end = 0;
  double drawn_off = 0;        ///< how far the renderer's chords may lie away
  bool begins_welded = false;  ///< a part that the weld swallows ends or begins at the beginning
  bool ends_welded = false;
};

/// Parts of a loop, which follow one another.
struct LoopParts {
  std::size_t first = 0;
  std::size_t end = 0;
  double length = 0;
};

/// Returns the squared distance of a point from a part's chord.
double squared_distance(Vec2 p, const Part& part) {
  return length_squared(p - nearest_on_segment(p, part.curve[0], part.curve[3]));
}

class BoundaryCheck {
 public:
  BoundaryCheck(Context& context, double weld, std::span<const Vec2> touches, TableMemory& memory,
                Leaks leaks)
      : context_(context),
        weld_(weld),
        touches_(touches),
        crossing_(kFlat * weld, kPoint * weld),
        memory_(memory),
        leaks_(leaks) {}

  Result<std::vector<LoopPiece>> run(std::span<const DrawnLoop> loops);

 private:
  Status add_parts(const std::vector<Vec2>& chain, std::uint32_t loop);
  void measure(LoopParts& loop);
  Status add_turned(std::span<const DrawnLoop> loops);
  Status check_pairs();
  Status check_pair(std::size_t a, std::size_t b);
  bool follow(std::size_t a, std::size_t b) const;
  bool cross_each_other(std::size_t a, std::size_t b);
  bool are_too_near(const Part& a, const Part& b) const;
  bool begins_near(const Part& of, const Part& other) const;
  bool lies_on(const Part& part, const Part& other) const;
  bool coincide(const Part& a, const Part& b) const;
  bool is_at_touch(Vec2 p, double reach) const;
  double length_between(double place, const Part& part) const;

  Context& context_;
  double weld_;
  std::span<const Vec2> touches_;
  CurveCrossing crossing_;
  TableMemory& memory_;
  Leaks leaks_;
  TableMemory working_{kCheckPurpose};
  std::vector<LoopParts> loops_;
  std::vector<Part> parts_;
  std::vector<Box> boxes_;  ///< per part
  std::vector<LoopPiece> found_;
};

Status BoundaryCheck::add_parts(const std::vector<Vec2>& chain, std::uint32_t loop) {
  const std::size_t pieces = (chain.size() - 1) / 3;
  const auto least = static_cast<int>((kLeastParts + pieces - 1) / pieces);
  for (std::uint32_t i = 0; i < pieces; ++i) {
    const Cubic cubic = curves::piece(chain, i);
    const int count = std::max(least, chord_count(cubic, kDrawnOff * weld_));
    const double drawn_off = std::min(kDrawnOff * weld_, curves::chord_deviation(cubic).across);
    SFUMATO_TRY(working_.make_room(context_, parts_, static_cast<std::size_t>(count)));
    for (int k = 0; k < count; ++k) {
      Part& part = parts_.emplace_back();
      part.of = {loop, i};
      part.drawn_off = drawn_off;
      part.curve = curves::subcurve(cubic, double{1} * k / count, double{1} * (k + 1) / count);
      if (k > 0) part.curve[0] = parts_[parts_.size() - 2].curve[3];
    }
    if (context_.cancelled()) return context_.cancel_status();
  }
  return ok_status();
}

void BoundaryCheck::measure(LoopParts& loop) {
  for (std::size_t i = loop.first; i < loop.end; ++i) {
    Part& part = parts_[i];
    Part& next = parts_[i + 1 < loop.end ? i + 1 : loop.first];
    const double size = length(part.curve[3] - part.curve[0]);
    part.begin = loop.length;
    part.end = loop.length += size;
    if (size >= weld_) continue;
    part.begins_welded = part.ends_welded = next.begins_welded = true;
    parts_[i > loop.first ? i - 1 : loop.end - 1].ends_welded = true;
  }
}

/// Returns whether part b begins where part a ends.
bool BoundaryCheck::follow(std::size_t a, std::size_t b) const {
  if (parts_[a].of.loop != parts_[b].of.loop) return false;
  const LoopParts& loop = loops_[parts_[a].of.loop];
  return b == (a + 1 < loop.end ? a + 1 : loop.first);
}

bool BoundaryCheck::cross_each_other(std::size_t a, std::size_t b) {
  const Cubic &of_a = parts_[a].curve, &of_b = parts_[b].curve;
  if (follow(a, b)) return crossing_.beyond_joint(of_a, of_b);
  if (follow(b, a)) return crossing_.beyond_joint(of_b, of_a);
  return crossing_.of(of_a, of_b) && !is_at_touch(crossing_.place(), kPoint * weld_);
}

/// Returns whether a part begins so near to another part that the renderer may weld them.
bool BoundaryCheck::begins_near(const Part& of, const Part& other) const {
  const bool is_same = of.of.loop == other.of.loop;
  if (is_same && length_between(of.begin, other) <= kNeighbors * weld_) return false;
  // Welded ends move by as much. The renderer keeps the order of parts of one curve.
  const bool moves = !is_same && of.begins_welded;
  const bool other_moves = !is_same && (other.begins_welded || other.ends_welded);
  const double reach = weld_ * (1 + (moves ? 1 : 0) + (other_moves ? 1 : 0)) + other.drawn_off;
  return squared_distance(of.curve[0], other) < reach * reach &&
         !is_at_touch(of.curve[0], kNeighbors * weld_);
}

/// Returns whether the renderer welds both ends of a part to another part.
bool BoundaryCheck::lies_on(const Part& part, const Part& other) const {
  const double least = kNeighbors * weld_, most = weld_ * weld_;
  return part.end - part.begin > least && squared_distance(part.curve[0], other) < most &&
         squared_distance(part.curve[3], other) < most;
}

/// Returns whether two straight parts share a stretch. No curves cross there, but the outside of
/// one covers the inside of the other.
bool BoundaryCheck::coincide(const Part& a, const Part& b) const {
  const double reach = kFlat * weld_;
  const Vec2 begin = a.curve[0], chord = a.curve[3] - begin;
  const double size = length(chord);
  if (!(size > kNeighbors * weld_)) return false;
  const Vec2 along = chord / size;
  const Vec2 from = b.curve[0] - begin, to = b.curve[3] - begin;
  if (std::abs(cross(along, from)) > reach || std::abs(cross(along, to)) > reach) return false;
  const auto [low, high] = std::minmax({dot(along, from), dot(along, to)});
  if (!(std::min(high, size) - std::max(low, 0.0) > kNeighbors * weld_)) return false;
  return curves::chord_deviation(a.curve).across <= reach &&
         curves::chord_deviation(b.curve).across <= reach;
}

bool BoundaryCheck::is_at_touch(Vec2 p, double reach) const {
  const auto x_of = [](Vec2 touch) { return touch.x; };
  const auto low = std::ranges::lower_bound(touches_, p.x - reach, {}, x_of);
  const auto high = std::ranges::upper_bound(touches_, p.x + reach, {}, x_of);
  return std::any_of(low, high, [&](Vec2 touch) { return length(touch - p) <= reach; });
}

/// Returns the length of the loop between a place and a part of the loop.
double BoundaryCheck::length_between(double place, const Part& part) const {
  const double around = loops_[part.of.loop].length;
  const double ahead = part.begin - place, behind = place - part.end;
  return std::min(ahead < 0 ? ahead + around : ahead, behind < 0 ? behind + around : behind);
}

bool BoundaryCheck::are_too_near(const Part& a, const Part& b) const {
  return begins_near(a, b) || begins_near(b, a) || lies_on(a, b) || lies_on(b, a);
}

Status BoundaryCheck::check_pair(std::size_t a, std::size_t b) {
  const Part &of_a = parts_[a], &of_b = parts_[b];
  const bool leak = (leaks_ == Leaks::all && are_too_near(of_a, of_b)) || cross_each_other(a, b) ||
                    coincide(of_a, of_b);
  if (!leak) return ok_status();
  SFUMATO_TRY(memory_.push_back(context_, found_, of_a.of));
  return memory_.push_back(context_, found_, of_b.of);
}

Status BoundaryCheck::check_pairs() {
  Box whole;
  for (const Box& box : boxes_) whole = united(whole, box);
  const bool by_x = whole.width() >= whole.height();
  const auto begin = [&](std::uint32_t i) { return by_x ? boxes_[i].min.x : boxes_[i].min.y; };
  const auto end = [&](std::uint32_t i) { return by_x ? boxes_[i].max.x : boxes_[i].max.y; };
  std::vector<std::uint32_t> order, active;
  SFUMATO_TRY(working_.resize(context_, order, parts_.size()));
  SFUMATO_TRY(working_.reserve(context_, active, parts_.size()));
  std::iota(order.begin(), order.end(), 0u);
  SFUMATO_TRY(TableMemory::sort(context_, order, [&](std::uint32_t a, std::uint32_t b) {
    return std::pair(begin(a), a) < std::pair(begin(b), b);
  }));
  std::uint64_t pairs = 0;
  for (const std::uint32_t i : order) {
    if (context_.cancelled()) return context_.cancel_status();
    std::erase_if(active, [&](std::uint32_t k) { return end(k) < begin(i); });
    if ((pairs += active.size()) > kPairsFactor * context_.limits.chord_pairs) {
      return has_too_many_pairs(context_);
    }
    for (const std::uint32_t k : active) {
      if (!overlap(boxes_[i], boxes_[k])) continue;
      SFUMATO_TRY(check_pair(i, k));
    }
    active.push_back(i);
  }
  return ok_status();
}

/// Appends the pieces of loops whose area has the wrong sign.
Status BoundaryCheck::add_turned(std::span<const DrawnLoop> loops) {
  RarePoll<256> poll(context_);
  for (std::uint32_t i = 0; i < loops.size(); ++i) {
    if (poll.cancelled()) return context_.cancel_status();
    const std::vector<Vec2>& chain = *loops[i].chain;
    const bool is_turned = signed_area(chain) * loops[i].area < 0;
    const std::size_t count = is_turned ? (chain.size() - 1) / 3 : 0;
    for (std::uint32_t k = 0; k < count; ++k) {
      SFUMATO_TRY(memory_.push_back(context_, found_, {i, k}));
    }
  }
  return ok_status();
}

Result<std::vector<LoopPiece>> BoundaryCheck::run(std::span<const DrawnLoop> loops) {
  SFUMATO_TRY(working_.reserve(context_, loops_, loops.size()));
  for (std::uint32_t i = 0; i < loops.size(); ++i) {
    LoopParts& loop = loops_.emplace_back();
    loop.first = parts_.size();
    SFUMATO_TRY(add_parts(*loops[i].chain, i));
    loop.end = parts_.size();
    measure(loop);
  }
  SFUMATO_TRY(working_.reserve(context_, boxes_, parts_.size()));
  RarePoll<1024> poll(context_);
  for (const Part& part : parts_) {
    if (poll.cancelled()) return context_.cancel_status();
    boxes_.push_back(
        box_of_points(part.curve).grown_by((3 + kDrawnOff) / 2 * weld_));  // half the reach
  }
  SFUMATO_TRY(check_pairs());
  SFUMATO_TRY(add_turned(loops));
  return std::move(found_);
}

}  // namespace

Result<std::vector<LoopPiece>> leaking_pieces(Context& context, std::span<const DrawnLoop> loops,
                                              double weld, std::span<const Vec2> touches,
                                              TableMemory& memory, Leaks leaks) {
  return BoundaryCheck(context, weld, touches, memory, leaks).run(loops);
}

Status refuse_crossings(Context& context, std::span<const DrawnLoop> loops, double weld,
                        std::span<const Vec2> touches) {
  TableMemory memory(kCheckPurpose);
  const auto found = leaking_pieces(context, loops, weld, touches, memory, Leaks::crossings);
  if (!found || found->empty()) return found.status();
  return make_error(StatusCode::bad_input,
                    "its outline crosses itself too closely; expected simpler curves there");
}

}  // namespace sfumato::svg_import
