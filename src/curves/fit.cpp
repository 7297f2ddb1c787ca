#include "curves/fit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "curves/bezier.hpp"

namespace sfumato::curves {
namespace {

/// Iterations of Newton's method that improve the parameters of points.
constexpr int kReparametrizations = 5;
/// A curve with an error of this many tolerances is split at once.
constexpr double kHopeless = 4;
/// The number of points that determine the direction at an end.
constexpr std::size_t kEndReach = 3;
/// Handles longer than this many chords belong to a curve that overshoots.
constexpr double kLongestHandle = 3;
/// Runs are split at the point with the largest error, and after this many nested splits in their
/// middle: a chain of corners would otherwise lose one point at each split.
constexpr int kDeepest = 24;

using Points = std::span<const Vec2>;

Vec2 unit(Vec2 v) {
  const double norm = length(v);
  return norm > 0 ? v / norm : v;
}

/// Computes fractions of the polyline's length.
void chord_parameters(Points points, std::vector<double>& parameter) {
  parameter.assign(points.size(), 0.0);
  for (std::size_t i = 1; i < points.size(); ++i) {
    parameter[i] = parameter[i - 1] + length(points[i] - points[i - 1]);
  }
  const double whole = parameter.back();
  if (whole > 0) {
    for (double& t : parameter) t /= whole;
  }
}

/// The directions at both ends, into the curve.
struct EndDirections {
  Vec2 first, last;
};

/// Returns the least-squares cubic through the points with these directions at its ends.
Cubic least_squares(Points points, const std::vector<double>& parameter, EndDirections direction) {
  const Vec2 from = points.front(), to = points.back();
  double c00 = 0, c01 = 0, c11 = 0, x0 = 0, x1 = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double t = parameter[i], s = 1 - t;
    const double b0 = s * s * s, b1 = 3 * t * s * s, b2 = 3 * t * t * s, b3 = t * t * t;
    const Vec2 a0 = b1 * direction.first, a1 = b2 * direction.last;
    const Vec2 rest = points[i] - ((b0 + b1) * from + (b2 + b3) * to);
    c00 += dot(a0, a0), c01 += dot(a0, a1), c11 += dot(a1, a1);
    x0 += dot(a0, rest), x1 += dot(a1, rest);
  }
  const double chord = length(to - from);
  const double determinant = c00 * c11 - c01 * c01;
  double first = 0, last = 0;
  if (std::fabs(determinant) > 1e-12) {
    first = (x0 * c11 - x1 * c01) / determinant;
    last = (c00 * x1 - c01 * x0) / determinant;
  }
  const auto is_good = [&](double handle) {
    return handle >= 1e-3 * chord && handle <= kLongestHandle * chord + 1e-9;
  };
  if (!is_good(first) || !is_good(last)) first = last = chord / 3;
  return {from, from + first * direction.first, to + last * direction.last, to};
}

struct Miss {
  double distance = 0;
  std::size_t point = 0;
};

Miss largest_miss(const Cubic& cubic, Points points, const std::vector<double>& parameter) {
  Miss miss;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double distance = length(point_at(cubic, parameter[i]) - points[i]);
    if (distance > miss.distance) miss = {distance, i};
  }
  return miss;
}

/// Does one step of Newton's method for the nearest point on the cubic.
double nearer_parameter(const Cubic& cubic, Vec2 point, double t) {
  const Vec2 off = point_at(cubic, t) - point;
  const Vec2 first = derivative_at(cubic, t);
  const Vec2 second = 6 * (1 - t) * (cubic[2] - 2 * cubic[1] + cubic[0]) +
                      6 * t * (cubic[3] - 2 * cubic[2] + cubic[1]);
  const double slope = dot(first, first) + dot(off, second);
  if (std::fabs(slope) <= 1e-12) return t;
  return std::clamp(t - dot(off, first) / slope, 0.0, 1.0);
}

class Fitter {
 public:
  /// Adds control points to an empty table.
  Fitter(double tolerance, std::vector<Vec2>& control_points)
      : tolerance_(tolerance), control_points_(control_points) {}

  /// Appends pieces through a run of points without corners.
  void add_run(Points points, EndDirections direction, int depth = 0) {
    if (points.size() < 3) {
      const double handle = length(points.back() - points.front()) / 3;
      return append({points.front(), points.front() + handle * direction.first,
                     points.back() + handle * direction.last, points.back()});
    }
    chord_parameters(points, parameter_);
    Cubic cubic = least_squares(points, parameter_, direction);
    Miss miss = largest_miss(cubic, points, parameter_);
    for (int turn = 0; turn < kReparametrizations && miss.distance > tolerance_; ++turn) {
      if (turn > 0 && miss.distance > kHopeless * tolerance_) break;
      for (std::size_t i = 0; i < points.size(); ++i) {
        parameter_[i] = nearer_parameter(cubic, points[i], parameter_[i]);
      }
      cubic = least_squares(points, parameter_, direction);
      miss = largest_miss(cubic, points, parameter_);
    }
    if (miss.distance <= tolerance_) return append(cubic);
    const std::size_t at = depth < kDeepest ? miss.point : points.size() / 2;
    split(points, direction, std::clamp<std::size_t>(at, 1, points.size() - 2), depth + 1);
  }

