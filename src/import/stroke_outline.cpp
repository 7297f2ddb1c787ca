#include "import/stroke_outline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <span>
#include <utility>

#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "curves/bezier.hpp"

namespace sfumato::svg_import {
namespace {

using curves::Cubic;

constexpr int kDeepest = 24;  ///< halvings of one piece: so many only at a cusp, or nearly
constexpr int kBisections = 40;
constexpr const char* kOutlinePurpose = "the outline of a stroke";
/// A share of the tolerance: a shorter piece is dropped. That is 1/256 of a pixel of 1024; cairo
/// ignores shorter pieces too, and Skia pieces below 1/4096.
constexpr double kShortest = 1.0 / 16;
/// A share of the width: a shorter handle turns a cap but bends nothing visibly.
constexpr double kShortestHandle = 1.0 / 128;
/// A share of the largest coordinate: the best accuracy of offsets.
constexpr double kRounding = 64 * std::numeric_limits<double>::epsilon();
constexpr double kStraight = 1e-4;               ///< sine of a turn that needs no join
constexpr double kQuarter = 0.5522847498307936;  ///< control points of a quarter circle

Vec2 second_derivative_at(const Cubic& c, double t) {
  const Vec2 a = c[2] - 2 * c[1] + c[0], b = c[3] - 2 * c[2] + c[1];
  return 6 * lerp(a, b, t);
}

/// Returns whether all of a piece lies nearer to a point than this.
bool is_near(const Cubic& c, Vec2 point, double distance) {
  return std::ranges::all_of(c, [&](Vec2 control) { return length(control - point) <= distance; });
}

/// Copies the pieces of a subpath without invisible pieces and handles: rounding determines their
/// directions, which would make joins and caps. The remaining pieces follow one another. There is
/// room for all.
void add_pieces(const std::vector<Vec2>& subpath, double shortest, double width,
                std::vector<Cubic>& pieces) {
  const double shortest_handle = std::max(shortest, kShortestHandle * width);
  Vec2 end = subpath.front();
  for (std::size_t i = 0; 3 * i + 3 < subpath.size(); ++i) {
    Cubic cubic = curves::piece(subpath, i);
    if (is_near(cubic, end, shortest)) continue;
    cubic[0] = end;
    end = cubic[3];
    if (length(cubic[1] - cubic[0]) <= shortest_handle) cubic[1] = cubic[0];
    if (length(cubic[3] - cubic[2]) <= shortest_handle) cubic[2] = cubic[3];
    pieces.push_back(cubic);
  }
  if (!pieces.empty() && length(subpath.back() - end) <= shortest) {
    pieces.back()[3] = subpath.back();
  }
}

bool is_straight(Vec2 before, Vec2 after) {
  return std::abs(cross(before, after)) < kStraight && dot(before, after) > 0;
}

/// Returns whether the left side of a turning path is the outer one; if it turns back, both sides
/// are.
bool is_outer(Vec2 before, Vec2 after) {
  const double turn = cross(before, after);
  return turn > 0 || (std::abs(turn) < kStraight && dot(before, after) < 0);
}

/// One side of a stroke: at distance `radius` to the left of the path.
///
/// If the path bends to the left more sharply than that, the side runs back and encloses the area
/// between itself and the centres of the bend in the wrong direction: a fold. The side then follows
/// the centres, and the fold becomes a separate contour in the right direction, so that nothing
/// swept by the normals of the path is subtracted from the rest.
class Side {
 public:
  /// folds    where the contours of folds are added
  /// memory   of these, and of the points
  Side(const svg::StrokeStyle& style, double tolerance, PointMeter& meter, Contours& folds,
       TableMemory& memory)
      : radius_(style.width / 2),
        style_(style),
        tolerance_(tolerance),
        meter_(meter),
        folds_(folds),
        memory_(memory) {}

  /// Must be called first. If the meter has failed then, there may be no points.
  void walk(const std::vector<Cubic>& pieces, bool is_closed);
  /// Draws from the left side of the end of `piece` round to its right side.
  void cap(const Cubic& piece);
  std::vector<Vec2> take() { return std::move(points_); }

