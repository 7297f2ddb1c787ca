#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <set>

#include "base/poll.hpp"
#include "base/segment.hpp"
#include "base/table_memory.hpp"
#include "base/text/number_text.hpp"
#include "base/try.hpp"
#include "gather/ends/free_ends.hpp"
#include "gather/ends/meetings.hpp"
#include "gather/scene/scene.hpp"
#include "lint/curve_hints.hpp"

namespace sfumato::lint_detail {
namespace {

using gather::Cross;
using gather::Meeting;
using mesh::TriangleMesh;

/// The most hints of a kind in a layer that are reported one by one. More become one hint, because
/// curves traced by a program have hundreds.
constexpr std::size_t kMostOfAKind = 5;

/// The most crossings of curves with themselves that are examined in a layer; each requires a walk
/// in the mesh.
constexpr int kMostLooks = 64;

/// An end that stops at most this far before another curve, or beyond it, was meant to meet it: a
/// multiple of artboard_pixel.
constexpr double kMissPx = 4;

/// A curve is at least this many times longer than an end that sticks out.
constexpr double kSpurs = 8;

/// A point within 45° of the direction of an end is ahead of it: a cosine.
constexpr double kAhead = 0.7071;

/// If two colours differ less, a leak looks like shading: measured on drawings whose lines stop
/// short on purpose.
constexpr float kLeak = 96 / 255.f;

/// Two colours that face each other at a crossing and differ less count as equal.
constexpr float kClash = 48 / 255.f;

std::string point_text(Vec2 p) {
  return rounded_number_text(p.x, 4) + ", " + rounded_number_text(p.y, 4);
}

bool is_closed(const Curve& curve) {
  return curve.control_points.front() == curve.control_points.back();
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

  /// Hints of one kind, reported one by one or counted.
  struct Finds {
    HintKind kind;
    std::string more;  ///< text after the number of hints
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
    Finds crossings{HintKind::crossing, " crossings where colours do not match"};
    for (std::uint32_t v = 0; v < meeting_.size(); ++v) {
      if (poll_.cancelled()) return context_.cancel_status();
      SFUMATO_TRY_ASSIGN(const bool passes, passes_along_stretch(v));
      if (passes) add_eight(crossings, curve_at(v), position(v));
      const std::optional<Cross> cross = gather::cross_at(mesh_, attributes_, meeting_[v]);
      if (!cross) continue;
      if (is_outline_crossed(*cross) && gather::clashes(mesh_, attributes_, *cross, kClash)) {
        add_crossing(crossings, *cross);
      }
      SFUMATO_TRY_ASSIGN(const bool eight, is_eight(*cross));
      if (eight) {
        add_eight(crossings, cross->strand[0].curve,
                  position(mesh_.origin(cross->strand[0].half_edge)));
      }
    }
    tell(crossings);
    return ok_status();
  }

  /// Returns whether two curves cross and at least one of them encloses an area.
  bool is_outline_crossed(const Cross& cross) const {
    if (!cross.is_of_two_curves()) return false;
    return is_closed(test_.curves()[cross.strand[0].curve]) ||
           is_closed(test_.curves()[cross.strand[1].curve]);
  }

  /// Returns whether two sides differ in an attribute: one is open, or their values differ.
  template <class Differ>
  static bool facings_differ(const gather::Facing& one, const gather::Facing& other,
                             Differ values_differ) {
    if ((one.kind == ShaderKind::open) != (other.kind == ShaderKind::open)) return true;
    return one.kind == ShaderKind::curve_domain && other.kind == ShaderKind::curve_domain &&
           values_differ(one.from, other.to);
  }

  /// Returns whether the sides that face two half-edges differ in colour or opacity. The first is
  /// compared where it begins, the second where it ends.
  bool sides_differ(std::uint32_t one, std::uint32_t other) const {
    const auto colors_differ = [&](const auto& a, const auto& b) { return differ(a, b, kClash); };
    const auto opacities_differ = [](const auto& a, const auto& b) {
      return std::abs(a.channel[0] - b.channel[0]) > kClash;
    };
    const auto side_of = [&](const curves::SegmentAttributes& attributes, std::uint32_t h) {
      return gather::facing_side(mesh_, attributes, h);
    };
    if (facings_differ(side_of(attributes_, one), side_of(attributes_, other), colors_differ)) {
      return true;
    }
    if (!test_.prepared.opacity) return false;
    const curves::SegmentAttributes& opacity = test_.prepared.opacity->attributes;
    return facings_differ(side_of(opacity, one), side_of(opacity, other), opacities_differ);
  }

  std::uint32_t twin_of(std::uint32_t h) const {
    return static_cast<std::uint32_t>(mesh_.half_edge_twin[h]);
  }

  std::uint32_t curve_at(std::uint32_t v) const {
    return gather::curve_on(mesh_, attributes_, meeting_[v].half_edge);
  }

  /// Returns the half-edges with curves out of a vertex, in their order around it. Returns none on
  /// the border, or if a half-edge belongs to several curves.
  std::vector<std::uint32_t> strands_at(std::uint32_t v) const {
    std::vector<std::uint32_t> strands;
    std::uint32_t h = meeting_[v].half_edge;
    do {
      if (mesh_.has_curves(h)) {
        if (gather::curve_on(mesh_, attributes_, h) != curve_at(v)) return {};
        strands.push_back(h);
      }
      const std::int32_t twin = mesh_.half_edge_twin[previous_half_edge(h)];
      if (twin == mesh::kNone) return {};
      h = static_cast<std::uint32_t>(twin);
    } while (h != meeting_[v].half_edge);
    return strands;
  }

  /// Returns whether the weld merged two parts of a curve.
  bool is_double(std::uint32_t h) const {
    const auto index = static_cast<std::size_t>(mesh_.half_edge_constraint[h]);
    return mesh_.pieces(mesh_.constraint[index]).size() == 2;
  }

  /// Returns whether a closed curve crosses itself at such a small angle that two of its parts
  /// merge where they cross. Then different sides face the corners at the two ends of that stretch,
  /// beside the same side of the stretch, and both sides lie outside.
  Result<bool> passes_along_stretch(std::uint32_t v) {
    if (meeting_[v].edges != 3 || looks_left_ <= 0) return false;
    if (!is_closed(test_.curves()[curve_at(v)]) || eights_.contains(curve_at(v))) return false;
    const std::vector<std::uint32_t> strands = strands_at(v);
    const auto stretch =
        std::ranges::find_if(strands, [&](std::uint32_t h) { return is_double(h); });
    if (strands.size() != 3 || stretch == strands.end()) return false;
    const auto i = static_cast<std::size_t>(stretch - strands.begin());
    const std::optional<std::uint32_t> back = end_of_stretch(*stretch);
    if (!back) return false;
    const std::vector<std::uint32_t> there = strands_at(mesh_.origin(*back));
    const auto at = std::ranges::find(there, *back);
    if (there.size() != 3 || at == there.end()) return false;
    const auto k = static_cast<std::size_t>(at - there.begin());
    if (!sides_differ(there[(k + 2) % 3], twin_of(strands[(i + 1) % 3]))) return false;
    return is_outside(*stretch / 3, curve_at(v));
  }

  /// Follows edges that two parts share. Returns the half-edge back from the point where they
  /// separate, if three edges meet there.
  std::optional<std::uint32_t> end_of_stretch(std::uint32_t h) const {
    for (std::size_t steps = 0; steps < mesh_.constraint.size(); ++steps) {
      const std::uint32_t back = twin_of(h), end = mesh_.origin(back);
      if (meeting_[end].edges == 3) return back;
      const std::vector<std::uint32_t> strands = strands_at(end);
      if (strands.size() != 2) return std::nullopt;
      h = strands[0] == back ? strands[1] : strands[0];
      if (!is_double(h)) return std::nullopt;
    }
    return std::nullopt;
  }

  /// Returns whether a closed curve crosses itself so that both its sides face the outside, as in a
  /// figure of eight, and their colours or opacities differ. In a star only one side faces the
  /// outside.
  Result<bool> is_eight(const Cross& cross) {
    const std::uint32_t curve = cross.strand[0].curve;
    if (!cross.is_of_one_curve() || !is_closed(test_.curves()[curve])) return false;
    if (eights_.contains(curve)) return false;
    for (std::size_t i = 0; i < cross.strand.size(); ++i) {
      const std::uint32_t here = cross.strand[i].half_edge;
      const std::uint32_t next = cross.strand[(i + 1) % cross.strand.size()].half_edge;
      if (looks_left_ <= 0 || !sides_differ(here, twin_of(next))) continue;
      const Result<bool> outside = is_outside(here / 3, curve);
      if (!outside || *outside) return outside;
    }
    return false;
  }

  /// Returns how often a curve runs along an edge with curves.
  std::ptrdiff_t pass_count(std::uint32_t h, std::uint32_t curve) const {
    const auto index = static_cast<std::size_t>(mesh_.half_edge_constraint[h]);
    return std::ranges::count_if(mesh_.pieces(mesh_.constraint[index]), [&](const auto& piece) {
      return attributes_.curve[piece.segment] == curve;
    });
  }

  /// Returns whether a ray from the triangle's middle crosses the curve an even number of times.
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
      if (pass_count(h, curve) % 2 == 0) continue;
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
            ", where their colours do not match, so colours leak through; uncross the curves, or "
            "put them in separate layers");
  }

