#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "base/number_text.hpp"
#include "base/poll.hpp"
#include "base/table_memory.hpp"
#include "gather/free_ends.hpp"
#include "gather/meetings.hpp"
#include "gather/scene.hpp"
#include "lint/curve_hints.hpp"

namespace sfumato::lint_detail {
namespace {

using gather::Cross;
using gather::Meeting;
using mesh::TriangleMesh;

/// Up to so many hints of a kind in a layer are told one by one, more as one: curves that a program
/// traced have hundreds.
constexpr std::size_t kMostOfAKind = 5;

/// Crossings of curves with themselves that are looked at in a layer: each costs a look at the
/// mesh.
constexpr int kMostLooks = 64;

/// An end that stops at most so far before another curve, or beyond it, was meant to meet it: a
/// multiple of artboard_pixel.
constexpr double kMissPx = 4;

/// A curve is longer than what sticks out of it by so many times.
constexpr double kSpurs = 8;

/// What lies within 45° of the way that an end points is ahead of it: a cosine.
constexpr double kAhead = 0.7071;

/// Where two colours differ less, what leaks passes for shading: measured on drawings whose lines
/// stop short on purpose.
constexpr float kLeak = 96 / 255.f;

/// Two colours that face each other at a crossing and differ less are one tone.
constexpr float kClash = 48 / 255.f;

std::string point_text(Vec2 p) {
  return rounded_number_text(p.x, 4) + ", " + rounded_number_text(p.y, 4);
}

bool is_closed(const Curve& curve) {
  return curve.control_points.front() == curve.control_points.back();
}

/// The longer side of the control points' box.
double extent_of(const Curve& curve) {
  Box box;
  for (const Vec2 p : curve.control_points) box.extend(p);
  return std::max(box.width(), box.height());
}

/// On its segment from a to b the point that is nearest to p.
Vec2 nearest_point(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 along = b - a;
  return lerp(a, b, std::clamp(dot(p - a, along) / length_squared(along), 0.0, 1.0));
}

class MeetingCheck {
 public:
  explicit MeetingCheck(LayerUnderTest& test)
      : context_(test.context),
        poll_(test.context),
        test_(test),
        mesh_(test.mesh),
        attributes_(test.prepared.color.attributes) {}

  Status run() {
    Status status = gather::find_meetings(context_, mesh_, memory_, meeting_);
    if (status) status = check_crossings();
    return status ? check_ends() : status;
  }

 private:
  Vec2 position(std::uint32_t v) const { return mesh_.vertex_position[v]; }

  /// Hints of one kind, told or counted.
  struct Finds {
    HintKind kind;
    std::string more;  ///< of many, after their number
    std::vector<Hint> hints{};
    std::size_t count = 0;
  };

  void add(Finds& finds, std::uint32_t curve, Vec2 at, std::string message) {
    if (++finds.count > kMostOfAKind) return;
    finds.hints.push_back({.kind = finds.kind,
                           .layer = test_.layer,
                           .curve = curve,
                           .at = at,
                           .message = std::move(message)});
  }

  void tell(const Finds& finds) {
    if (finds.count <= kMostOfAKind) {
      test_.hints.insert(test_.hints.end(), finds.hints.begin(), finds.hints.end());
      return;
    }
    const Hint& first = finds.hints[0];
    test_
        .add(finds.kind, std::to_string(finds.count) + finds.more + "; curve " +
                             std::to_string(*first.curve) + ": " + first.message)
        .at = first.at;
  }

  Status check_crossings() {
    Finds crossings{HintKind::crossing, " crossings whose colours do not fit"};
    for (std::uint32_t v = 0; v < meeting_.size(); ++v) {
      if (poll_.cancelled()) return context_.cancel_status();
      const std::optional<Cross> cross = gather::cross_at(mesh_, attributes_, meeting_[v]);
      if (!cross) continue;
      if (is_outline_crossed(*cross) && gather::clashes(mesh_, attributes_, *cross, kClash)) {
        add_crossing(crossings, *cross);
      }
      const Result<bool> eight = is_eight(*cross);
      if (!eight) return eight.status();
      if (*eight) add_eight(crossings, *cross);
    }
    tell(crossings);
    return ok_status();
  }

  /// Whether two curves pass through each other of which one at least encloses something.
  bool is_outline_crossed(const Cross& cross) const {
    if (!cross.is_of_two_curves()) return false;
    return is_closed(test_.curves()[cross.strand[0].curve]) ||
           is_closed(test_.curves()[cross.strand[1].curve]);
  }

  /// Whether a closed curve crosses itself so that both its sides face the outside, as those of an
  /// eight do, and these are not the same. In a star they face the outside on one side alone.
  Result<bool> is_eight(const Cross& cross) {
    const std::uint32_t curve = cross.strand[0].curve;
    if (!cross.is_of_one_curve() || !is_closed(test_.curves()[curve])) return false;
    if (eights_.contains(curve)) return false;
    for (std::size_t i = 0; i < cross.strand.size(); ++i) {
      const std::uint32_t here = cross.strand[i].half_edge;
      const std::uint32_t next = cross.strand[(i + 1) % cross.strand.size()].half_edge;
      const gather::Facing one = gather::facing_side(mesh_, attributes_, here);
      const gather::Facing other = gather::facing_side(
          mesh_, attributes_, static_cast<std::uint32_t>(mesh_.half_edge_twin[next]));
      const bool one_is_open = one.kind == ShaderKind::open;
      const bool leaks = one_is_open != (other.kind == ShaderKind::open);
      const bool clash = one.kind == ShaderKind::curve_domain &&
                         other.kind == ShaderKind::curve_domain &&
                         differ(one.from, other.to, kClash);
      if (!(leaks || clash) || looks_left_ <= 0) continue;
      const Result<bool> outside = is_outside(here / 3, curve);
      if (!outside || *outside) return outside;
    }
    return false;
  }

