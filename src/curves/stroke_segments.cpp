#include "curves/stroke_segments.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/boxes.hpp"
#include "base/limit_error.hpp"
#include "base/try.hpp"
#include "curves/bezier.hpp"
#include "curves/stop_parameters.hpp"

namespace sfumato::curves {
namespace {

/// No stretch is halved more often than this, for any control points.
constexpr int kMaxHalvings = 48;

/// The largest change of the tangent from one node to the next, as a part of its mean length.
constexpr double kBendPerNode = 0.15;

/// The number of nodes of a stretch that is shorter than the distance allowed between nodes.
constexpr double kShortNodes = 4;

/// Attributes are linear in the arc length but are treated as linear in the segment's parameter.
/// This is the largest allowed error, code values or parts of the influence radius.
constexpr double kLargestSlip = 0.0005;

/// Radii are limited to this, pixels: their squares stay within single precision.
constexpr double kLargestRadius = 1e15;

/// The place of a stretch on its curve: both ends by parameter and by fraction of the length.
struct Stretch {
  double parameter[2];
  double fraction[2];
};

/// A stop list along the curve, queried for stretches that contain no stop, in ascending order,
/// except that parts of an earlier stretch may follow.
template <class Value>
class StopCursor {
 public:
  explicit StopCursor(const StopList<Value>& list) : list_(list) {}

  /// Prepares the cursor; call it first. Errors: limit (memory), cancelled.
  Status prepare(Context& context, std::span<const Vec2> control_points,
                 std::span<const double> cumulative, TableMemory& memory) {
    SFUMATO_TRY(memory.reserve(context, parameters_, list_.stops.size()));
    append_stop_parameters(control_points, cumulative, list_, parameters_);
    return ok_status();
  }

  const std::vector<double>& parameters() const { return parameters_; }

  SegmentValues<Value> values(const Stretch& stretch) {
    const double middle = 0.5 * (stretch.parameter[0] + stretch.parameter[1]);
    while (next_ < parameters_.size() && parameters_[next_] <= middle) ++next_;
    if (next_ == 0) return {list_.stops.front().value, list_.stops.front().value};
    if (next_ == parameters_.size()) return {list_.stops.back().value, list_.stops.back().value};
    const Stop<Value>&before = list_.stops[next_ - 1], &after = list_.stops[next_];
    const double* position =
        list_.space == StopSpace::parameter ? stretch.parameter : stretch.fraction;
    const auto at = [&](double x) {
      const double width = after.offset - before.offset;
      const double share = width > 0 ? std::clamp((x - before.offset) / width, 0.0, 1.0) : 0.0;
      return lerp(before.value, after.value, static_cast<float>(share));
    };
    return {at(position[0]), at(position[1])};
  }

 private:
  const StopList<Value>& list_;
  std::vector<double> parameters_;
  std::size_t next_ = 0;
};

double largest_change(const SegmentValues<Rgb>& values) {
  const Rgb &a = values.start, &b = values.end;
  return std::max({std::fabs(b.r - a.r), std::fabs(b.g - a.g), std::fabs(b.b - a.b)});
}

class SegmentMaker {
 public:
  SegmentMaker(Context& context, const StrokeOptions& options, StrokeSegments& out)
      : context_(context),
        options_(options),
        out_(out),
        left_cursor_(left_),
        right_cursor_(right_),
        blur_cursor_(blur_),
        influence_cursor_(influence_) {
    const Affine& m = options.image_from_stroke;
    const double k = 1 / options.scale;
    image_from_frame_ = {m.a * k, m.b * k, m.c * k, m.d * k, m.e, m.f};
    reach_per_radius_ = {length({image_from_frame_.a, image_from_frame_.c}),
                         length({image_from_frame_.b, image_from_frame_.d})};
  }

  Status run(const LocalCurve& curve) {
    Status status = copy(curve);
    if (!status || !(total_length_ > 0)) return status;
    std::vector<double> cuts;
    if (status = collect_cuts(cuts); !status) return status;
    std::size_t next_cut = 0;
    for (std::size_t i = 0; status && 3 * i + 3 < points_.size(); ++i) {
      if (context_.cancelled()) return context_.cancel_status();
      const Cubic cubic = piece(points_, i);
      const double begin = static_cast<double>(i);
      double from = 0;
      while (status && next_cut < cuts.size() && cuts[next_cut] < begin + 1) {
        const double cut = cuts[next_cut++] - begin;
        if (cut > from) status = add_stretch(cubic, begin, from, cut);
        from = std::max(from, cut);
      }
      if (status) status = add_stretch(cubic, begin, from, 1);
    }
    return status;
  }

