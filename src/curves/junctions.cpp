#include "curves/junctions.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <tuple>
#include <utility>

#include "base/poll.hpp"
#include "base/try.hpp"
#include "curves/bezier.hpp"
#include "curves/segment_tree.hpp"
#include "sfumato/base/box.hpp"

namespace sfumato::curves {
namespace {

/// The most boxes of the tree that one vertex visits. Where more passages lie on each other their
/// chords may differ, but time stays proportional to the vertices.
constexpr int kPatience = 200;

constexpr std::uint32_t kNobody = 0xffffffff;

/// Vertices at the same position: each is mapped to the first of its place.
class Places {
 public:
  /// Builds the table; call it first. Errors: limit, cancelled; no other function may then be
  /// called.
  Status build(Context& context, std::span<const Vec2> vertex) {
    const std::size_t slots = std::bit_ceil(2 * vertex.size() + 1);
    SFUMATO_TRY(memory_.resize(context, first_, vertex.size()));
    SFUMATO_TRY(memory_.resize(context, table_, slots, kNobody));
    RarePoll<4096> poll(context);
    for (std::uint32_t v = 0; v < vertex.size(); ++v) {
      if (poll.cancelled()) return context.cancel_status();
      std::size_t slot = hash(vertex[v]) & (table_.size() - 1);
      while (table_[slot] != kNobody && !(vertex[table_[slot]] == vertex[v])) {
        slot = (slot + 1) & (table_.size() - 1);
      }
      if (table_[slot] == kNobody) table_[slot] = v;
      first_[v] = table_[slot];
    }
    return context.check();
  }

  std::uint32_t first(std::uint32_t v) const { return first_[v]; }

 private:
  static std::size_t hash(Vec2 p) {
    // Adding 0 makes both zeros one.
    std::uint64_t mixed = std::bit_cast<std::uint64_t>(p.x + 0.0) * 0x9e3779b97f4a7c15u;
    mixed = (std::rotl(mixed, 31) ^ std::bit_cast<std::uint64_t>(p.y + 0.0)) * 0xbf58476d1ce4e5b9u;
    return static_cast<std::size_t>(mixed ^ mixed >> 29);
  }

  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> table_;
  TableMemory memory_{"flattening"};
};

class JunctionFinder {
 public:
  JunctionFinder(Context& context, std::span<const Curve> curves, const FlatCurves& flat,
                 double reach)
      : context_(context), curves_(curves), flat_(flat), reach_squared_(reach * reach) {
    status_ = found_.memory.resize(context, found_.pinned, flat.vertex.size());
  }

  /// Returns limit or cancelled: no other function may then be called.
  const Status& status() const { return status_; }

  /// Records that v lies on `first`, which is searched for both.
  void meet(std::uint32_t v, std::uint32_t first) {
    // The joint of a closed curve is one vertex, not two that meet.
    if (!is_own_end(v, first)) found_.pinned[first] = 1;
  }

  /// Records where vertex v lies on segment s, unless it is an end of s.
  void look(std::uint32_t v, std::uint32_t s) {
    if (v == s || v == s + 1) return;
    const Vec2 p = flat_.vertex[v];
    const Vec2 a = flat_.vertex[s], b = flat_.vertex[s + 1];
    if (near(p, a) || near(p, b)) {
      // The joint of a closed curve is one vertex, not two that meet.
      if (!is_own_end(v, near(p, a) ? s : s + 1)) found_.pinned[v] = 1;
      return;
    }
    const double from = flat_.parameter[s], to = flat_.parameter[s + 1], begin = std::floor(from);
    const Cubic cubic = piece_of(curves_[flat_.vertex_curve[s]], from);
    const double chord = length_squared(b - a);
    const double share = chord > 0 ? dot(p - a, b - a) / chord : 0;
    if (!(share > 0 && share < 1)) return;
    const double t = nearest_parameter(cubic, p, lerp_parameter(from, to, share) - begin);
    const double parameter = begin + t;
    if (!(parameter > from && parameter < to) || !near(p, point_at(cubic, t))) return;
    found_.pinned[v] = 1;
    note({flat_.vertex_curve[s], parameter, p});
  }

  /// Returns the result. Call it once, last.
  Result<Junctions> take(const Places& places) {
    for (std::uint32_t v = 0; v < found_.pinned.size(); ++v) {
      found_.pinned[v] = found_.pinned[places.first(v)];
    }
    TableMemory working("flattening");
    std::vector<std::size_t> next;
    std::vector<Junction> sorted;
    SFUMATO_TRY(working.resize(context_, next, curves_.size() + 1));
    SFUMATO_TRY(found_.memory.resize(context_, sorted, found_.junction.size()));
    for (const Junction& at : found_.junction) ++next[at.curve + 1];
    for (std::size_t c = 1; c < next.size(); ++c) next[c] += next[c - 1];
    for (const Junction& at : found_.junction) sorted[next[at.curve]++] = at;
    RarePoll<16> poll(context_);
    std::size_t begin = 0;
    for (std::size_t c = 0; c < curves_.size(); begin = next[c++]) {
      if (poll.cancelled()) return context_.cancel_status();
      std::sort(sorted.data() + begin, sorted.data() + next[c],
                [](const Junction& a, const Junction& b) {
                  return std::tie(a.parameter, a.point.x, a.point.y) <
                         std::tie(b.parameter, b.point.x, b.point.y);
                });
    }
    found_.memory.free(found_.junction);
    found_.junction = std::move(sorted);
    return std::move(found_);
  }

 private:
  void note(const Junction& junction) {
    if (status_.ok()) status_ = found_.memory.push_back(context_, found_.junction, junction);
  }

  static double lerp_parameter(double from, double to, double share) {
    return from + (to - from) * share;
  }

  bool near(Vec2 p, Vec2 q) const { return length_squared(p - q) <= reach_squared_; }

  /// Returns whether both are the first and the last vertex of one curve.
  bool is_own_end(std::uint32_t v, std::uint32_t w) const {
    const std::uint32_t curve = flat_.vertex_curve[v];
    if (flat_.vertex_curve[w] != curve) return false;
    const auto [low, high] = std::minmax(v, w);
    return low == flat_.curve_begin[curve] && high + 1 == flat_.curve_begin[curve + 1];
  }

  Context& context_;
  std::span<const Curve> curves_;
  const FlatCurves& flat_;
  double reach_squared_;
  Status status_;
  Junctions found_;
};

}  // namespace

Result<Junctions> find_junctions(Context& context, std::span<const Curve> curves,
                                 const FlatCurves& flat, double reach) {
  const std::size_t vertices = flat.vertex.size();
  SegmentTree tree;
  Places places;
  SFUMATO_TRY(tree.build(context, flat, curves, reach));
  SFUMATO_TRY(places.build(context, flat.vertex));
  JunctionFinder finder(context, curves, flat, reach);
  RarePoll<1024> poll(context);
  for (std::uint32_t v = 0; v < vertices && finder.status().ok(); ++v) {
    if (poll.cancelled()) return context.cancel_status();
    if (places.first(v) != v) {
      finder.meet(v, places.first(v));
    } else {
      const Vec2 p = flat.vertex[v];
      tree.visit([&](const Box& box) { return box.contains(p); }, kPatience,
                 [&](std::uint32_t s) { finder.look(v, s); });
    }
  }
  if (!finder.status()) return finder.status();
  return finder.take(places);
}

}  // namespace sfumato::curves
