#include "trace/curves/snap.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "curves/bezier.hpp"

namespace sfumato::tracing {
namespace {

constexpr double kSnapStep = 0.5;  ///< between samples of curves, pixels
/// An end snaps to a curve within this distance in any direction except backwards, pixels times
/// √scale, at most kMostReach…
constexpr double kEndReach = 1.5;
constexpr double kMostReach = 3;
constexpr double kLeastCosine = -0.3;
/// …and straight ahead, within 45°, to a curve within this distance: pixels, and a share of the
/// picture's longer side, since a gap that shows at a glance is intended.
constexpr double kAheadPx = 4.5;
constexpr double kAheadShare = 4.5 / 512;
constexpr double kAhead = 0.7071;
/// An end ignores the part of its own curve that is nearer along the curve, in reaches and pixels.
constexpr double kOwnReaches = 3;
constexpr double kOwnPixels = 4;
/// A piece is continued by at most this share of itself.
constexpr double kLongest = 1.5;
/// Before its end a curve that snaps to another is not to cross it, over this length, pixels.
constexpr double kBackPx = 6;
constexpr int kSnapParts = 64;
/// Ends of one curve that are nearer to each other than this and than a share of its length make a
/// closed curve.
constexpr double kClosePx = 4.5;
constexpr double kCloseShare = 0.02;
/// Steps of a side are at least so far apart, and from its ends, pixels.
constexpr double kStepApartPx = 1.5;
/// On the last piece of a curve, before its end.
constexpr double kNearEnd = 0.9;

/// Places of curves by the pixel that they lie in.
class PlaceGrid {
 public:
  struct Place {
    Vec2 point;
    std::uint32_t curve;
    double parameter;
    double from_start;  ///< along the curve, pixels
  };

  PlaceGrid(int width, int height) : width_(width), height_(height) {}

  /// Errors: limit (memory), cancelled.
  Status create(const Context& context) {
    return memory_.resize(context, first_,
                          static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_),
                          kNone);
  }

  /// Errors: limit (memory), cancelled.
  Status add(const Context& context, std::uint32_t index, const TracedCurve& curve) {
    const std::vector<CurveSample> samples = samples_along(curve, kSnapStep);
    SFUMATO_TRY(memory_.make_room(context, next_, samples.size()));
    SFUMATO_TRY(memory_.make_room(context, place_, samples.size()));
    double along = 0;
    std::optional<Vec2> last;
    for (const CurveSample& sample : samples) {
      if (last) along += length(sample.point - *last);
      last = sample.point;
      std::uint32_t& head = first_[cell(sample.point)];
      next_.push_back(head);
      head = static_cast<std::uint32_t>(place_.size());
      place_.push_back({sample.point, index, sample.parameter, along});
    }
    return ok_status();
  }

  /// visit(place) for all within about `reach` of p.
  template <class Visit>
  void near(Vec2 p, double reach, Visit visit) const {
    const int x0 = column(p.x - reach), x1 = column(p.x + reach);
    const int y0 = line(p.y - reach), y1 = line(p.y + reach);
    for (int y = y0; y <= y1; ++y) {
      for (int x = x0; x <= x1; ++x) {
        const std::size_t at = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                               static_cast<std::size_t>(x);
        for (std::uint32_t i = first_[at]; i != kNone; i = next_[i]) visit(place_[i]);
      }
    }
  }

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;

  int column(double x) const { return std::clamp(static_cast<int>(x), 0, width_ - 1); }
  int line(double y) const { return std::clamp(static_cast<int>(y), 0, height_ - 1); }
  std::size_t cell(Vec2 p) const {
    return static_cast<std::size_t>(line(p.y)) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(column(p.x));
  }