 private:
  /// Copies the parts of the curve that the segments are made of, scaled and in the interpolation
  /// space.
  Status copy(const LocalCurve& curve) {
    Status status = memory_.append(context_, std::span(curve.control_points), points_);
    const auto copy_stops = [&](const auto& from, auto& to) {
      to.space = from.space;
      if (status) status = memory_.append(context_, std::span(from.stops), to.stops);
    };
    copy_stops(curve.left_color.empty() ? curve.right_color : curve.left_color, left_);
    copy_stops(curve.right_color.empty() ? curve.left_color : curve.right_color, right_);
    copy_stops(curve.blur_radius, blur_);
    copy_stops(curve.influence_radius, influence_);
    if (!status) return status;
    for (Vec2& p : points_) p = p * options_.scale;
    SFUMATO_TRY_ASSIGN(const auto& lengths, cumulative_length(context_, points_, memory_));
    total_length_ = lengths.back();
    left_ = in_space(std::move(left_), options_.interpolation);
    right_ = in_space(std::move(right_), options_.interpolation);
    scale(blur_);
    scale(influence_);
    const auto prepare = [&](auto& cursor) {
      if (status) status = cursor.prepare(context_, points_, lengths, memory_);
    };
    prepare(left_cursor_);
    prepare(right_cursor_);
    prepare(blur_cursor_);
    prepare(influence_cursor_);
    return status;
  }

  void scale(ScalarStops& list) const {
    if (list.stops.empty()) list.stops.push_back({0, 0});
    for (Stop<float>& stop : list.stops) {
      stop.value = static_cast<float>(std::min(stop.value * options_.scale, kLargestRadius));
    }
  }

  Status collect_cuts(std::vector<double>& cuts) {
    const std::size_t count = left_cursor_.parameters().size() + right_cursor_.parameters().size() +
                              blur_cursor_.parameters().size() +
                              influence_cursor_.parameters().size();
    SFUMATO_TRY(memory_.reserve(context_, cuts, count));
    const auto collect = [&](const std::vector<double>& parameters) {
      cuts.insert(cuts.end(), parameters.begin(), parameters.end());
    };
    collect(left_cursor_.parameters());
    collect(right_cursor_.parameters());
    collect(blur_cursor_.parameters());
    collect(influence_cursor_.parameters());
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    return ok_status();
  }

  /// Halves (t0, t1] of a piece until its parts are segments, left part first.
  Status add_stretch(const Cubic& cubic, double begin, double t0, double t1) {
    struct Part {
      double t0, t1;
      int halvings;
    };
    Part stack[kMaxHalvings + 1];
    int depth = 0;
    stack[depth++] = {t0, t1, 0};
    while (depth > 0) {
      const Part part = stack[--depth];
      const Cubic part_cubic = subcurve(cubic, part.t0, part.t1);
      const double part_length = arc_length(part_cubic, 0, 1);
      const Stretch stretch{{begin + part.t0, begin + part.t1},
                            {walked_ / total_length_, (walked_ + part_length) / total_length_}};
      const SegmentValues<float> influence = influence_cursor_.values(stretch);
      const Box reach = reach_of(part_cubic, std::max(influence.start, influence.end));
      const bool seen = part_length > 0 && overlap(reach, options_.image);
      const double nodes = seen ? nodes_of(part_cubic, part_length, influence) : 0;
      const bool fine = nodes <= kStrokeNodes &&
                        (!seen || slip_of(part_cubic, stretch, influence) <= kLargestSlip);
      if (fine || part.halvings == kMaxHalvings) {
        walked_ += part_length;
        if (!seen) continue;
        const int count = static_cast<int>(std::clamp<double>(nodes, 1, kStrokeNodes));
        SFUMATO_TRY(append(part_cubic, part_length, stretch, influence, count, reach));
        continue;
      }
      const double middle = 0.5 * (part.t0 + part.t1);
      stack[depth++] = {middle, part.t1, part.halvings + 1};
      stack[depth++] = {part.t0, middle, part.halvings + 1};
    }
    return ok_status();
  }

  Box reach_of(const Cubic& cubic, double influence) const {
    const double radius = std::max(influence, options_.smallest_radius);
    Box box;
    for (Vec2 p : cubic) {
      const Vec2 q = image_from_frame_(p);
      box.extend(q - reach_per_radius_ * radius);
      box.extend(q + reach_per_radius_ * radius);
    }
    return box;
  }

