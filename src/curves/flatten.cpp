#include "curves/flatten.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/boxes.hpp"
#include "base/charge.hpp"
#include "base/try.hpp"
#include "curves/bezier.hpp"
#include "curves/blur_slope.hpp"
#include "curves/junctions.hpp"
#include "curves/near_curves.hpp"
#include "curves/polyline_builder.hpp"
#include "curves/stop_parameters.hpp"
#include "curves/stop_slope.hpp"
#include "curves/tips.hpp"

namespace sfumato::curves {
namespace {

/// A part that lies this much less beside its chord than its neighbour is straight in comparison.
constexpr double kStraight = 1.0 / 16;

/// A chord may shift along its curve by this factor more than across it: that moves a colour along
/// the curve, where it changes slowly.
constexpr double kAlongPerAcross = 4;
/// The same for the coarse chords that keep bows, and the change of a colour in code values up to
/// which they may shift farther.
constexpr double kAlongPerBow = 0.8;
constexpr double kAlongCodes = 1;

/// For a pixel grid, a chord may stray from its curve by this share of the gap to the nearest other
/// curve. Across a narrow gap colours change fast, so a displaced chord shows.
constexpr double kStrayPerGap = 1.0 / 12;
/// A narrow gap reduces the tolerance to this share at most: 0.04 of 0.2 pixels, which is the
/// tolerance of all other pictures.
constexpr double kLeastShare = 0.2;

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

/// The middle of a chord's arc counts as at least this share of the chord away from its ends.
constexpr double kLeastMiddle = 0.25;

/// Returns the distance between the boxes; 0 where they meet.
double distance(const Box& a, const Box& b) {
  return length({std::max({0.0, a.min.x - b.max.x, b.min.x - a.max.x}),
                 std::max({0.0, a.min.y - b.max.y, b.min.y - a.max.y})});
}

/// The first step: the vertices that the shapes of the curves require, on the curves.
class Divider {
 public:
  /// near   null: it does not matter how near curves pass each other
  Divider(const FlattenOptions& options, const NearCurves* near, PolylineBuilder& out)
      : options_(options), near_(near), out_(out) {}

  void add_curve(const Curve& curve) {
    begin_curve(curve);
    for (std::size_t i = 0; i < curve.piece_count() && out_.status().ok(); ++i)
      add_part(piece(curve.control_points, i), static_cast<double>(i), {0, 1, 0, 0});
  }

  /// Adds a curve that was divided without regard to its neighbours.
  void refine_curve(const Curve& curve, const FlatCurves& coarse, std::uint32_t index) {
    begin_curve(curve);
    const std::uint32_t last = coarse.curve_begin[index + 1] - 1;
    for (std::uint32_t s = coarse.curve_begin[index]; s < last && out_.status().ok(); ++s) {
      const double begin = std::floor(coarse.parameter[s]);
      const double from = coarse.parameter[s] - begin, to = coarse.parameter[s + 1] - begin;
      const int cuts = from == 0 && to == 1 ? 0 : 1;
      add_part(piece_of(curve, begin), begin, {from, to, cuts, s});
    }
  }

 private:
  /// Parts of t in [t0, t1] of a piece.
  struct Part {
    double t0, t1;
    int cuts;
    std::uint32_t segment;  ///< the one of `near` that it belongs to
  };

  void begin_curve(const Curve& curve) {
    slope_.emplace(curve, options_.sharp_radius);
    if (options_.keeps_bows) along_.emplace(curve);
    is_open_ = curve.control_points.front() != curve.control_points.back();
    last_parameter_ = static_cast<double>(curve.piece_count());
    out_.begin_curve();
    out_.push(curve.control_points.front(), 0.0);
  }

  /// Returns by how much more than across its curve a chord may shift along it.
  double along_per_across(double tolerance, double from, double to) const {
    if (!along_) return kAlongPerAcross;
    return std::max(kAlongPerBow, kAlongCodes / (along_->between(from, to) * tolerance));
  }

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