  void add_eight(Finds& crossings, std::uint32_t curve, Vec2 at) {
    eights_.insert(curve);
    add(crossings, curve, at,
        "it crosses itself at " + point_text(at) +
            ", so the side that is inside one loop is outside the other, and colours leak there; "
            "draw each loop as its own closed curve");
  }

  Status check_ends() {
    TableMemory memory("free ends of curves");
    SFUMATO_TRY_ASSIGN(const std::vector<gather::FreeEnd>& ends,
                       gather::find_free_ends(context_, mesh_, attributes_, memory));
    const double miss = kMissPx * artboard_pixel(test_.document);
    Finds gaps{HintKind::gap, " ends that stop shortly before another curve"};
    Finds overshoots{HintKind::overshoot, " ends that stick out beyond another curve"};
    std::uint32_t v = 0;
    for (const gather::FreeEnd& end : ends) {
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
        nearest_on_segment(end.position, position(edge.from), position(edge.to)) - end.position;
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
            ", so its two colours leak through the gap; move the end onto the curve, or farther "
            "away");
  }

  /// Adds a hint about an overshoot. The reach is the distance back to the point where the curve
  /// meets another curve, or to its other end.
  void add_overshoot(Finds& overshoots, std::uint32_t own, const gather::FreeEnd& end) {
    if (longer_side(box_of_points(test_.curves()[own].control_points)) < kSpurs * end.reach) return;
    add(overshoots, own, end.position,
        "its end at " + point_text(end.position) + " lies " + rounded_number_text(end.reach, 2) +
            " units beyond a curve that it crosses, so its colours leak there; move the end onto "
            "that curve");
  }

  Context& context_;
  RarePoll<4096> poll_;
  LayerUnderTest& test_;
  const TriangleMesh& mesh_;
  const curves::SegmentAttributes& attributes_;
  TableMemory memory_{"meetings of curves"};
  std::vector<Meeting> meeting_;    ///< per vertex
  std::set<std::uint32_t> eights_;  ///< curves that were reported
  int looks_left_ = kMostLooks;
};

}  // namespace

Status check_meetings(LayerUnderTest& test) {
  return MeetingCheck(test).run();
}

}  // namespace sfumato::lint_detail
