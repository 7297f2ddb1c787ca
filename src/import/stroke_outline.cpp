#include "import/stroke_outline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "curves/bezier.hpp"

namespace sfumato::svg_import {
namespace {

using curves::Cubic;

constexpr int kDeepest = 7;       ///< halvings of one piece
constexpr int kDeepestTurn = 24;  ///< where it turns back, in a cusp or nearly
/// Of the tolerance: what is shorter is no piece. That is 1/256 of a pixel of 1024, below which
/// cairo sees nothing either, and Skia nothing below 1/4096.
constexpr double kShortest = 1.0 / 16;
/// Of the largest coordinate: no offset is found more exactly.
constexpr double kRounding = 64 * std::numeric_limits<double>::epsilon();
constexpr double kStraight = 1e-4;               ///< sine of a turn that needs no join
constexpr double kQuarter = 0.5522847498307936;  ///< control points of a quarter circle

Vec2 second_derivative_at(const Cubic& c, double t) {
  const Vec2 a = c[2] - 2 * c[1] + c[0], b = c[3] - 2 * c[2] + c[1];
  return 6 * lerp(a, b, t);
}

/// Whether all of a piece lies nearer to a point than this.
bool is_near(const Cubic& c, Vec2 point, double distance) {
  return std::ranges::all_of(c, [&](Vec2 control) { return length(control - point) <= distance; });
}

/// The pieces of a subpath, without pieces and handles that nobody sees: their directions are of
/// rounding's making, and would make joins and caps. What is left follows one another.
std::vector<Cubic> pieces_of(const std::vector<Vec2>& subpath, double shortest) {
  std::vector<Cubic> pieces;
  Vec2 end = subpath.front();
  for (std::size_t i = 0; 3 * i + 3 < subpath.size(); ++i) {
    Cubic cubic = curves::piece(subpath, i);
    if (is_near(cubic, end, shortest)) continue;
    cubic[0] = end;
    end = cubic[3];
    if (length(cubic[1] - cubic[0]) <= shortest) cubic[1] = cubic[0];
    if (length(cubic[3] - cubic[2]) <= shortest) cubic[2] = cubic[3];
    pieces.push_back(cubic);
  }
  if (!pieces.empty() && length(subpath.back() - end) <= shortest) {
    pieces.back()[3] = subpath.back();
  }
  return pieces;
}

bool is_straight(Vec2 before, Vec2 after) {
  return std::abs(cross(before, after)) < kStraight && dot(before, after) > 0;
}

/// Whether the left side of a way that turns is the outer one; where it turns back both are.
bool is_outer(Vec2 before, Vec2 after) {
  const double turn = cross(before, after);
  return turn > 0 || (std::abs(turn) < kStraight && dot(before, after) < 0);
}

/// One side of a stroke: at `radius` to the left of what is walked.
class Side {
 public:
  Side(const StrokeStyle& style, double tolerance, PointMeter& meter)
      : radius_(style.width / 2), style_(style), tolerance_(tolerance), meter_(meter) {}

  void walk(const std::vector<Cubic>& pieces, bool is_closed);
  /// From the left side of the end of `piece` round to its right side.
  void cap(const Cubic& piece);
  std::vector<Vec2> take() { return std::move(points_); }

 private:
  Vec2 normal(Vec2 tangent) const { return radius_ * left_of(tangent); }
  void line_to(Vec2 point);
  void quarter_to(Vec2 control1, Vec2 control2, Vec2 point);
  void offset(const Cubic& piece, double t0, double t1, int depth);
  void sweep(Vec2 center, Vec2 before, Vec2 after);
  void join(Vec2 corner, Vec2 before, Vec2 after);
  void arc(Vec2 center, Vec2 from, Vec2 to);