  /// Returns the share of the tolerance that a part may use: beside its neighbours, and at the ends
  /// of open curves, whose direction shows far away.
  double share_of_tolerance(const Cubic& cubic, const Part& part, double begin, double across,
                            double tolerance) const {
    const bool is_end = is_open_ && (begin + part.t0 == 0 || begin + part.t1 == last_parameter_);
    if (options_.keeps_bows && is_end) return kLeastShare;
    if (!near_ || across <= kLeastShare * tolerance) return 1;
    const double gap = near_->distance(part.segment, cubic.front(), cubic.back());
    return std::clamp(kStrayPerGap * gap / tolerance, kLeastShare, 1.0);
  }

  /// Returns the number of parts to cut a stretch into: 1 where it is flat.
  int parts_of(const Cubic& cubic, const Part& part, double begin) const {
    const double from = begin + part.t0, to = begin + part.t1;
    // A whole piece may lie between corners, which do not move.
    const double centered = part.cuts > 0 ? kCentered : 1;
    const double tolerance = centered * tolerance_of(cubic, slope_->between(from, to));
    const ChordDeviation deviation = chord_deviation(cubic);
    const double share = share_of_tolerance(cubic, part, begin, deviation.across, tolerance);
    const double stray =
        std::max(deviation.across / share, deviation.along / along_per_across(tolerance, from, to));
    if (stray <= tolerance || part.cuts == kMaxCuts) return 1;
    // Each of n equal parts deviates n² times less.
    const double of_parts = kCentered / centered * tolerance;
    return stray > 4 * of_parts && stray <= 9 * of_parts ? 3 : 2;
  }

  /// Cuts a part of a piece until each part is flat, left part first: the same points from either
  /// end.
  void add_part(const Cubic& cubic, double begin, const Part& whole) {
    Part stack[2 * kMaxCuts + 1];
    int depth = 0;
    stack[depth++] = whole;
    while (depth > 0 && out_.status().ok()) {
      const Part part = stack[--depth];
      const int parts = parts_of(subcurve(cubic, part.t0, part.t1), part, begin);
      if (parts == 1) {
        out_.push(point_at(cubic, part.t1), begin + part.t1);
        continue;
      }
      const double step = (part.t1 - part.t0) / parts;
      double end = part.t1;
      for (int i = parts - 1; i > 0; --i) {
        stack[depth++] = {part.t0 + i * step, end, part.cuts + 1, part.segment};
        end = part.t0 + i * step;
      }
      stack[depth++] = {part.t0, end, part.cuts + 1, part.segment};
    }
  }

