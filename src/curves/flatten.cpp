#include "curves/flatten.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/boxes.hpp"
#include "base/try.hpp"
#include "curves/bezier.hpp"
#include "curves/blur_slope.hpp"
#include "curves/junctions.hpp"
#include "curves/polyline_builder.hpp"
#include "curves/stop_parameters.hpp"
#include "curves/tips.hpp"

namespace sfumato::curves {
namespace {

/// A part that lies this much less beside its chord than its neighbour is straight in comparison.
constexpr double kStraight = 1.0 / 16;

/// A chord may shift along its curve by this factor more than across it: that moves a colour along
/// the curve, where it changes slowly.
constexpr double kAlongPerAcross = 4;

/// No part is cut more often than this, for any control points.
constexpr int kMaxCuts = 16;

/// A chord in the middle of its arc deviates by two thirds as much as one beside it, the first of a
/// curve by 0.7.
constexpr double kCentered = 1.4;

/// Where a curve is blurred, its chords may lie so far beside it that colours are wrong by this,
/// code values, before centering removes a third…
constexpr double kBlurStray = 1.6;
/// …if the tolerance need not be made finer by more than this.
constexpr double kFinestBlur = 8;

/// Curves far outside the visible box only matter there by their direction: chords may deviate by
/// this share of their distance. Colours then change by less than 0.25 code values, also where many
/// stops lie in a line of sight.
constexpr double kStrayPerDistance = 1.0 / 16384;

/// A vertex where the tangent turns by more than this, its sine, is a corner.
constexpr double kCornerSine = 0.02;

/// Returns the distance between the boxes; 0 where they meet.
double distance(const Box& a, const Box& b) {
  return length({std::max({0.0, a.min.x - b.max.x, b.min.x - a.max.x}),
                 std::max({0.0, a.min.y - b.max.y, b.min.y - a.max.y})});
}

/// The first step: the vertices that the shapes of the curves require, on the curves.
class Divider {
 public:
  Divider(const FlattenOptions& options, PolylineBuilder& out) : options_(options), out_(out) {}

  void add_curve(const Curve& curve) {
    const BlurSlope slope(curve, options_.sharp_radius);
    out_.begin_curve();
    out_.push(curve.control_points.front(), 0.0);
    for (std::size_t i = 0; i < curve.piece_count() && out_.status().ok(); ++i) {
      add_piece(piece(curve.control_points, i), static_cast<double>(i), slope);
    }
  }

 private:
  /// Parts of t in [t0, t1] of a piece.
  struct Part {
    double t0, t1;
    int cuts;
  };

  double tolerance_of(const Cubic& cubic, double slope) const {
    double most = options_.tolerance;
    bool is_seen = true;
    if (!options_.focuses.empty()) {
      const Box box = box_of_points(cubic);
      most = std::numeric_limits<double>::infinity();
      is_seen = false;
      for (const FlattenFocus& focus : options_.focuses) {
        const double margin = 0.1 * std::max(focus.box.width(), focus.box.height());
        const bool is_near = overlap(box, focus.box.grown_by(margin));
        const double near = is_near ? focus.tolerance : focus.outside_tolerance;
        most = std::min(most, std::max(near, kStrayPerDistance * distance(box, focus.box)));
        is_seen = is_seen || is_near;
      }
    }
    return is_seen && slope > 0 ? std::clamp(kBlurStray / slope, most / kFinestBlur, most) : most;
  }

  /// Returns the number of parts to cut a stretch into: 1 where it is flat.
  int parts_of(const Cubic& cubic, const Part& part, double slope) const {
    // A whole piece may lie between corners, which do not move.
    const double centered = part.cuts > 0 ? kCentered : 1;
    const double tolerance = centered * tolerance_of(cubic, slope);
    const ChordDeviation deviation = chord_deviation(cubic);
    const double stray = std::max(deviation.across, deviation.along / kAlongPerAcross);
    if (stray <= tolerance || part.cuts == kMaxCuts) return 1;
    // Each of n equal parts deviates n² times less.
    const double of_parts = kCentered / centered * tolerance;
    return stray > 4 * of_parts && stray <= 9 * of_parts ? 3 : 2;
  }

