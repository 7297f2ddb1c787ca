#include "formats/svg/shapes/path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/angle.hpp"
#include "base/poll.hpp"

namespace sfumato::svg {
namespace {

/// Closing lines shorter than this share of the coordinates come from rounding.
constexpr double kClosingShare = 1e-12;

/// The accuracy of the sine or cosine of an arc's angle.
constexpr double kTurnSlack = 1e-12;

/// How far an arc's pieces stray from it, in radii, at most: no scale shows it, for pictures are
/// solved in single precision. A quarter turn takes four pieces.
constexpr double kArcError = 1e-7;

/// Parameters in (0, 1) where one coordinate of a cubic stands still.
void extend_by_extrema(const std::array<Vec2, 4>& p, double p0, double p1, double p2, double p3,
                       Box& box) {
  const double a = p3 - 3 * p2 + 3 * p1 - p0;
  const double half_b = p2 - 2 * p1 + p0;
  const double c = p1 - p0;
  const double discriminant = half_b * half_b - a * c;
  if (discriminant < 0) return;
  const double q = -(half_b + std::copysign(std::sqrt(discriminant), half_b));
  for (const double t : {a != 0 ? q / a : 2, q != 0 ? c / q : 2}) {
    if (!(t > 0 && t < 1)) continue;
    const double s = 1 - t;
    box.extend(s * s * s * p[0] + 3 * s * s * t * p[1] + 3 * s * t * t * p[2] + t * t * t * p[3]);
  }
}

/// An arc of the unit circle: unit vectors to its ends, the shorter way or the longer.
struct UnitArc {
  Vec2 from;
  Vec2 to;
};

Vec2 normalized(Vec2 v) {
  return v / length(v);
}

/// Returns a quarter turn, clockwise on the screen where `sweep`.
Vec2 quarter_turn(Vec2 v, bool sweep) {
  return sweep ? Vec2{-v.y, v.x} : Vec2{v.y, -v.x};
}

/// Returns the unit vectors between which the arc runs in equal parts of at most a quarter turn.
std::vector<Vec2> quarters_of(const UnitArc& arc, bool sweep) {
  const double turn = sweep ? cross(arc.from, arc.to) : -cross(arc.from, arc.to);
  const double cosine = dot(arc.from, arc.to);
  // Exact quarter and half turns are common: rounding must not give them a piece more.
  if (turn > 0 && cosine >= -kTurnSlack) return {arc.from, arc.to};
  const Vec2 chord_middle = arc.from + arc.to;
  // Towards the middle of the half turn that the arc is nearest to: well defined near 180 degrees.
  const Vec2 middle = turn > 0 ? normalized(chord_middle + quarter_turn(arc.to - arc.from, !sweep))
                               : normalized(quarter_turn(arc.to - arc.from, !sweep) - chord_middle);
  if (turn >= (cosine < 0 ? -kTurnSlack : 0)) return {arc.from, middle, arc.to};
  return {arc.from, normalized(arc.from + middle), middle, normalized(middle + arc.to), arc.to};
}

/// 4/3 of the tangent of a quarter of the angle between two unit vectors: the length of the handles
/// of a cubic that follows their arc.
double handle_length(Vec2 from, Vec2 to) {
  const double half_tangent = std::abs(cross(from, to)) / (1 + dot(from, to));
  return 4.0 / 3 * half_tangent / (1 + std::sqrt(1 + half_tangent * half_tangent));
}

/// How far that cubic strays from the arc, in radii: 2/27 sin⁶ of a quarter of the angle over its
/// cosine's square.
double arc_error(double handle) {
  const double tangent = 0.75 * handle, square = tangent * tangent;
  const double sine_squared = square / (1 + square);
  return 2.0 / 27 * sine_squared * sine_squared * square;
}

/// The quarters, halved until cubics follow them. Only square roots: the same bits everywhere.
std::vector<Vec2> split_arc(const UnitArc& arc, bool sweep) {
  std::vector<Vec2> stations = quarters_of(arc, sweep);
  while (arc_error(handle_length(stations[0], stations[1])) > kArcError) {
    std::vector<Vec2> halved{stations[0]};
    for (std::size_t i = 1; i < stations.size(); ++i) {
      halved.push_back(normalized(stations[i - 1] + stations[i]));
      halved.push_back(stations[i]);
    }
    stations = std::move(halved);
  }
  return stations;
}

}  // namespace

template <class Table>
bool PathBuilder::make_room(Table& table, std::size_t more) {
  if (more <= table.capacity() - table.size()) return status_.ok();
  if (status_) status_ = memory_.make_room(context_, table, more);
  return status_.ok();
}

void PathBuilder::move_to(Vec2 point) {
  finish_subpath();
  current_ = begin_ = point;
  is_moved_ = true;
}

void PathBuilder::begin_segment() {
  is_moved_ = false;
  // Reserves memory for a first piece or one more, and for the beginning and end of its subpath.
  const std::size_t points = open_.control_points.empty() ? 4 : 3;
  if (!make_room(open_.control_points, points) || !make_room(open_.segment_begin, 2)) return;
  if (open_.control_points.empty()) {
    open_.control_points.push_back(current_);
    ++control_point_count_;
  }
  open_.segment_begin.push_back(static_cast<std::uint32_t>(open_.control_points.size() / 3));
}

void PathBuilder::add_piece(Vec2 control1, Vec2 control2, Vec2 point) {
  current_ = point;
  if (!make_room(open_.control_points, 3)) return;
  open_.control_points.insert(open_.control_points.end(), {control1, control2, point});
  control_point_count_ += 3;
}

void PathBuilder::line_to(Vec2 point) {
  begin_segment();
  add_piece(lerp(current_, point, 1.0 / 3), lerp(point, current_, 1.0 / 3), point);
}

void PathBuilder::quadratic_to(Vec2 control, Vec2 point) {
  begin_segment();
  add_piece(lerp(current_, control, 2.0 / 3), lerp(point, control, 2.0 / 3), point);
}

void PathBuilder::cubic_to(Vec2 control1, Vec2 control2, Vec2 point) {
  begin_segment();
  add_piece(control1, control2, point);
}

void PathBuilder::arc_to(Vec2 radii, double rotation_degrees, bool large, bool sweep, Vec2 point) {
  radii = {std::abs(radii.x), std::abs(radii.y)};
  if (point == current_ || radii.x == 0 || radii.y == 0) return line_to(point);
  // The frame where the ellipse is the unit circle.
  const SinCos turn = sin_cos_degrees(rotation_degrees);
  Affine user_from_unit{
      turn.cos * radii.x, turn.sin * radii.x, -turn.sin * radii.y, turn.cos * radii.y, 0, 0};
  const Vec2 half_user = 0.5 * (current_ - point);
  Vec2 half{(turn.cos * half_user.x + turn.sin * half_user.y) / radii.x,
            (turn.cos * half_user.y - turn.sin * half_user.x) / radii.y};
  const double too_far = length(half);
  if (too_far > 1) {  // no such ellipse: the smallest similar one that reaches (F.6.6)
    user_from_unit = user_from_unit * Affine{too_far, 0, 0, too_far, 0, 0};
    half = half / too_far;
  }
  const double distance = std::sqrt(std::max(0.0, 1 - length_squared(half)));
  const Vec2 along = normalized(half);
  const Vec2 center = distance * quarter_turn(along, large == sweep);
  const UnitArc arc{half - center, -1.0 * half - center};
  std::vector<Vec2> stations = split_arc({normalized(arc.from), normalized(arc.to)}, sweep);
  const double handle = handle_length(stations[0], stations[1]);
  const Vec2 middle_user = 0.5 * (current_ + point);
  const auto to_user = [&](Vec2 unit) { return middle_user + user_from_unit(unit + center); };
  begin_segment();
  for (std::size_t i = 1; i < stations.size(); ++i) {
    const Vec2 from = stations[i - 1], to = stations[i];
    const bool last = i + 1 == stations.size();
    add_piece(to_user(from + handle * quarter_turn(from, sweep)),
              to_user(to - handle * quarter_turn(to, sweep)), last ? point : to_user(to));
  }
}

void PathBuilder::close() {
  const bool is_dot = is_moved_;
  if (is_dot) line_to(begin_);
  if (!open_.control_points.empty()) {
    const double extent = std::max(
        {std::abs(begin_.x), std::abs(begin_.y), std::abs(current_.x), std::abs(current_.y)});
    if (length(current_ - begin_) > kClosingShare * extent) {
      line_to(begin_);
    } else {
      open_.control_points.back() = begin_;
      open_.closes_on_itself = !is_dot;
    }
    open_.is_closed = true;
  }
  finish_subpath();
  current_ = begin_;
}

void PathBuilder::finish_subpath() {
  if (open_.control_points.empty() || !make_room(done_, 1)) return;
  open_.segment_begin.push_back(static_cast<std::uint32_t>(open_.control_points.size() / 3));
  open_.index = static_cast<std::uint32_t>(done_.size());
  done_.push_back(std::exchange(open_, {}));
}

Result<std::vector<Subpath>> PathBuilder::take() {
  finish_subpath();
  if (!status_) return status_;
  return std::move(done_);
}

Result<Box> bounds(const Context& context, const std::vector<Subpath>& subpaths) {
  Box box;
  RarePoll<16384> poll(context);
  for (const Subpath& subpath : subpaths) {
    const std::vector<Vec2>& points = subpath.control_points;
    box.extend(points.front());
    for (std::size_t i = 0; i + 3 < points.size(); i += 3) {
      if (poll.cancelled()) return context.cancel_status();
      const std::array<Vec2, 4> p{points[i], points[i + 1], points[i + 2], points[i + 3]};
      box.extend(p[3]);
      extend_by_extrema(p, p[0].x, p[1].x, p[2].x, p[3].x, box);
      extend_by_extrema(p, p[0].y, p[1].y, p[2].y, p[3].y, box);
    }
  }
  return box;
}

}  // namespace sfumato::svg