  int width_, height_;
  TableMemory memory_{"places of curves"};
  std::vector<std::uint32_t> first_;  ///< per pixel: a place in it
  std::vector<std::uint32_t> next_;   ///< per place: another one in its pixel
  std::vector<Place> place_;
};

/// A place on a curve, and the curve's direction there.
struct Landing {
  Vec2 point, along;
  double parameter;
};

/// Returns the place nearest to p, of those around a parameter.
Landing landing_on(const TracedCurve& curve, double parameter, Vec2 p) {
  const std::size_t pieces = (curve.control_points.size() - 1) / 3;
  const auto piece = std::min(static_cast<std::size_t>(parameter), pieces - 1);
  const curves::Cubic cubic = curves::piece(curve.control_points, piece);
  const double t = std::clamp(
      curves::nearest_parameter(cubic, p, parameter - static_cast<double>(piece)), 0.0, 1.0);
  return {curves::point_at(cubic, t), curves::derivative_at(cubic, t),
          static_cast<double>(piece) + t};
}

/// Gives a side of a curve a step of its values, unless one is near or the place is an end of it.
void add_step(const TracedCurve& curve, SideStops& side, const Landing& landing) {
  if (side.place.empty()) return;
  const auto is_near = [&](double parameter) {
    return length(point_on(curve, parameter) - landing.point) < kStepApartPx;
  };
  if (is_near(side.place.front()) || is_near(side.place.back())) return;
  for (auto i = side.place.begin() + 1; i != side.place.end(); ++i) {
    if (*i == *(i - 1) && is_near(*i)) return;
  }
  const auto next = std::ranges::lower_bound(side.place, landing.parameter);
  if (next == side.place.begin() || next == side.place.end()) return;
  const SideValue value = value_at(side, landing.parameter);
  const auto at = next - side.place.begin();
  side.place.insert(next, 2, landing.parameter);
  side.value.insert(side.value.begin() + at, 2, value);
}

/// Closes a curve whose ends nearly meet.
void close_if_nearly(TracedCurve& curve) {
  std::vector<Vec2>& points = curve.control_points;
  const Vec2 gap = points.front() - points.back();
  const double far = length(gap);
  if (far == 0 || far > kClosePx || far > kCloseShare * length_of(curve)) return;
  points.back() = points.front();
  points[points.size() - 2] = points[points.size() - 2] + gap;
}

bool leaks(const TracedCurve& curve, bool is_last, float most) {
  const auto& [left, right] = curve.side;
  if (left.value.empty() || right.value.empty()) return false;
  const SideValue& a = is_last ? left.value.back() : left.value.front();
  const SideValue& b = is_last ? right.value.back() : right.value.front();
  for (std::size_t c = 0; c < a.size(); ++c) {
    if (std::fabs(a[c] - b[c]) > most) return true;
  }
  return false;
}

/// Returns the cubic from its start to t, which may be beyond its end, moved to end at `to`.
curves::Cubic ended_at(const curves::Cubic& cubic, double t, Vec2 to) {
  curves::Cubic part = curves::subcurve(cubic, 0, t);
  part[2] = part[2] + (to - part[3]);
  part[3] = to;
  return part;
}

/// Where the cubic, going on as it does, comes nearest to a point: a parameter around 1.
double parameter_towards(const curves::Cubic& cubic, Vec2 to) {
  double best = 1, least = length(cubic[3] - to);
  for (int i = 0; i <= kSnapParts; ++i) {
    const double t = std::lerp(2 - kLongest, kLongest, static_cast<double>(i) / kSnapParts);
    const double far = length(curves::point_at(cubic, t) - to);
    if (far < least) best = t, least = far;
  }
  return best;
}

/// Where within the last kBackPx the cubic crosses the line of a landing; 1: nowhere before its
/// end.
double crossing_before_end(const curves::Cubic& cubic, const Landing& landing) {
  const double way = std::max(curves::arc_length(cubic, 0, 1), 1e-9);
  const double begin = std::max(0.0, 1 - kBackPx / way);
  const auto side_at = [&](double t) {
    return cross(curves::point_at(cubic, t) - landing.point, landing.along);
  };
  const double first = side_at(begin);
  for (int i = 1; i < kSnapParts; ++i) {
    const double t = std::lerp(begin, 1.0, static_cast<double>(i) / kSnapParts);
    if (side_at(t) * first < 0) return t;
  }
  return 1;
}

/// A shorter rest of a curve, pixels, shows nothing.
constexpr double kLeastLength = 3;
/// Within this distance of where a tangent is crossed, pixels, the curve is.
constexpr double kCrossed = 0.5;

class Snapper {
 public:
  Snapper(const PlaceGrid& grid, double ahead, const SnapOptions& options,
          std::vector<TracedCurve>& curves)
      : grid_(grid),
        ahead_(ahead),
        leak_(options.leak),
        lands_ahead_(options.lands_ahead),
        curves_(curves) {}