 private:
  Vec2 normal(Vec2 tangent) const { return radius_ * left_of(tangent); }
  bool make_room(std::vector<Vec2>& points, std::size_t more) {
    return meter_.keep(memory_.make_room(meter_.context(), points, more));
  }
  void add_center(Vec2 center);
  void line_to(Vec2 point);
  void quarter_to(Vec2 control1, Vec2 control2, Vec2 point);
  Vec2 offset_point(const Cubic& piece, double t) const {
    return curves::point_at(piece, t) + normal(tangent_at(piece, t));
  }
  Vec2 offset_derivative(const Cubic& piece, double t) const;
  Cubic fitted(const Cubic& piece, double t0, double t1) const;
  double error_of(const Cubic& fit, const Cubic& piece, double t0, double t1) const;
  bool runs_back(const Cubic& piece, double t) const {
    return dot(offset_derivative(piece, t), tangent_at(piece, t)) < 0;
  }
  bool turns_twice(const Cubic& piece, double t0, double t1) const;
  void offset(const Cubic& piece, double t0, double t1, int depth);
  void part(const Cubic& piece, double t0, double t1);
  void sweep(const Cubic& piece, double t0, double t1);
  Vec2 center_of_bend(const Cubic& piece, double t0, double t1) const;
  double neck(Vec2 center, const Cubic& piece, double t0, double t1) const;
  void begin_fold();
  void fold(const Cubic& piece, double t0, double t1, int depth);
  void end_fold();
  void join(Vec2 corner, Vec2 before, Vec2 after);
  void arc(Vec2 center, Vec2 from, Vec2 to);

