#include "trace/curves/untangle.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "base/poll.hpp"
#include "base/try.hpp"
#include "curves/bezier.hpp"
#include "trace/curves/crossings.hpp"

namespace sfumato::tracing {
namespace {

/// Shorter loops, pixels or as a share of the curve, are mistakes of a fit; longer ones are shapes.
constexpr double kLeastLoopPx = 12;
constexpr double kLeastLoopShare = 0.15;
/// Parts that are shorter, pixels, show nothing.
constexpr double kLeastPartPx = 4;
/// A part is a double of the curve at which it was cut if no place of it is farther from that
/// curve, pixels.
constexpr double kDoublePx = 1;
constexpr double kCrossingStep = 1;  ///< between samples of curves, pixels
constexpr int kUntangleTurns = 4;
/// Parameters this near to a joint, in pieces, are at the joint.
constexpr double kJoint = 1e-3;

double pieces_of(const TracedCurve& curve) {
  return static_cast<double>((curve.control_points.size() - 1) / 3);
}

/// Returns a parameter's piece and the rest of the parameter in it.
std::pair<curves::Cubic, double> piece_at(const TracedCurve& curve, double parameter) {
  const double piece = std::clamp(std::floor(parameter), 0.0, pieces_of(curve) - 1);
  return {curves::piece(curve.control_points, static_cast<std::size_t>(piece)), parameter - piece};
}

/// Returns the parameter of the place nearest to p, of those around a parameter.
double nearest_on(const TracedCurve& curve, Vec2 p, double parameter) {
  const auto [cubic, t] = piece_at(curve, parameter);
  return parameter - t + std::clamp(curves::nearest_parameter(cubic, p, t), 0.0, 1.0);
}

/// Adds the stretch of the curve between two parameters to points that end where it begins.
void append_stretch(const TracedCurve& curve, double from, double to, std::vector<Vec2>& points) {
  const auto last = static_cast<std::size_t>(pieces_of(curve)) - 1;
  for (std::size_t i = static_cast<std::size_t>(from); i <= last; ++i) {
    const auto begin = static_cast<double>(i);
    const double t0 = std::max(from - begin, 0.0), t1 = std::min(to - begin, 1.0);
    if (t1 - t0 < kJoint) continue;
    const curves::Cubic part = curves::subcurve(curves::piece(curve.control_points, i), t0, t1);
    if (points.empty()) points.push_back(part[0]);
    points.insert(points.end(), part.begin() + 1, part.end());
  }
}

/// Returns the stretch from one parameter on to another; in a closed curve it may pass the start.
TracedCurve stretch(const TracedCurve& curve, double from, double to) {
  TracedCurve part = curve;
  part.side = {};
  part.control_points.clear();
  append_stretch(curve, from, std::min(to, pieces_of(curve)), part.control_points);
  if (to > pieces_of(curve)) append_stretch(curve, 0, to - pieces_of(curve), part.control_points);
  if (part.control_points.empty()) part.control_points.assign(4, curve.control_points.front());
  part.benefit *= length_of(part) / std::max(length_of(curve), 1e-9);
  return part;
}

/// Ends a curve where it begins.
TracedCurve closed(TracedCurve curve) {
  curve.control_points.back() = curve.control_points.front();
  return curve;
}

/// Returns a closed curve without the loop between two parameters, and that loop where it is a
/// shape.
std::vector<TracedCurve> without_loop(const TracedCurve& curve, double first, double second) {
  TracedCurve inner = closed(stretch(curve, first, second));
  TracedCurve outer = closed(stretch(curve, second, first + pieces_of(curve)));
  double least = length_of(inner), most = length_of(outer);
  if (least > most) std::swap(inner, outer), std::swap(least, most);
  std::vector<TracedCurve> kept{std::move(outer)};
  if (least >= std::max(kLeastLoopPx, kLeastLoopShare * (least + most))) {
    kept.push_back(std::move(inner));
  }
  return kept;
}

/// Returns whether a part runs beside another curve all along.
bool is_double(const TracedCurve& part, const TracedCurve& other) {
  const std::vector<CurveSample> places = samples_along(other, kCrossingStep);
  return std::ranges::all_of(samples_along(part, kCrossingStep), [&](const CurveSample& at) {
    return std::ranges::any_of(places, [&](const CurveSample& place) {
      return length(place.point - at.point) <= kDoublePx;
    });
  });
}

/// Returns whether to cut b where it clashes with a; at least one of the two is closed.
bool matters_more(const TracedCurve& a, const TracedCurve& b) {
  if (a.is_frame || b.is_frame) return a.is_frame;
  return is_closed(a) != is_closed(b) ? is_closed(a) : a.benefit > b.benefit;
}

/// Where a curve is to be cut: on another.
struct Cut {
  double parameter = 0;
  std::uint32_t other = 0;
  Vec2 to;  ///< on the other
};

struct Cuts {
  std::vector<Cut> at;
  std::optional<SelfCrossing> loop;
};

class Untangler {
 public:
  Untangler(Context& context, std::vector<TracedCurve>& curves)
      : context_(context), poll_(context), curves_(curves), cuts_(curves.size()) {}