  /// Leads an end on, or back, to the curve that it almost meets.
  void snap(std::uint32_t index, bool is_last) {
    if (!leaks(curves_[index], is_last, leak_)) return;
    change_end(index, is_last, [&](curves::Cubic& cubic) { return lead(index, is_last, cubic); });
  }

  /// Cuts off the end that sticks out beyond a curve that it crosses shortly before.
  void trim(std::uint32_t index, bool is_last) {
    change_end(index, is_last, [&](curves::Cubic& cubic) { return cut(index, is_last, cubic); });
  }

 private:
  /// change(cubic) may change the last piece, which runs outwards; it says whether it did.
  template <class Change>
  void change_end(std::uint32_t index, bool is_last, Change change) {
    std::vector<Vec2>& points = curves_[index].control_points;
    const std::size_t first = is_last ? points.size() - 4 : 0;
    curves::Cubic cubic = curves::piece(points, first / 3);
    if (!is_last) std::ranges::reverse(cubic);
    if (!change(cubic)) return;
    if (!is_last) std::ranges::reverse(cubic);
    std::ranges::copy(cubic, points.begin() + static_cast<std::ptrdiff_t>(first));
  }

  bool cut(std::uint32_t index, bool is_last, curves::Cubic& cubic) {
    double first = 1;
    Landing to{};
    std::uint32_t host = 0;
    for (const PlaceGrid::Place& place : nearest_places(index, cubic[3], is_last)) {
      const TracedCurve& other = curves_[place.curve];
      const double t = crossing_before_end(cubic, landing_on(other, place.parameter, cubic[3]));
      if (t >= first) continue;
      const Vec2 crossed = curves::point_at(cubic, t);
      const Landing landing = landing_on(other, place.parameter, crossed);
      if (length(landing.point - crossed) > kCrossed) continue;
      first = t;
      to = landing;
      host = place.curve;
    }
    if (first == 1) return false;
    cubic = ended_at(cubic, first, to.point);
    if (leaks(curves_[index], is_last, leak_)) part_at(host, to, cubic);
    return true;
  }

  /// Finds the place nearest to an end on each near curve.
  std::vector<PlaceGrid::Place> nearest_places(std::uint32_t index, Vec2 end, bool is_last) const {
    const double whole = length_of(curves_[index]);
    const double own = kOwnReaches * kBackPx + kOwnPixels;
    std::vector<PlaceGrid::Place> nearest;
    grid_.near(end, kBackPx, [&](const PlaceGrid::Place& place) {
      const double along = is_last ? whole - place.from_start : place.from_start;
      if (place.curve == index && along < own) return;
      const auto same = std::ranges::find(nearest, place.curve, &PlaceGrid::Place::curve);
      if (same == nearest.end()) return nearest.push_back(place);
      if (length(place.point - end) < length(same->point - end)) *same = place;
    });
    return nearest;
  }

  /// Makes the last piece of a curve, which runs outwards, end on a curve; false: on none.
  bool lead(std::uint32_t index, bool is_last, curves::Cubic& cubic) {
    const std::optional<PlaceGrid::Place> place = target(index, cubic, is_last);
    if (!place) return false;
    const TracedCurve& other = curves_[place->curve];
    Landing landing = lands_ahead_ ? landing_ahead(other, *place, cubic)
                                   : landing_on(other, place->parameter, cubic[3]);
    cubic = ended_at(cubic, parameter_towards(cubic, landing.point), landing.point);
    const double crossing = crossing_before_end(cubic, landing);
    if (crossing < 1) {
      landing = landing_on(other, place->parameter, curves::point_at(cubic, crossing));
      cubic = ended_at(cubic, crossing, landing.point);
    }
    part_at(place->curve, landing, cubic);
    return true;
  }