  /// Whether a ray from the triangle's middle crosses the curve an even number of times.
  Result<bool> is_outside(std::uint32_t triangle, std::uint32_t curve) {
    --looks_left_;
    Vec2 middle;
    for (std::size_t k = 0; k < 3; ++k) {
      middle = middle + position(mesh_.triangle_vertex[3 * std::size_t{triangle} + k]) / 3;
    }
    bool outside = true;
    for (std::uint32_t h = 0; h < mesh_.triangle_vertex.size(); ++h) {
      if (poll_.cancelled()) return context_.cancel_status();
      const std::int32_t twin = mesh_.half_edge_twin[h];
      const bool is_second = twin != mesh::kNone && static_cast<std::uint32_t>(twin) < h;
      if (is_second || !mesh_.has_curves(h)) continue;
      if (gather::curve_on(mesh_, attributes_, h) != curve) continue;
      const Vec2 a = position(mesh_.origin(h)), b = position(mesh_.origin(next_half_edge(h)));
      if ((a.y <= middle.y) == (b.y <= middle.y)) continue;
      const Vec2 upper = a.y < b.y ? a : b, lower = a.y < b.y ? b : a;
      if (cross(lower - upper, middle - upper) > 0) outside = !outside;
    }
    return outside;
  }

  bool differ(const curves::FieldValue& a, const curves::FieldValue& b, float by) const {
    return gather::differ(attributes_, a, b, by);
  }

  void add_crossing(Finds& crossings, const Cross& cross) {
    const auto [first, second] = std::minmax(cross.strand[0].curve, cross.strand[1].curve);
    const Vec2 at = position(mesh_.origin(cross.strand[0].half_edge));
    add(crossings, second, at,
        "it crosses curve " + std::to_string(first) + " at " + point_text(at) +
            ", and their colours do not fit there: those of one leak into what the other encloses; "
            "expected curves that do not cross, or a layer for each");
  }

  void add_eight(Finds& crossings, const Cross& cross) {
    const std::uint32_t curve = cross.strand[0].curve;
    eights_.insert(curve);
    const Vec2 at = position(mesh_.origin(cross.strand[0].half_edge));
    add(crossings, curve, at,
        "it crosses itself at " + point_text(at) +
            ", so that both its sides lie outside: what colours the inside of one loop leaks from "
            "the other; expected a closed curve for each loop");
  }

  Status check_ends() {
    TableMemory memory("free ends of curves");
    const Result<std::vector<gather::FreeEnd>> ends =
        gather::find_free_ends(context_, mesh_, attributes_, memory);
    if (!ends) return ends.status();
    const double miss = kMissPx * artboard_pixel(test_.document);
    Finds gaps{HintKind::gap, " ends that stop shortly before another curve"};
    Finds overshoots{HintKind::overshoot, " ends that stick out beyond another curve"};
    std::uint32_t v = 0;
    for (const gather::FreeEnd& end : *ends) {
      if (poll_.cancelled()) return context_.cancel_status();
      if (end.reach * test_.sight.scale >= miss) continue;
      if (!differ(end.positive, end.negative, kLeak)) continue;
      while (!(position(v) == end.position)) ++v;  // ends are in the order of their vertices
      const std::uint32_t own = gather::curve_on(mesh_, attributes_, meeting_[v].half_edge);
      if (end.nearest == mesh::kNone) {
        add_overshoot(overshoots, own, end);
      } else if (is_ahead(end)) {
        add_gap(gaps, own, end);
      }
    }
    tell(gaps);
    tell(overshoots);
    return context_.check();
  }

  bool is_ahead(const gather::FreeEnd& end) const {
    const auto& edge = mesh_.constraint[static_cast<std::size_t>(end.nearest)];
    const Vec2 way =
        nearest_point(end.position, position(edge.from), position(edge.to)) - end.position;
    return dot(way, end.direction) >= kAhead * end.reach;
  }

  std::uint32_t nearest_curve(const gather::FreeEnd& end) const {
    const auto& edge = mesh_.constraint[static_cast<std::size_t>(end.nearest)];
    return attributes_.curve[mesh_.pieces(edge).back().segment];
  }

  void add_gap(Finds& gaps, std::uint32_t own, const gather::FreeEnd& end) {
    const std::uint32_t other = nearest_curve(end);
    add(gaps, own, end.position,
        "its end at " + point_text(end.position) + " stops " + rounded_number_text(end.reach, 2) +
            " units before " +
            (own == other ? "the curve itself" : "curve " + std::to_string(other)) +
            ": its two colours leak through the gap; expected an end that meets it, or one farther "
            "away");
  }

  /// The reach is the way back to where the curve meets another, or to its other end.
  void add_overshoot(Finds& overshoots, std::uint32_t own, const gather::FreeEnd& end) {
    if (extent_of(test_.curves()[own]) < kSpurs * end.reach) return;
    add(overshoots, own, end.position,
        "its end at " + point_text(end.position) + " lies " + rounded_number_text(end.reach, 2) +
            " units beyond a curve that it crosses: its colours leak there; expected an end on "
            "that curve");
  }

  Context& context_;
  RarePoll<4096> poll_;
  LayerUnderTest& test_;
  const TriangleMesh& mesh_;
  const curves::SegmentAttributes& attributes_;
  TableMemory memory_{"meetings of curves"};
  std::vector<Meeting> meeting_;    ///< per vertex
  std::set<std::uint32_t> eights_;  ///< curves that were told of
  int looks_left_ = kMostLooks;
};

}  // namespace

Status check_meetings(LayerUnderTest& test) {
  return MeetingCheck(test).run();
}

}  // namespace sfumato::lint_detail