  /// Returns the number of nodes that a stretch needs: close enough for its radius, and for its
  /// bends.
  double nodes_of(const Cubic& c, double part_length, const SegmentValues<float>& influence) const {
    const Vec2 leg[3] = {c[1] - c[0], c[2] - c[1], c[3] - c[2]};
    double speed = 0, bend = 0, mean = 0;
    for (int i = 0; i < 3; ++i) {
      speed = std::max(speed, 3 * length(leg[i]));
      bend = std::max(bend, length(leg[i] - leg[(i + 1) % 3]));
      mean += length(leg[i]) / 3;
    }
    const double radius =
        std::max<double>(std::min(influence.start, influence.end), options_.smallest_radius);
    const double apart = radius / options_.nodes_per_radius;
    const double for_radius = std::ceil(speed / apart);
    const double for_bends = std::ceil(bend / (kBendPerNode * mean));
    return std::max(for_radius,
                    part_length <= apart ? std::min(for_bends, kShortNodes) : for_bends);
  }

  /// Bounds the slip: the share of the length differs from u by at most an eighth of the speed's
  /// relative change.
  double slip_of(const Cubic& c, const Stretch& stretch, const SegmentValues<float>& influence) {
    const double leg[3] = {length(c[1] - c[0]), length(c[2] - c[1]), length(c[3] - c[2])};
    const double slowest = std::min({leg[0], leg[1], leg[2]});
    const double fastest = std::max({leg[0], leg[1], leg[2]});
    const double radius =
        std::max<double>(std::min(influence.start, influence.end), options_.smallest_radius);
    const double change = std::max({std::fabs(influence.end - influence.start) / radius,
                                    largest_change(left_cursor_.values(stretch)),
                                    largest_change(right_cursor_.values(stretch))});
    return change * (fastest - slowest) / fastest / 8;
  }

  Status append(const Cubic& c, double part_length, const Stretch& stretch,
                const SegmentValues<float>& influence, int node_count, const Box& reach) {
    SFUMATO_TRY(reserve());
    StrokeSegment segment;
    segment.start = c[0];
    const Vec2 coefficient[3] = {3 * (c[1] - c[0]), 3 * (c[2] - 2 * c[1] + c[0]),
                                 c[3] - c[0] + 3 * (c[1] - c[2])};
    for (int i = 0; i < 3; ++i) {
      segment.coefficient[i][0] = static_cast<float>(coefficient[i].x);
      segment.coefficient[i][1] = static_cast<float>(coefficient[i].y);
    }
    double speeds = 0;
    for (int k = 0; k < node_count; ++k) {
      speeds += length(derivative_at(c, (k + 0.5) / node_count));
    }
    if (!(speeds > 0)) return ok_status();
    segment.length_per_speed = static_cast<float>(part_length / speeds);
    segment.node_count = node_count;
    segment.influence_radius = influence;
    segment.blur_radius = blur_cursor_.values(stretch);
    segment.left = left_cursor_.values(stretch);
    segment.right = right_cursor_.values(stretch);
    out_.segment.push_back(segment);
    out_.reach.push_back(intersection(reach, options_.image));
    return ok_status();
  }

  /// Reserves room for one more segment.
  Status reserve() {
    const std::size_t capacity = out_.segment.capacity();
    if (out_.segment.size() < capacity) return ok_status();
    const std::size_t most = context_.limits.segments;
    if (capacity >= most) {
      return limit_error(context_.limits, &Limits::segments,
                         "segments in one local curve; a larger radius makes fewer");
    }
    const std::size_t larger = std::min(std::max<std::size_t>(2 * capacity, 8), most);
    Status status = out_.memory.reserve(context_, out_.reach, larger);
    return status ? out_.memory.reserve(context_, out_.segment, larger) : status;
  }

  Context& context_;
  const StrokeOptions& options_;
  StrokeSegments& out_;
  TableMemory memory_{"a local curve"};  ///< for the copied parts of the curve
  std::vector<Vec2> points_;
  double total_length_ = 0;
  ColorStops left_, right_;
  ScalarStops blur_, influence_;
  StopCursor<Rgb> left_cursor_, right_cursor_;
  StopCursor<float> blur_cursor_, influence_cursor_;
  Affine image_from_frame_;
  Vec2 reach_per_radius_;
  double walked_ = 0;
};

}  // namespace

bool is_two_sided(const LocalCurve& curve) {
  return !curve.left_color.empty() && !curve.right_color.empty() &&
         !(curve.left_color == curve.right_color);
}

Result<StrokeSegments> stroke_segments(Context& context, const LocalCurve& curve,
                                       const StrokeOptions& options) {
  StrokeSegments segments;
  SegmentMaker maker(context, options, segments);
  SFUMATO_TRY(maker.run(curve));
  return segments;
}

}  // namespace sfumato::curves