  /// Cuts the piece until each part is flat, left part first: the same points from either end.
  void add_piece(const Cubic& cubic, double begin, const BlurSlope& slope) {
    Part stack[2 * kMaxCuts + 1];
    int depth = 0;
    stack[depth++] = {0, 1, 0};
    while (depth > 0 && out_.status().ok()) {
      const Part part = stack[--depth];
      const int parts = parts_of(subcurve(cubic, part.t0, part.t1), part,
                                 slope.between(begin + part.t0, begin + part.t1));
      if (parts == 1) {
        out_.push(point_at(cubic, part.t1), begin + part.t1);
        continue;
      }
      const double step = (part.t1 - part.t0) / parts;
      double end = part.t1;
      for (int i = parts - 1; i > 0; --i) {
        stack[depth++] = {part.t0 + i * step, end, part.cuts + 1};
        end = part.t0 + i * step;
      }
      stack[depth++] = {part.t0, end, part.cuts + 1};
    }
  }

  const FlattenOptions& options_;
  PolylineBuilder& out_;
};

bool is_of_one_paint(const Side& side) {
  return side.color.stops.stops.size() <= 1 && side.opacity.stops.stops.size() <= 1;
}

/// Returns whether a curve is the outline of a shape: it closes, and each side has one paint all
/// around. Pixels of one side that show on the other are then wrong.
bool is_outline(const Curve& curve) {
  return curve.control_points.front() == curve.control_points.back() &&
         is_of_one_paint(curve.left) && is_of_one_paint(curve.right);
}

/// Returns a list with stops where the value passes `value`.
ScalarStops split_at(const ScalarStops& list, double value) {
  ScalarStops split{list.space, {}};
  for (const auto& stop : list.stops) {
    if (!split.stops.empty()) {
      const auto& before = split.stops.back();
      const double share = (value - before.value) / (double{stop.value} - before.value);
      if (share > 0 && share < 1) {
        split.stops.push_back({lerp(before.offset, stop.offset, share), static_cast<float>(value)});
      }
    }
    split.stops.push_back(stop);
  }
  return split;
}

/// The second step: moves the vertices of the first step and the junctions until chords lie in the
/// middle of their arcs, and puts stops on the chords.
class Finisher {
 public:
  Finisher(const FlatCurves& divided, const Junctions& junctions, const FlattenOptions& options,
           PolylineBuilder& out)
      : divided_(divided), junctions_(junctions), options_(options), out_(out) {}

  /// Adds a curve. Call it for all curves in their order.
  void add_curve(const Curve& curve, std::uint32_t index) {
    collect_knots(index);
    collect_stretches(curve);
    center_chords();
    if (is_outline(curve) && clear_tips(knots_, options_.reach)) collect_stretches(curve);
    collect_stops(curve);
    out_.begin_curve();
    std::size_t next_stop = 0;
    for (std::size_t k = 0; k < knots_.size() && out_.status().ok(); ++k) {
      double share = 0;
      while (next_stop < stops_.size() && stops_[next_stop] <= knots_[k].parameter) {
        const double stop = stops_[next_stop++];
        if (k > 0 && stop > knots_[k - 1].parameter && stop < knots_[k].parameter) {
          out_.push(on_chord(k - 1, stop, share), stop);
        }
      }
      out_.push(knots_[k].point, knots_[k].parameter);
    }
  }

 private:
  void collect_knots(std::uint32_t index) {
    knots_.clear();
    const auto& junction = junctions_.junction;
    for (std::uint32_t v = divided_.curve_begin[index]; v < divided_.curve_begin[index + 1]; ++v) {
      const double parameter = divided_.parameter[v];
      for (; next_junction_ < junction.size() && junction[next_junction_].curve == index &&
             junction[next_junction_].parameter < parameter;
           ++next_junction_) {
        const Junction& at = junction[next_junction_];
        // Vertices of several curves may coincide.
        if (length(at.point - knots_.back().point) <= options_.reach) continue;
        knots_.push_back({at.parameter, at.point, true, true});
      }
      knots_.push_back({parameter, divided_.vertex[v], junctions_.pinned[v] != 0, false});
    }
  }

  /// Collects the stretch of curve from each knot to the next; unusable where it has parts of two
  /// pieces.
  void collect_stretches(const Curve& curve) {
    stretches_.clear();
    for (std::size_t k = 0; k + 1 < knots_.size(); ++k) {
      const double begin = std::floor(knots_[k].parameter);
      stretches_.push_back(subcurve(piece(curve.control_points, static_cast<std::size_t>(begin)),
                                    knots_[k].parameter - begin, knots_[k + 1].parameter - begin));
    }
  }