  /// Returns the place where the straight continuation of a cubic meets a curve or, if there is
  /// none within reach, the place of the curve nearest to its end.
  Landing landing_ahead(const TracedCurve& other, const PlaceGrid::Place& place,
                        const curves::Cubic& cubic) const {
    const Landing nearest = landing_on(other, place.parameter, cubic[3]);
    const Vec2 out = cubic[3] - cubic[2];
    const double turn = cross(out, nearest.along);
    if (turn == 0) return nearest;
    const double share = cross(nearest.point - cubic[3], nearest.along) / turn;
    const Vec2 met = cubic[3] + share * out;
    if (!(share > 0) || length(met - cubic[3]) > ahead_) return nearest;
    const Landing ahead = landing_on(other, nearest.parameter, met);
    return length(ahead.point - met) > kCrossed ? nearest : ahead;
  }

  /// The two sides of a curve that ends on another curve differ, so the values of the other curve
  /// get a step there.
  void part_at(std::uint32_t host, const Landing& landing, const curves::Cubic& cubic) {
    const bool is_left =
        dot(left_of(landing.along), curves::point_at(cubic, kNearEnd) - landing.point) > 0;
    TracedCurve& other = curves_[host];
    add_step(other, other.side[is_left ? 0 : 1], landing);
  }

  std::optional<PlaceGrid::Place> target(std::uint32_t index, const curves::Cubic& cubic,
                                         bool is_last) const {
    const TracedCurve& curve = curves_[index];
    const Vec2 end = cubic[3], out = cubic[3] - cubic[2];
    const double reach = std::min(kEndReach * std::sqrt(curve.scale), kMostReach);
    const double whole = length_of(curve), own = kOwnReaches * reach + kOwnPixels;
    std::optional<PlaceGrid::Place> best;
    double least = 0;
    grid_.near(end, ahead_, [&](const PlaceGrid::Place& place) {
      const double along = is_last ? whole - place.from_start : place.from_start;
      if (place.curve == index && along < own) return;
      const Vec2 way = place.point - end;
      const double far = length(way);
      const double cosine = far > 0 ? dot(way, out) / (far * std::max(length(out), 1e-9)) : 1.0;
      if (far > ahead_ || cosine < (far > reach ? kAhead : kLeastCosine)) return;
      const double cost = far * (1.5 - cosine);
      if (best && cost >= least) return;
      best = place;
      least = cost;
    });
    return best;
  }

  const PlaceGrid& grid_;
  double ahead_;  ///< pixels
  float leak_;
  bool lands_ahead_;
  std::vector<TracedCurve>& curves_;
};

}  // namespace

Status snap_to_curves(const Context& context, int width, int height, const SnapOptions& options,
                      std::vector<TracedCurve>& curves) {
  const double ahead = std::max(kAheadPx, kAheadShare * std::max(width, height));
  const auto for_each_end = [&](auto change) {
    PlaceGrid grid(width, height);
    SFUMATO_TRY(grid.create(context));
    for (std::uint32_t i = 0; i < curves.size(); ++i) {
      SFUMATO_TRY(context.cancelled() ? context.cancel_status() : grid.add(context, i, curves[i]));
    }
    Snapper snapper(grid, ahead, options, curves);
    for (std::uint32_t i = 0; i < curves.size(); ++i) {
      if (context.cancelled()) return context.cancel_status();
      for (const bool is_last : {false, true}) {
        if (!is_closed(curves[i])) change(snapper, i, is_last);
      }
    }
    return ok_status();
  };
  const auto trim = [](Snapper& snapper, std::uint32_t i, bool is_last) {
    snapper.trim(i, is_last);
  };
  const auto snap = [](Snapper& snapper, std::uint32_t i, bool is_last) {
    snapper.snap(i, is_last);
  };
  Status status = for_each_end(trim);
  for (TracedCurve& curve : curves) close_if_nearly(curve);
  // The second pass is for ends whose curve moved when another end snapped to it.
  for (int pass = 0; pass < 2 && status; ++pass) status = for_each_end(snap);
  if (status) status = for_each_end(trim);
  for (TracedCurve& curve : curves) close_if_nearly(curve);
  std::erase_if(curves, [](const TracedCurve& curve) { return length_of(curve) < kLeastLength; });
  return status;
}

}  // namespace sfumato::tracing