  double radius_;
  const svg::StrokeStyle& style_;
  double tolerance_;
  PointMeter& meter_;
  Contours& folds_;
  TableMemory& memory_;
  TableMemory center_memory_{kOutlinePurpose};
  std::vector<Vec2> points_;
  std::vector<Vec2> centers_;   ///< of the parts of a fold that has begun
  std::size_t fold_begin_ = 0;  ///< where it begins in points_
};

void Side::line_to(Vec2 point) {
  const Vec2 from = points_.back();
  if (from == point || !meter_.take(3) || !make_room(points_, 3)) return;
  points_.insert(points_.end(), {lerp(from, point, 1.0 / 3), lerp(from, point, 2.0 / 3), point});
}

void Side::quarter_to(Vec2 control1, Vec2 control2, Vec2 point) {
  if (!meter_.take(3) || !make_room(points_, 3)) return;
  points_.insert(points_.end(), {control1, control2, point});
}

/// C′ (1 + radius κ), below 0 along C′ where the offset runs back.
Vec2 Side::offset_derivative(const Cubic& piece, double t) const {
  const Vec2 along = curves::derivative_at(piece, t);
  const double speed = length(along);
  if (!(speed > 0)) return Vec2{};
  const double curvature = cross(along, second_derivative_at(piece, t)) / (speed * speed * speed);
  return along * (1 + radius_ * curvature);
}

/// A cubic with the offset's points and derivatives at both ends misses the offset by O(length⁴).
Cubic Side::fitted(const Cubic& piece, double t0, double t1) const {
  const Vec2 from = offset_point(piece, t0), to = offset_point(piece, t1);
  return {from, from + offset_derivative(piece, t0) * ((t1 - t0) / 3),
          to - offset_derivative(piece, t1) * ((t1 - t0) / 3), to};
}

double Side::error_of(const Cubic& fit, const Cubic& piece, double t0, double t1) const {
  double error = 0;
  for (const double share : {0.25, 0.5, 0.75}) {
    const Vec2 miss = curves::point_at(fit, share) - offset_point(piece, t0 + (t1 - t0) * share);
    error = std::max(error, length(miss));
  }
  return error;
}

/// Returns whether the offset turns round and round again between the ends.
bool Side::turns_twice(const Cubic& piece, double t0, double t1) const {
  const bool back = runs_back(piece, t0);
  return back == runs_back(piece, t1) && (runs_back(piece, t0 + (t1 - t0) * 0.25) != back ||
                                          runs_back(piece, t0 + (t1 - t0) * 0.5) != back ||
                                          runs_back(piece, t0 + (t1 - t0) * 0.75) != back);
}

void Side::offset(const Cubic& piece, double t0, double t1, int depth) {
  if (meter_.failed()) return;
  const bool fits = error_of(fitted(piece, t0, t1), piece, t0, t1) <= tolerance_;
  if ((!fits || turns_twice(piece, t0, t1)) && depth < kDeepest) {
    const double middle = (t0 + t1) / 2;
    offset(piece, t0, middle, depth + 1);
    offset(piece, middle, t1, depth + 1);
    return;
  }
  if (!fits) return sweep(piece, t0, t1);
  const bool begins_back = runs_back(piece, t0);
  if (begins_back == runs_back(piece, t1)) return part(piece, t0, t1);
  double low = t0, high = t1;
  for (int i = 0; i < kBisections; ++i) {
    const double middle = (low + high) / 2;
    (runs_back(piece, middle) == begins_back ? low : high) = middle;
  }
  part(piece, t0, high);
  part(piece, high, t1);
}

/// Appends a part of the offset that runs entirely forwards or entirely back.
void Side::part(const Cubic& piece, double t0, double t1) {
  const Cubic fit = fitted(piece, t0, t1);
  line_to(fit[0]);
  const double middle = (t0 + t1) / 2;
  // A hairpin also ends where it began, but it runs on.
  if (runs_back(piece, middle) && dot(fit[3] - fit[0], tangent_at(piece, middle)) < 0) {
    begin_fold();
    fold(piece, t0, t1, 0);
  } else {
    end_fold();
  }
  quarter_to(fit[1], fit[2], fit[3]);
}

/// Returns the crossing of the normals at both ends of a part, so that the parts of a fold share
/// their normals.
Vec2 Side::center_of_bend(const Cubic& piece, double t0, double t1) const {
  const Vec2 from = curves::point_at(piece, t0), to = curves::point_at(piece, t1);
  const Vec2 before = left_of(tangent_at(piece, t0)), after = left_of(tangent_at(piece, t1));
  const double sine = cross(before, after);
  const double away = sine != 0 ? cross(to - from, after) / sine : radius_;
  return from + before * std::clamp(away, 0.0, radius_);
}

/// Returns the distance at which the normals between pass the centre. It is the width of the area
/// that neither the side nor the fold covers.
double Side::neck(Vec2 center, const Cubic& piece, double t0, double t1) const {
  double widest = 0;
  for (const double share : {0.25, 0.5, 0.75}) {
    const double t = t0 + (t1 - t0) * share;
    const Vec2 along = tangent_at(piece, t);
    widest = std::max(widest, std::abs(dot(center - curves::point_at(piece, t), along)));
  }
  return widest;
}

/// The part of the offset that begins here runs back.
void Side::begin_fold() {
  if (centers_.empty()) fold_begin_ = points_.size() - 1;
}

void Side::fold(const Cubic& piece, double t0, double t1, int depth) {
  if (meter_.failed()) return;
  const Vec2 center = center_of_bend(piece, t0, t1);
  if (neck(center, piece, t0, t1) > tolerance_ / 2 && depth < kDeepest) {
    const double middle = (t0 + t1) / 2;
    fold(piece, t0, middle, depth + 1);
    fold(piece, middle, t1, depth + 1);
  } else if (meter_.take(3)) {
    add_center(center);
  }
}

void Side::add_center(Vec2 center) {
  meter_.keep(center_memory_.push_back(meter_.context(), centers_, center));
}

void Side::end_fold() {
  if (centers_.empty()) return;
  const auto begin = static_cast<std::ptrdiff_t>(fold_begin_);
  std::vector<Vec2> contour;
  if (!make_room(contour, points_.size() - fold_begin_)) return;
  contour.assign(points_.begin() + begin, points_.end());
  std::ranges::reverse(contour);
  points_.resize(fold_begin_ + 1);
  for (const Vec2 center : centers_) line_to(center);
  line_to(contour.front());
  if (!make_room(contour, points_.size() - fold_begin_ - 1)) return;
  contour.insert(contour.end(), points_.begin() + begin + 1, points_.end());
  meter_.keep(memory_.push_back(meter_.context(), folds_, std::move(contour)));
  centers_.clear();
}

/// If a curve turns abruptly, in a cusp or nearly, its side is an arc, as next to a cusp.
void Side::sweep(const Cubic& piece, double t0, double t1) {
  const Vec2 before = tangent_at(piece, t0), after = tangent_at(piece, t1);
  const Vec2 center = curves::point_at(piece, t1);
  const Vec2 from = center + normal(before), to = center + normal(after);
  line_to(offset_point(piece, t0));
  if (is_outer(before, after)) {
    end_fold();
    line_to(from);
    arc(center, from, to);
    return line_to(to);
  }
  begin_fold();
  add_center(center);
  line_to(from);
  const auto begin = static_cast<std::ptrdiff_t>(points_.size()) - 1;
  points_.back() = to;
  arc(center, to, from);
  std::reverse(points_.begin() + begin, points_.end());
}

/// Around `center`, clockwise on the screen, in steps of at most a quarter.
void Side::arc(Vec2 center, Vec2 from, Vec2 to) {
  Vec2 radius = from - center;
  const Vec2 last = to - center;
  for (int i = 0; i < 4; ++i) {
    const Vec2 ahead{-radius.y, radius.x};
    const double slack = -1e-9 * length_squared(last);
    const bool is_last = dot(ahead, last) >= slack && dot(radius, last) >= slack;
    if (!is_last) {
      quarter_to(center + radius + kQuarter * ahead, center + ahead + kQuarter * radius,
                 center + ahead);
      radius = ahead;
      continue;
    }
    const double square = length_squared(radius);
    const double cosine = std::min(dot(radius, last) / square, 1.0);
    const double half = std::sqrt((1 - cosine) / (1 + cosine));  // tan of half the angle
    if (half > 0) {
      // 4/3 tan of a quarter of the angle, from tan of its half.
      const double k = 4.0 / 3 * half / (1 + std::sqrt(1 + half * half));
      const Vec2 back{last.y, -last.x};
      quarter_to(center + radius + k * ahead, to + k * back, to);
    }
    return;
  }
}

void Side::join(Vec2 corner, Vec2 before, Vec2 after) {
  const double straightness = dot(before, after);
  const Vec2 to = corner + normal(after);
  if (is_straight(before, after)) return line_to(to);
  if (!is_outer(before, after)) {
    line_to(corner);
    return line_to(to);
  }
  if (style_.join == svg::StrokeJoin::round) return arc(corner, points_.back(), to);
  // The miter's length over the width is 1 / sin(half the inner angle), and that squared is:
  const double ratio_squared = 2 / std::max(1 + straightness, 1e-12);
  if (style_.join == svg::StrokeJoin::miter &&
      ratio_squared <= style_.miter_limit * style_.miter_limit) {
    line_to(corner + (normal(before) + normal(after)) / (1 + straightness));
  }
  line_to(to);
}

void Side::walk(const std::vector<Cubic>& pieces, bool is_closed) {
  if (!make_room(points_, 1)) return;
  points_.push_back(pieces.front()[0] + normal(tangent_at(pieces.front(), 0)));
  for (std::size_t i = 0; i < pieces.size() && !meter_.failed(); ++i) {
    if (i > 0) join(pieces[i][0], tangent_at(pieces[i - 1], 1), tangent_at(pieces[i], 0));
    offset(pieces[i], 0, 1, 0);
    end_fold();
  }
  if (!is_closed) return;
  join(pieces.front()[0], tangent_at(pieces.back(), 1), tangent_at(pieces.front(), 0));
  line_to(points_.front());
}

void Side::cap(const Cubic& piece) {
  const Vec2 end = piece[3], tangent = tangent_at(piece, 1), side = normal(tangent);
  if (style_.cap == svg::StrokeCap::round) return arc(end, points_.back(), end - side);
  if (style_.cap == svg::StrokeCap::square) {
    line_to(end + side + radius_ * tangent);
    line_to(end - side + radius_ * tangent);
  }
  line_to(end - side);
}

/// There is room for them.
void turn_round(std::vector<Cubic>& pieces) {
  std::ranges::reverse(pieces);
  for (Cubic& cubic : pieces) std::ranges::reverse(cubic);
}

/// `rest`, the other side, begins where the cap of `contour` ends.
Status append_side(Context& context, std::vector<Vec2>& contour, std::vector<Vec2>& rest,
                   TableMemory& memory) {
  contour.back() = rest.front();
  Status status = memory.append(context, std::span(rest).subspan(1), contour);
  memory.free(rest);
  contour.back() = contour.front();
  return status;
}

void outline(PointMeter& meter, const std::vector<Vec2>& subpath, bool may_close,
             const svg::StrokeStyle& style, double tolerance, Contours& contours,
             TableMemory& memory) {
  if (!meter.take(2 * subpath.size())) return;  // the pieces, there and back
  TableMemory working(kOutlinePurpose);
  std::vector<Cubic> pieces;
  const std::size_t most = std::max<std::size_t>(subpath.size() / 3, 1);
  if (!meter.keep(working.reserve(meter.context(), pieces, most))) return;
  add_pieces(subpath, kShortest * tolerance, style.width, pieces);
  if (pieces.empty()) {  // a dot, where caps make one
    if (style.cap == svg::StrokeCap::butt) return;
    const Vec2 along = subpath.back() - subpath.front();
    const double size = length(along);
    const Vec2 direction = size > 0 ? along / size : Vec2{1, 0};
    pieces.push_back(curves::piece(dot(subpath.front(), direction, style), 0));
  }
  const bool is_closed = may_close && pieces.front()[0] == pieces.back()[3];
  Side side(style, tolerance, meter, contours, memory);
  side.walk(pieces, is_closed);
  if (meter.failed()) return;
  if (!is_closed) side.cap(pieces.back());
  if (is_closed && !meter.keep(memory.push_back(meter.context(), contours, side.take()))) return;
  turn_round(pieces);
  Side other(style, tolerance, meter, contours, memory);
  other.walk(pieces, is_closed);
  if (meter.failed()) return;
  if (!is_closed) other.cap(pieces.back());
  std::vector<Vec2> contour = is_closed ? other.take() : side.take();
  if (!is_closed) {
    std::vector<Vec2> rest = other.take();
    meter.keep(append_side(meter.context(), contour, rest, memory));
  }
  meter.keep(memory.push_back(meter.context(), contours, std::move(contour)));
}

/// Returns the largest coordinate of a stroke, or nearly.
double reach(const Contours& subpaths, const svg::StrokeStyle& style) {
  double largest = style.width;
  for (const std::vector<Vec2>& subpath : subpaths) {
    for (const Vec2 p : subpath) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  }
  return largest;
}

}  // namespace

Vec2 tangent_at(const curves::Cubic& c, double t) {
  const double scale = length(c[1] - c[0]) + length(c[2] - c[1]) + length(c[3] - c[2]);
  Vec2 along = curves::derivative_at(c, t);
  const auto vanishes = [&] { return length(along) <= 1e-9 * scale; };
  if (vanishes() && t > 0 && t < 1) {
    constexpr double kStep = 1e-3;
    along = curves::point_at(c, std::min(t + kStep, 1.0)) -
            curves::point_at(c, std::max(t - kStep, 0.0));
  }
  if (vanishes()) along = t < 0.5 ? c[2] - c[0] : c[3] - c[1];
  if (vanishes()) along = c[3] - c[0];
  const double size = length(along);
  return size > 0 ? along / size : Vec2{1, 0};
}

std::vector<Vec2> dot(Vec2 point, Vec2 direction, const svg::StrokeStyle& style) {
  const Vec2 end = point + style.width * 1e-6 * direction;
  return {point, lerp(point, end, 1.0 / 3), lerp(point, end, 2.0 / 3), end};
}

Result<Contours> stroke_outline(Context& context, const Contours& subpaths,
                                const svg::StrokeStyle& style, double tolerance,
                                TableMemory* memory) {
  TableMemory own(kOutlinePurpose), dash_memory(kOutlinePurpose);
  PointMeter meter(context);
  Dashes dashes;
  if (!style.dashes.empty()) {
    SFUMATO_TRY_ASSIGN(dashes, dashed(meter, subpaths, style, dash_memory));
  }
  tolerance = std::max(tolerance, kRounding * reach(subpaths, style));
  Contours contours;
  std::set<std::pair<double, double>> dots;
  const bool is_dashed = !style.dashes.empty();
  const Contours& stroked = is_dashed ? dashes.chains : subpaths;
  for (std::uint32_t i = 0; i < stroked.size(); ++i) {
    if (context.cancelled()) return context.cancel_status();
    const std::vector<Vec2>& subpath = stroked[i];
    const bool may_close = is_dashed ? dashes.is_open[i] == 0 : style.is_closed(i, subpath);
    const Vec2 first = subpath.front();
    const bool is_dot = std::ranges::all_of(subpath, [&](Vec2 p) { return p == first; });
    if (is_dot && !dots.emplace(first.x, first.y).second) continue;  // there is one here
    outline(meter, subpath, may_close, style, tolerance, contours, memory ? *memory : own);
    if (meter.failed()) return meter.status();
  }
  std::erase_if(contours, [](const auto& contour) { return contour.size() < 4; });
  return contours;
}

}  // namespace sfumato::svg_import