  const FlattenOptions& options_;
  const NearCurves* near_;
  PolylineBuilder& out_;
  std::optional<BlurSlope> slope_;  ///< of the current curve
  std::optional<StopSlope> along_;  ///< the same
  bool is_open_ = false;            ///< the same
  double last_parameter_ = 0;       ///< the same
};

/// Returns the largest tolerance inside a visible box, or the only one.
double largest_tolerance(const FlattenOptions& options) {
  double most = options.focuses.empty() ? options.tolerance : 0;
  for (const FlattenFocus& focus : options.focuses) most = std::max(most, focus.tolerance);
  return most;
}

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
          push(on_chord(k - 1, stop, share), stop, k);
        }
      }
      push(knots_[k].point, knots_[k].parameter, k);
    }
  }

 private:
  /// Appends a vertex on the chord that ends at knot k.
  void push(Vec2 point, double parameter, std::size_t k) {
    if (options_.keeps_bows && k > 0) {
      const FlatCurves& flat = out_.flat();
      out_.set_bow(bow_of(k - 1, {flat.parameter.back(), flat.vertex.back()}, {parameter, point}));
    }
    out_.push(point, parameter);
  }

  /// A vertex and its place on the curve.
  struct ChordEnd {
    double parameter;
    Vec2 point;
  };

  /// Returns the heights of the curve over a part of chord k; 0 where the chord has parts of two
  /// pieces.
  ChordBow bow_of(std::size_t k, const ChordEnd& from, const ChordEnd& to) const {
    const Vec2 chord = to.point - from.point;
    const double size = length(chord);
    if (!(size > 0) || !is_of_one_piece(k)) return {};
    const double start = local_parameter(k, from.parameter), end = local_parameter(k, to.parameter);
    const auto over_chord = [&](double t) {
      const Vec2 p = point_at(stretches_[k], t) - from.point;
      return Vec2{dot(chord, p), cross(chord, p)} / size;
    };
    ChordBow bow{over_chord(start).y, 0, over_chord(end).y};
    const Vec2 middle = over_chord(0.5 * (start + end));
    // The curve's speed varies: that point need not lie over the middle of the chord.
    const double u = std::clamp(middle.x / size, kLeastMiddle, 1 - kLeastMiddle);
    const double bend = (middle.y - bow.start - (bow.end - bow.start) * u) / (u * (1 - u));
    bow.middle = 0.5 * (bow.start + bow.end) + 0.25 * bend;
    return bow;
  }

  bool is_of_one_piece(std::size_t k) const {
    return knots_[k + 1].parameter <= std::floor(knots_[k].parameter) + 1;
  }

  /// Returns the place of a parameter on stretch k, 0 to 1.
  double local_parameter(std::size_t k, double parameter) const {
    return (parameter - knots_[k].parameter) / (knots_[k + 1].parameter - knots_[k].parameter);
  }

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
    const Vec2 from = knots_[k].point, chord = knots_[k + 1].point - from;
    const double chord_squared = length_squared(chord);
    const double local = local_parameter(k, parameter);
    const double along = dot(point_at(stretches_[k], local) - from, chord);
    const double wanted = chord_squared > 0 && is_of_one_piece(k) ? along / chord_squared : local;
    share = std::clamp(wanted, share, 1.0);
    return from + chord * share;
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

namespace {

/// Returns vertices on the curves, between which their stretches are flat.
Result<FlatCurves> divide(Context& context, std::span<const Curve> curves,
                          const FlattenOptions& options) {
  PolylineBuilder divided(context);
  Divider divider(options, nullptr, divided);
  for (const Curve& curve : curves) divider.add_curve(curve);
  divided.end_last_curve();
  if (!divided.status()) return divided.status();
  return divided.take();
}

/// Does the same, with shorter stretches where curves pass near each other.
Result<FlatCurves> divide_finely_where_near(Context& context, std::span<const Curve> curves,
                                            const FlattenOptions& options) {
  SFUMATO_TRY_ASSIGN(const FlatCurves& coarse, divide(context, curves, options));
  ScopedCharge charge;
  SFUMATO_TRY(charge.add(context, bytes_of(coarse), "flattening"));
  NearCurves near(curves, coarse, largest_tolerance(options) / kStrayPerGap, options.reach);
  SFUMATO_TRY(near.build(context));
  PolylineBuilder divided(context);
  Divider divider(options, &near, divided);
  for (std::uint32_t i = 0; i < curves.size(); ++i) divider.refine_curve(curves[i], coarse, i);
  divided.end_last_curve();
  if (!divided.status()) return divided.status();
  return divided.take();
}

}  // namespace

Result<FlatCurves> flatten(Context& context, std::span<const Curve> curves,
                           const FlattenOptions& options) {
  SFUMATO_TRY_ASSIGN(const FlatCurves& divided,
                     options.keeps_bows ? divide_finely_where_near(context, curves, options)
                                        : divide(context, curves, options));
  ScopedCharge charge;
  SFUMATO_TRY(charge.add(context, bytes_of(divided), "flattening"));
  SFUMATO_TRY_ASSIGN(const Junctions& junctions,
                     find_junctions(context, curves, divided, options.reach));
  PolylineBuilder finished(context);
  Finisher finisher(divided, junctions, options, finished);
  for (std::uint32_t i = 0; i < curves.size() && finished.status().ok(); ++i) {
    finisher.add_curve(curves[i], i);
  }
  finished.end_last_curve();
  if (!finished.status()) return finished.status();
  return finished.take();
}

}  // namespace sfumato::curves
