#include "curves/junctions.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/box.hpp"
#include "base/spatial_order.hpp"
#include "curves/bezier.hpp"

namespace sfumato::curves {
namespace {

/// Boxes of the tree that one vertex looks at, at most: where more passages lie on each other than
/// that their chords may differ, but time stays in proportion to the vertices.
constexpr int kPatience = 200;

constexpr std::uint32_t kLeafSegments = 4;

Cubic piece_of(const Curve& curve, double parameter_of_start) {
  const auto last = static_cast<double>(curve.piece_count() - 1);
  return piece(curve.control_points,
               static_cast<std::size_t>(std::min(std::floor(parameter_of_start), last)));
}

/// All segments of the polylines, in a binary tree of the boxes of their stretches of curve.
class SegmentTree {
 public:
  SegmentTree(const FlatCurves& flat, std::span<const Curve> curves, double reach) {
    std::vector<Vec2> middle;
    std::vector<std::uint32_t> segment;
    for (std::uint32_t v = 0; v < flat.vertex.size(); ++v) {
      if (!flat.begins_segment(v)) continue;
      segment.push_back(v);
      middle.push_back(lerp(flat.vertex[v], flat.vertex[v + 1], 0.5));
    }
    for (const std::uint32_t i : spatial_order(middle)) segment_.push_back(segment[i]);
    leaf_count_ = (static_cast<std::uint32_t>(segment_.size()) + kLeafSegments - 1) / kLeafSegments;
    while (first_leaf_ < leaf_count_) first_leaf_ *= 2;
    box_.resize(std::size_t{2} * first_leaf_);
    for (std::size_t i = 0; i < segment_.size(); ++i) {
      Box& leaf = box_[first_leaf_ + i / kLeafSegments];
      leaf = united(leaf, stretch_box(flat, curves, segment_[i]).grown_by(reach));
    }
    for (std::uint32_t node = first_leaf_ - 1; node > 0; --node) {
      box_[node] = united(box_[std::size_t{2} * node], box_[std::size_t{2} * node + 1]);
    }
  }

  static std::size_t bytes(std::size_t segments) {
    return segments * (sizeof(Box) + sizeof(Vec2) + 4 * sizeof(std::uint32_t));
  }

  /// Calls visit(segment) for those whose box, or that of a neighbour, holds the point.
  template <class Visit>
  void visit(Vec2 point, Visit visit) const {
    int patience = kPatience;
    std::uint32_t stack[2 * 32];
    int depth = 0;
    stack[depth++] = 1;
    while (depth > 0 && patience-- > 0) {
      const std::uint32_t node = stack[--depth];
      if (!box_[node].contains(point)) continue;
      if (node < first_leaf_) {
        stack[depth++] = 2 * node + 1;
        stack[depth++] = 2 * node;
        continue;
      }
      const std::size_t begin = std::size_t{node - first_leaf_} * kLeafSegments;
      const std::size_t end = std::min(begin + kLeafSegments, segment_.size());
      for (std::size_t i = begin; i < end; ++i) visit(segment_[i]);
    }
  }

 private:
  static Box stretch_box(const FlatCurves& flat, std::span<const Curve> curves, std::uint32_t s) {
    const double from = flat.parameter[s], to = flat.parameter[s + 1], begin = std::floor(from);
    Box box;
    for (const Vec2 p :
         subcurve(piece_of(curves[flat.vertex_curve[s]], from), from - begin, to - begin)) {
      box.extend(p);
    }
    return box;
  }

  std::vector<std::uint32_t> segment_;
  std::uint32_t leaf_count_ = 0;
  std::uint32_t first_leaf_ = 1;
  std::vector<Box> box_;  ///< of node n, whose children are 2 n and 2 n + 1
};

class JunctionFinder {
 public:
  JunctionFinder(std::span<const Curve> curves, const FlatCurves& flat, double reach)
      : curves_(curves), flat_(flat), reach_squared_(reach * reach) {
    found_.pinned.assign(flat.vertex.size(), 0);
  }

  /// Notes where vertex v lies on segment s, of which it is no end.
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
    found_.junction.push_back({flat_.vertex_curve[s], parameter, p});
  }

  Junctions take() {
    std::sort(found_.junction.begin(), found_.junction.end(),
              [](const Junction& a, const Junction& b) {
                return std::tie(a.curve, a.parameter, a.point.x, a.point.y) <
                       std::tie(b.curve, b.parameter, b.point.x, b.point.y);
              });
    return std::move(found_);
  }

 private:
  static double lerp_parameter(double from, double to, double share) {
    return from + (to - from) * share;
  }

  bool near(Vec2 p, Vec2 q) const { return length_squared(p - q) <= reach_squared_; }

  /// Both are vertices of one curve, its first and its last.
  bool is_own_end(std::uint32_t v, std::uint32_t w) const {
    const std::uint32_t curve = flat_.vertex_curve[v];
    if (flat_.vertex_curve[w] != curve) return false;
    const auto [low, high] = std::minmax(v, w);
    return low == flat_.curve_begin[curve] && high + 1 == flat_.curve_begin[curve + 1];
  }

  std::span<const Curve> curves_;
  const FlatCurves& flat_;
  double reach_squared_;
  Junctions found_;
};

}  // namespace

Result<Junctions> find_junctions(Context& context, std::span<const Curve> curves,
                                 const FlatCurves& flat, double reach) {
  ScopedCharge charge;
  const std::size_t bytes = SegmentTree::bytes(flat.vertex.size());
  if (Status status = charge.add(context, bytes, "flattening"); !status) return status;
  const SegmentTree tree(flat, curves, reach);
  JunctionFinder finder(curves, flat, reach);
  RarePoll<1024> poll(context);
  for (std::uint32_t v = 0; v < flat.vertex.size(); ++v) {
    if (poll.cancelled()) return context.stop_status();
    tree.visit(flat.vertex[v], [&](std::uint32_t s) { finder.look(v, s); });
  }
  return finder.take();
}

}  // namespace sfumato::curves