  /// Moves every smooth knot by the mean distance of its two chords inside their arcs: chords of
  /// equal depth then lie in the middle.
  void center_chords() {
    const std::size_t last = knots_.size() - 1;
    const bool closed = knots_.front().point == knots_.back().point;
    if (closed && !knots_.front().pinned && !knots_.back().pinned) {
      const Vec2 shift = shift_between(stretches_.back(), stretches_.front());
      knots_.front().point = knots_.back().point = knots_.front().point + shift;
    }
    for (std::size_t k = 1; k < last; ++k) {
      if (knots_[k].pinned) continue;
      knots_[k].point = knots_[k].point + shift_between(stretches_[k - 1], stretches_[k]);
    }
  }

  static Vec2 shift_between(const Cubic& before, const Cubic& after) {
    const Vec2 in = before[3] - before[2], out = after[1] - after[0];
    const double turn = std::fabs(cross(in, out)), ahead = dot(in, out);
    // Does not move it where the curve's speed is 0, either.
    if (!(ahead > 0 && turn <= kCornerSine * ahead)) return {};
    const Vec2 shift_in = mean_deviation(before), shift_out = mean_deviation(after);
    const auto [least, most] = std::minmax({length_squared(shift_in), length_squared(shift_out)});
    // A straight edge stays in place: a frame on pixel borders must not cut pixels beyond.
    if (least < kStraight * kStraight * most) return {};
    return 0.5 * (shift_in + shift_out);
  }

  template <class Value>
  void collect(std::span<const Vec2> control_points, const StopList<Value>& list) {
    const std::vector<double> parameters = stop_parameters(control_points, list);
    stops_.insert(stops_.end(), parameters.begin(), parameters.end());
  }

  void collect_stops(const Curve& curve) {
    stops_.clear();
    for (const Side* side : {&curve.left, &curve.right}) {
      collect(curve.control_points, side->color.stops);
      collect(curve.control_points, side->opacity.stops);
      collect(curve.control_points, split_at(side->blur_radius, options_.split_radius));
    }
    std::sort(stops_.begin(), stops_.end());
    stops_.erase(std::unique(stops_.begin(), stops_.end()), stops_.end());
  }

  /// Returns the point of chord k nearest to the curve's at the parameter. `share` is the position
  /// of the last point along the chord, and then of this one.
  Vec2 on_chord(std::size_t k, double parameter, double& share) const {
    const Knot &from = knots_[k], &to = knots_[k + 1];
    const Vec2 chord = to.point - from.point;
    const double chord_squared = length_squared(chord);
    const double local = (parameter - from.parameter) / (to.parameter - from.parameter);
    const double along = dot(point_at(stretches_[k], local) - from.point, chord);
    const bool is_of_one_piece = to.parameter <= std::floor(from.parameter) + 1;
    const double wanted = chord_squared > 0 && is_of_one_piece ? along / chord_squared : local;
    share = std::clamp(wanted, share, 1.0);
    return from.point + chord * share;
  }

  const FlatCurves& divided_;
  const Junctions& junctions_;
  const FlattenOptions& options_;
  PolylineBuilder& out_;
  std::size_t next_junction_ = 0;
  std::vector<Knot> knots_;  ///< for the current curve, as are the tables below
  std::vector<Cubic> stretches_;
  std::vector<double> stops_;
};

}  // namespace

Result<FlatCurves> flatten(Context& context, std::span<const Curve> curves,
                           const FlattenOptions& options) {
  PolylineBuilder divided(context);
  Divider divider(options, divided);
  for (const Curve& curve : curves) divider.add_curve(curve);
  divided.end_last_curve();
  if (!divided.status()) return divided.status();
  SFUMATO_TRY_ASSIGN(const Junctions& junctions,
                     find_junctions(context, curves, divided.flat(), options.reach));
  PolylineBuilder finished(context);
  Finisher finisher(divided.flat(), junctions, options, finished);
  for (std::uint32_t i = 0; i < curves.size() && finished.status().ok(); ++i) {
    finisher.add_curve(curves[i], i);
  }
  finished.end_last_curve();
  if (!finished.status()) return finished.status();
  return finished.take();
}

}  // namespace sfumato::curves