  Result<bool> run(const Crossings& crossings) {
    for (const SelfCrossing& loop : crossings.self) {
      if (is_closed(curves_[loop.curve])) cuts_[loop.curve].loop = loop;
    }
    for (const Clash& clash : crossings.clash) mark(clash);
    std::vector<TracedCurve> out;
    bool is_changed = false;
    for (std::size_t i = 0; i < curves_.size(); ++i) {
      if (poll_.cancelled()) return context_.cancel_status();
      Cuts& cuts = cuts_[i];
      std::vector<TracedCurve> parts;
      if (cuts.loop) {
        parts = without_loop(curves_[i], cuts.loop->first, cuts.loop->second);
      } else if (!cuts.at.empty()) {
        parts = cut(i, cuts);
      } else {
        out.push_back(curves_[i]);
        continue;
      }
      is_changed = true;
      for (TracedCurve& part : parts) {
        if (length_of(part) >= kLeastPartPx) out.push_back(std::move(part));
      }
    }
    curves_ = std::move(out);
    return is_changed;
  }

 private:
  /// Among two curves the open one is cut, else the less important one.
  void mark(const Clash& clash) {
    const TracedCurve &a = curves_[clash.curve[0]], &b = curves_[clash.curve[1]];
    if (!is_closed(a) && !is_closed(b)) return;
    const std::size_t which = matters_more(a, b) ? 1 : 0;
    const std::uint32_t other = clash.curve[1 - which];
    const double parameter = clash.parameter[which];
    const Vec2 at = point_on(curves_[clash.curve[which]], parameter);
    const double landing = nearest_on(curves_[other], at, clash.parameter[1 - which]);
    cuts_[clash.curve[which]].at.push_back({parameter, other, point_on(curves_[other], landing)});
  }

  std::vector<TracedCurve> cut(std::size_t i, Cuts& cuts) const {
    const TracedCurve& curve = curves_[i];
    const double whole = pieces_of(curve);
    std::ranges::sort(cuts.at, {}, &Cut::parameter);
    std::vector<Cut> at = cuts.at;
    if (is_closed(curve)) {
      at.push_back(at.front());
      at.back().parameter += whole;
    } else {
      at.insert(at.begin(), {0, 0, curve.control_points.front()});
      at.push_back({whole, 0, curve.control_points.back()});
    }
    std::vector<TracedCurve> parts;
    for (std::size_t k = 0; k + 1 < at.size(); ++k) {
      if (at[k + 1].parameter - at[k].parameter < kJoint) continue;
      TracedCurve part = stretch(curve, at[k].parameter, at[k + 1].parameter);
      part.control_points.front() = at[k].to;
      part.control_points.back() = at[k + 1].to;
      const bool is_twice = std::ranges::any_of(
          cuts.at, [&](const Cut& by) { return is_double(part, curves_[by.other]); });
      if (!is_twice) parts.push_back(std::move(part));
    }
    return parts;
  }

  Context& context_;
  RarePoll<4> poll_;
  std::vector<TracedCurve>& curves_;
  std::vector<Cuts> cuts_;
};

}  // namespace

Result<bool> untangle(Context& context, int width, int height, std::vector<TracedCurve>& curves) {
  bool is_changed = false;
  // A turn takes one loop of each curve.
  for (int turn = 0; turn < kUntangleTurns; ++turn) {
    SFUMATO_TRY_ASSIGN(const Crossings& crossings, find_crossings(context, curves, width, height));
    SFUMATO_TRY_ASSIGN(const bool now, Untangler(context, curves).run(crossings));
    if (!now) break;
    is_changed = true;
  }
  return is_changed;
}

}  // namespace sfumato::tracing
