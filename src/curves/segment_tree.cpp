#include "curves/segment_tree.hpp"

#include <cmath>

#include "base/poll.hpp"
#include "base/spatial_order.hpp"
#include "base/try.hpp"

namespace sfumato::curves {
namespace {

Box stretch_box(const FlatCurves& flat, std::span<const Curve> curves, std::uint32_t s) {
  const double from = flat.parameter[s], to = flat.parameter[s + 1], begin = std::floor(from);
  Box box;
  for (const Vec2 p :
       subcurve(piece_of(curves[flat.vertex_curve[s]], from), from - begin, to - begin)) {
    box.extend(p);
  }
  return box;
}

}  // namespace

Cubic piece_of(const Curve& curve, double parameter_of_start) {
  const auto last = static_cast<double>(curve.piece_count() - 1);
  return piece(curve.control_points,
               static_cast<std::size_t>(std::min(std::floor(parameter_of_start), last)));
}

Status SegmentTree::build(Context& context, const FlatCurves& flat, std::span<const Curve> curves,
                          double reach) {
  SFUMATO_TRY(order_segments(context, flat));
  leaf_count_ = (static_cast<std::uint32_t>(segment_.size()) + kLeafSegments - 1) / kLeafSegments;
  while (first_leaf_ < leaf_count_) first_leaf_ *= 2;
  SFUMATO_TRY(memory_.resize(context, box_, std::size_t{2} * first_leaf_));
  RarePoll<4096> poll(context);
  for (std::size_t i = 0; i < segment_.size(); ++i) {
    if (poll.cancelled()) return context.cancel_status();
    Box& leaf = box_[first_leaf_ + i / kLeafSegments];
    leaf = united(leaf, stretch_box(flat, curves, segment_[i]).grown_by(reach));
  }
  for (std::uint32_t node = first_leaf_ - 1; node > 0; --node) {
    if (poll.cancelled()) return context.cancel_status();
    box_[node] = united(box_[std::size_t{2} * node], box_[std::size_t{2} * node + 1]);
  }
  return ok_status();
}

Status SegmentTree::order_segments(Context& context, const FlatCurves& flat) {
  TableMemory working("flattening");
  std::vector<Vec2> middle;
  std::vector<std::uint32_t> segment, order;
  SFUMATO_TRY(working.reserve(context, middle, flat.segment_count()));
  SFUMATO_TRY(working.reserve(context, segment, flat.segment_count()));
  RarePoll<4096> poll(context);
  for (std::uint32_t v = 0; v < flat.vertex.size(); ++v) {
    if (poll.cancelled()) return context.cancel_status();
    if (!flat.begins_segment(v)) continue;
    segment.push_back(v);
    middle.push_back(lerp(flat.vertex[v], flat.vertex[v + 1], 0.5));
  }
  SFUMATO_TRY(spatial_order(context, middle, working, order));
  SFUMATO_TRY(memory_.reserve(context, segment_, segment.size()));
  for (const std::uint32_t i : order) segment_.push_back(segment[i]);
  return ok_status();
}

}  // namespace sfumato::curves
