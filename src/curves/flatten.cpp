#include "curves/flatten.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "curves/bezier.hpp"
#include "curves/stop_parameters.hpp"

namespace sfumato::curves {
namespace {

/// A chord may slip along its curve by more than it strays across: that moves a colour along the
/// curve, where it changes slowly.
constexpr double kAlongPerAcross = 4;

/// No stretch is halved more often than this, whatever the control points say.
constexpr int kMaxHalvings = 16;

Box bounds(const Cubic& cubic) {
  Box box;
  for (Vec2 p : cubic) box.extend(p);
  return box;
}

constexpr std::size_t kBytesPerVertex = sizeof(Vec2) + 2 * sizeof(double) + sizeof(std::uint32_t);
constexpr std::size_t kFirstVertices = 1024;

class Flattener {
 public:
  Flattener(Context& context, const FlattenOptions& options, FlatCurves& flat)
      : context_(context), poll_(context), options_(options), flat_(flat) {
    if (options.focus) {
      const double margin = 0.1 * std::max(options.focus->width(), options.focus->height());
      focus_ = options.focus->grown_by(margin);
    }
  }

  /// Not ok: nothing more is appended.
  const Status& status() const { return status_; }

  void add_curve(const Curve& curve, std::uint32_t index) {
    curve_ = index;
    collect_cuts(curve);
    push(curve.control_points.front(), 0.0);
    std::size_t next_cut = 0;
    for (std::size_t i = 0; i < curve.piece_count() && status_.ok(); ++i) {
      const Cubic cubic = piece(curve.control_points, i);
      const double begin = static_cast<double>(i);
      double from = 0;
      while (next_cut < cuts_.size() && cuts_[next_cut] < begin + 1) {
        const double cut = cuts_[next_cut++] - begin;
        if (cut > from) add_stretch(cubic, begin, from, cut);
        from = std::max(from, cut);
      }
      add_stretch(cubic, begin, from, 1);
    }
  }

 private:
  template <class Value>
  void collect(std::span<const Vec2> control_points, const StopList<Value>& list) {
    const std::vector<double> parameters = stop_parameters(control_points, list);
    cuts_.insert(cuts_.end(), parameters.begin(), parameters.end());
  }

  void collect_cuts(const Curve& curve) {
    cuts_.clear();
    for (const Side* side : {&curve.left, &curve.right}) {
      collect(curve.control_points, side->color.stops);
      collect(curve.control_points, side->opacity.stops);
      collect(curve.control_points, side->blur_radius);
    }
    std::sort(cuts_.begin(), cuts_.end());
    cuts_.erase(std::unique(cuts_.begin(), cuts_.end()), cuts_.end());
  }

  bool flat_enough(const Cubic& cubic) const {
    const bool in_focus = !focus_ || overlap(bounds(cubic), *focus_);
    const double tolerance = in_focus ? options_.tolerance : options_.outside_tolerance;
    const ChordDeviation deviation = chord_deviation(cubic);
    return deviation.across <= tolerance && deviation.along <= kAlongPerAcross * tolerance;
  }

  /// Appends the stretch (t0, t1] of a piece: halves it until each part is flat, left part first.
  void add_stretch(const Cubic& cubic, double begin, double t0, double t1) {
    struct Part {
      double t0, t1;
      int halvings;
    };
    Part stack[kMaxHalvings + 1];
    int depth = 0;
    stack[depth++] = {t0, t1, 0};
    while (depth > 0 && status_.ok()) {
      const Part part = stack[--depth];
      if (part.halvings == kMaxHalvings || flat_enough(subcurve(cubic, part.t0, part.t1))) {
        push(point_at(cubic, part.t1), begin + part.t1);
        continue;
      }
      const double middle = 0.5 * (part.t0 + part.t1);
      stack[depth++] = {middle, part.t1, part.halvings + 1};
      stack[depth++] = {part.t0, middle, part.halvings + 1};
    }
  }

  void push(Vec2 point, double parameter) {
    if (poll_.cancelled()) status_ = context_.stop_status();
    if (flat_.vertex.size() == room_) make_room();
    if (!status_.ok()) return;
    const bool first = flat_.vertex.size() == flat_.curve_begin[curve_];
    const double before = first ? 0.0 : flat_.arc_length.back();
    const double step = first ? 0.0 : length(point - flat_.vertex.back());
    flat_.vertex.push_back(point);
    flat_.parameter.push_back(parameter);
    flat_.arc_length.push_back(before + step);
    flat_.vertex_curve.push_back(curve_);
  }

  /// Doubles the tables, charged before; old and new are there while one moves to the other.
  void make_room() {
    const std::size_t most = context_.limits.segments + 1;
    if (room_ >= most) {
      status_ = make_error(StatusCode::limit, "more than the limit of " +
                                                  limit_text(context_.limits, &Limits::segments,
                                                             "segments after flattening") +
                                                  "; a larger tolerance makes fewer");
      return;
    }
    const std::size_t larger = std::min(std::max(2 * room_, kFirstVertices), most);
    ScopedCharge charge;
    status_ = charge.add(context_, larger * kBytesPerVertex, "flattening");
    if (!status_) return;
    flat_.vertex.reserve(larger);
    flat_.parameter.reserve(larger);
    flat_.arc_length.reserve(larger);
    flat_.vertex_curve.reserve(larger);
    room_ = larger;
    charge_ = std::move(charge);
  }

  Context& context_;
  RarePoll<1024> poll_;
  Status status_;
  ScopedCharge charge_;
  std::size_t room_ = 0;  ///< vertices that are charged
  const FlattenOptions& options_;
  FlatCurves& flat_;
  std::optional<Box> focus_;
  std::uint32_t curve_ = 0;
  std::vector<double> cuts_;
};

}  // namespace

Result<FlatCurves> flatten(Context& context, std::span<const Curve> curves,
                           const FlattenOptions& options) {
  FlatCurves flat;
  flat.curve_begin.reserve(curves.size() + 1);
  Flattener flattener(context, options, flat);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (context.cancelled()) return context.stop_status();
    flat.curve_begin.push_back(static_cast<std::uint32_t>(flat.vertex.size()));
    flattener.add_curve(curves[i], static_cast<std::uint32_t>(i));
    if (!flattener.status()) return flattener.status();
  }
  flat.curve_begin.push_back(static_cast<std::uint32_t>(flat.vertex.size()));
  return flat;
}

}  // namespace sfumato::curves