  double radius_;
  const StrokeStyle& style_;
  double tolerance_;
  PointMeter& meter_;
  std::vector<Vec2> points_;
};

void Side::line_to(Vec2 point) {
  const Vec2 from = points_.back();
  if (from == point || !meter_.take(3)) return;
  points_.insert(points_.end(), {lerp(from, point, 1.0 / 3), lerp(from, point, 2.0 / 3), point});
}

void Side::quarter_to(Vec2 control1, Vec2 control2, Vec2 point) {
  if (!meter_.take(3)) return;
  points_.insert(points_.end(), {control1, control2, point});
}

/// The offset curve's derivative is C′ (1 + radius κ): a cubic with its points and derivatives at
/// both ends misses it by O(length⁴).
void Side::offset(const Cubic& piece, double t0, double t1, int depth) {
  if (meter_.stopped()) return;
  const auto derivative = [&](double t) {
    const Vec2 along = curves::derivative_at(piece, t);
    const double speed = length(along);
    if (!(speed > 0)) return Vec2{};
    const double curvature = cross(along, second_derivative_at(piece, t)) / (speed * speed * speed);
    return along * (1 + radius_ * curvature);
  };
  const auto point = [&](double t) {
    return curves::point_at(piece, t) + normal(tangent_at(piece, t));
  };
  const Vec2 from = point(t0), to = point(t1);
  const Cubic fitted{from, from + derivative(t0) * ((t1 - t0) / 3),
                     to - derivative(t1) * ((t1 - t0) / 3), to};
  double error = 0;
  for (const double share : {0.25, 0.5, 0.75}) {
    error =
        std::max(error, length(curves::point_at(fitted, share) - point(t0 + (t1 - t0) * share)));
  }
  const bool turns_back = dot(tangent_at(piece, t0), tangent_at(piece, t1)) < 0;
  if (!(error <= tolerance_) && depth < (turns_back ? kDeepestTurn : kDeepest)) {
    const double middle = (t0 + t1) / 2;
    offset(piece, t0, middle, depth + 1);
    offset(piece, middle, t1, depth + 1);
    return;
  }
  line_to(from);
  if (error <= tolerance_) {
    quarter_to(fitted[1], fitted[2], to);
  } else {
    sweep(curves::point_at(piece, t1), tangent_at(piece, t0), tangent_at(piece, t1));
  }
}

/// Where a curve turns at once, in a cusp or nearly, its side is an arc, as next to a cusp.
void Side::sweep(Vec2 center, Vec2 before, Vec2 after) {
  const Vec2 to = center + normal(after);
  if (is_outer(before, after)) {
    line_to(center + normal(before));
    arc(center, points_.back(), to);
  }
  line_to(to);
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
  if (style_.join == StrokeJoin::round) return arc(corner, points_.back(), to);
  // The miter's length over the width is 1 / sin(half the inner angle), and that squared is:
  const double ratio_squared = 2 / std::max(1 + straightness, 1e-12);
  if (style_.join == StrokeJoin::miter &&
      ratio_squared <= style_.miter_limit * style_.miter_limit) {
    line_to(corner + (normal(before) + normal(after)) / (1 + straightness));
  }
  line_to(to);
}

void Side::walk(const std::vector<Cubic>& pieces, bool is_closed) {
  points_ = {pieces.front()[0] + normal(tangent_at(pieces.front(), 0))};
  for (std::size_t i = 0; i < pieces.size() && !meter_.stopped(); ++i) {
    if (i > 0) join(pieces[i][0], tangent_at(pieces[i - 1], 1), tangent_at(pieces[i], 0));
    offset(pieces[i], 0, 1, 0);
  }
  if (!is_closed) return;
  join(pieces.front()[0], tangent_at(pieces.back(), 1), tangent_at(pieces.front(), 0));
  line_to(points_.front());
}

void Side::cap(const Cubic& piece) {
  const Vec2 end = piece[3], tangent = tangent_at(piece, 1), side = normal(tangent);
  if (style_.cap == StrokeCap::round) return arc(end, points_.back(), end - side);
  if (style_.cap == StrokeCap::square) {
    line_to(end + side + radius_ * tangent);
    line_to(end - side + radius_ * tangent);
  }
  line_to(end - side);
}

std::vector<Cubic> reversed(const std::vector<Cubic>& pieces) {
  std::vector<Cubic> result(pieces.rbegin(), pieces.rend());
  for (Cubic& cubic : result) std::ranges::reverse(cubic);
  return result;
}

void outline(PointMeter& meter, const std::vector<Vec2>& subpath, const StrokeStyle& style,
             double tolerance, Contours& contours) {
  if (!meter.take(2 * subpath.size())) return;  // the pieces, there and back
  std::vector<Cubic> pieces = pieces_of(subpath, kShortest * tolerance);
  if (pieces.empty()) {  // a dot, where caps make one
    if (style.cap == StrokeCap::butt) return;
    const Vec2 along = subpath.back() - subpath.front();
    const double size = length(along);
    const Vec2 direction = size > 0 ? along / size : Vec2{1, 0};
    pieces.push_back(curves::piece(dot(subpath.front(), direction, style), 0));
  }
  const bool is_closed = pieces.front()[0] == pieces.back()[3];
  const std::vector<Cubic> back = reversed(pieces);
  Side side(style, tolerance, meter);
  side.walk(pieces, is_closed);
  if (is_closed) {
    contours.push_back(side.take());
    Side other(style, tolerance, meter);
    other.walk(back, true);
    contours.push_back(other.take());
    return;
  }
  side.cap(pieces.back());
  Side other(style, tolerance, meter);
  other.walk(back, false);
  other.cap(back.back());
  std::vector<Vec2> contour = side.take(), rest = other.take();
  // The cap ends where the other side begins.
  contour.back() = rest.front();
  contour.insert(contour.end(), rest.begin() + 1, rest.end());
  contour.back() = contour.front();
  contours.push_back(std::move(contour));
}

/// The largest coordinate of a stroke, or nearly.
double reach(const Contours& subpaths, const StrokeStyle& style) {
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

std::vector<Vec2> dot(Vec2 point, Vec2 direction, const StrokeStyle& style) {
  const Vec2 end = point + style.width * 1e-6 * direction;
  return {point, lerp(point, end, 1.0 / 3), lerp(point, end, 2.0 / 3), end};
}

Result<Contours> stroke_outline(Context& context, const Contours& subpaths,
                                const StrokeStyle& style, double tolerance, ScopedCharge* charge) {
  ScopedCharge own_charge;
  PointMeter meter(context, charge ? *charge : own_charge);
  Result<Contours> dashes = style.dashes.empty() ? subpaths : dashed(meter, subpaths, style);
  if (!dashes) return dashes.status();
  tolerance = std::max(tolerance, kRounding * reach(subpaths, style));
  Contours contours;
  std::set<std::pair<double, double>> dots;
  for (const std::vector<Vec2>& subpath : *dashes) {
    if (context.cancelled()) return context.stop_status();
    const Vec2 first = subpath.front();
    const bool is_dot = std::ranges::all_of(subpath, [&](Vec2 p) { return p == first; });
    if (is_dot && !dots.emplace(first.x, first.y).second) continue;  // there is one here
    outline(meter, subpath, style, tolerance, contours);
    if (meter.stopped()) return meter.status();
  }
  std::erase_if(contours, [](const auto& contour) { return contour.size() < 4; });
  return contours;
}

}  // namespace sfumato::svg_import