 private:
  void split(Points points, EndDirections direction, std::size_t at, int depth) {
    const std::size_t reach = std::min<std::size_t>({4, at, points.size() - 1 - at});
    const Vec2 along = unit(points[at + reach] - points[at - reach]);
    add_run(points.first(at + 1), {direction.first, -1.0 * along}, depth);
    add_run(points.subspan(at), {along, direction.last}, depth);
  }

  void append(const Cubic& cubic) {
    if (control_points_.empty()) control_points_.push_back(cubic[0]);
    control_points_.insert(control_points_.end(), cubic.begin() + 1, cubic.end());
  }

  double tolerance_;
  std::vector<double> parameter_;  ///< per point of the current run
  std::vector<Vec2>& control_points_;
};

/// Finds corners, the sharpest first, none near another.
class CornerFinder {
 public:
  CornerFinder(Points points, const FitOptions& options)
      : points_(points),
        is_loop_(points.front() == points.back()),
        reach_(static_cast<std::size_t>(std::max(options.corner_reach, 1))),
        least_turn_(options.corner_deg * std::numbers::pi / 180) {}

  /// Returns ascending indices of points; on a loop index 0 may be one.
  std::vector<std::size_t> run() const {
    std::vector<Corner> corners;
    const std::size_t count = is_loop_ ? points_.size() - 1 : points_.size();
    for (std::size_t i = 0; i < count; ++i) {
      const std::optional<double> turn = turn_at(i);
      if (turn && *turn >= least_turn_) corners.push_back({i, *turn});
    }
    std::ranges::stable_sort(corners,
                             [](const Corner& a, const Corner& b) { return a.turn > b.turn; });
    std::vector<std::size_t> chosen;
    for (const Corner& corner : corners) {
      const auto is_far = [&](std::size_t other) {
        return apart(corner.index, other) > 2 * reach_;
      };
      if (std::ranges::all_of(chosen, is_far)) chosen.push_back(corner.index);
    }
    std::ranges::sort(chosen);
    return chosen;
  }

 private:
  struct Corner {
    std::size_t index;
    double turn;
  };

  std::optional<double> turn_at(std::size_t i) const {
    const std::size_t count = points_.size() - 1;  // of a loop: without its last
    Vec2 before, after;
    if (is_loop_) {
      if (count <= 2 * reach_) return std::nullopt;
      before = points_[i] - points_[(i + count - reach_) % count];
      after = points_[(i + reach_) % count] - points_[i];
    } else {
      if (i < 2 * reach_ || i + 2 * reach_ > count) return std::nullopt;
      before = points_[i] - points_[i - reach_];
      after = points_[i + reach_] - points_[i];
    }
    return std::fabs(std::atan2(cross(before, after), dot(before, after)));
  }

  std::size_t apart(std::size_t a, std::size_t b) const {
    const std::size_t far = a > b ? a - b : b - a;
    return is_loop_ ? std::min(far, points_.size() - 1 - far) : far;
  }

  Points points_;
  bool is_loop_;
  std::size_t reach_;
  double least_turn_;
};

EndDirections directions_of(Points run) {
  const std::size_t reach = std::min(kEndReach, run.size() - 1);
  return {unit(run[reach] - run[0]), unit(run[run.size() - 1 - reach] - run[run.size() - 1])};
}

/// Returns the loop from another start point.
std::vector<Vec2> rotated(Points loop, std::size_t first) {
  std::vector<Vec2> points(loop.begin() + static_cast<std::ptrdiff_t>(first), loop.end() - 1);
  points.insert(points.end(), loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(first) + 1);
  return points;
}

}  // namespace

void fit_curve(Points points, const FitOptions& options, std::vector<Vec2>& control_points) {
  const bool is_loop = points.size() > 3 && points.front() == points.back();
  std::vector<std::size_t> corners = CornerFinder(points, options).run();
  std::vector<Vec2> turned;
  if (is_loop && !corners.empty()) {
    const std::size_t first = corners.front();
    turned = rotated(points, first);
    points = turned;
    for (std::size_t& corner : corners) corner -= first;
    corners.erase(corners.begin());
  }
  const bool has_smooth_seam = is_loop && turned.empty();
  std::vector<std::size_t> ends{0};
  ends.insert(ends.end(), corners.begin(), corners.end());
  ends.push_back(points.size() - 1);
  const std::size_t reach = std::min(kEndReach, points.size() - 1);
  const Vec2 seam = unit(points[reach] - points[points.size() - 1 - reach]);
  control_points.clear();
  Fitter fitter(options.tolerance, control_points);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const Points run = points.subspan(ends[i], ends[i + 1] - ends[i] + 1);
    EndDirections direction = directions_of(run);
    if (has_smooth_seam && i == 0) direction.first = seam;
    if (has_smooth_seam && i + 2 == ends.size()) direction.last = -1.0 * seam;
    fitter.add_run(run, direction);
  }
}

}  // namespace sfumato::curves
