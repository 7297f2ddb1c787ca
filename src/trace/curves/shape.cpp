#include "trace/curves/shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "base/parallel.hpp"
#include "curves/bezier.hpp"

namespace sfumato::tracing {
namespace {

constexpr double kSampleStep = 1;  ///< between samples along a curve, pixels
constexpr double kAcross = 0.5;    ///< between samples across it
constexpr double kLargestReach = 8;
constexpr double kLargestShift = 1;
/// Added to the square of a jump, so that weak edges hardly move.
constexpr double kLeastJump = 4e-4;
/// How much control points resist a shift, and inner ones a shift other than that of the piece's
/// nearer end, in shares of the weight of the samples near them.
constexpr double kResistance = 0.02;
constexpr double kStiffness = 0.1;
constexpr int kSolverSteps = 24;
/// A Gaussian of σ = 2 along the curve.
constexpr std::array<double, 7> kAlongWeights{0.1995, 0.1760, 0.1210, 0.0648,
                                              0.0270, 0.0088, 0.0022};

using Jump = std::array<double, 4>;

/// How a curve is to shift at a sample, to the left, and how much that counts.
struct Shift {
  double left = 0;
  double weight = 0;
};

/// Returns the share of a shift's effect at a distance from a blurred curve, per pixel: the slope
/// of β.
double spread(double distance, double radius) {
  const double x = 0.5 + 0.5 * distance / radius;
  return distance < radius ? 3 * x * (1 - x) / radius : 0.0;
}

/// The missing part across the curve at a sample, projected on its jump: numerator and denominator.
struct Projection {
  double along = 0, jump = 0;
};

Projection project(std::span<const Plane> missing, const TracedCurve& curve, double sharp_reach,
                   const CurveSample& at) {
  const SideValue left = value_at(curve.side[0], at.parameter);
  const SideValue right = value_at(curve.side[1], at.parameter);
  Jump jump;
  double square = 0;
  for (std::size_t c = 0; c < missing.size(); ++c) {
    jump[c] = double{right[c]} - left[c];
    square += jump[c] * jump[c];
  }
  const bool is_blurred = curve.radius > sharp_reach;
  const double reach = is_blurred ? std::min(curve.radius, kLargestReach) : sharp_reach;
  double sum = 0, norm = is_blurred ? 0.0 : 1.0;
  for (double far = -reach; far <= reach + 1e-9; far += kAcross) {
    const double kernel = is_blurred ? spread(std::fabs(far), curve.radius) : 1.0;
    const Vec2 p = at.point + far * at.left;
    double dot = 0;
    for (std::size_t c = 0; c < missing.size(); ++c) dot += jump[c] * missing[c].sample(p);
    sum += kAcross * kernel * dot;
    if (is_blurred) norm += kAcross * kernel * kernel;
  }
  // A shift to the left shows the right side's colour where the left one's was.
  return {sum, norm * square};
}

std::vector<Shift> shifts_along(std::span<const Plane> missing, const TracedCurve& curve,
                                double sharp_reach, const std::vector<CurveSample>& samples) {
  std::vector<Projection> own;
  own.reserve(samples.size());
  for (const CurveSample& at : samples) own.push_back(project(missing, curve, sharp_reach, at));
  const auto count = static_cast<std::ptrdiff_t>(own.size());
  std::vector<Shift> shifts;
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    Projection mean;
    for (std::ptrdiff_t k = 1 - std::ssize(kAlongWeights); k < std::ssize(kAlongWeights); ++k) {
      if (i + k < 0 || i + k >= count) continue;
      const double weight = kAlongWeights[static_cast<std::size_t>(std::abs(k))];
      mean.along += weight * own[static_cast<std::size_t>(i + k)].along;
      mean.jump += weight * own[static_cast<std::size_t>(i + k)].jump;
    }
    const double shift = mean.along / (mean.jump + kLeastJump);
    shifts.push_back({std::clamp(shift, -kLargestShift, kLargestShift), mean.jump});
  }
  return shifts;
}

/// Least squares for shifts of a curve's control points.
class ShapeFit {
 public:
  ShapeFit(const TracedCurve& curve, const std::vector<CurveSample>& samples,
           const std::vector<Shift>& shifts, double give)
      : samples_(samples), shifts_(shifts), count_(curve.control_points.size()), give_(give) {
    is_closed_ = is_closed(curve);
    for (const Shift& shift : shifts) weight_ += shift.weight;
    weight_ = std::max(weight_ / static_cast<double>(count_), 1e-12);
  }

  std::vector<Vec2> run() const {
    std::vector<Vec2> x(count_), residual(count_), direction, image(count_);
    for (std::size_t s = 0; s < samples_.size(); ++s) {
      add(s, shifts_[s].weight * shifts_[s].left, residual);
    }
    close(residual);
    direction = residual;
    double slope = inner(residual, residual);
    const double first = slope;
    for (int step = 0; step < kSolverSteps && slope > 1e-8 * first; ++step) {
      apply(direction, image);
      const double bend = inner(direction, image);
      if (!(bend > 0)) break;
      const double go = slope / bend;
      for (std::size_t i = 0; i < count_; ++i) {
        x[i] = x[i] + go * direction[i];
        residual[i] = residual[i] - go * image[i];
      }
      const double next = inner(residual, residual);
      for (std::size_t i = 0; i < count_; ++i) {
        direction[i] = residual[i] + next / slope * direction[i];
      }
      slope = next;
    }
    return x;
  }

 private:
  /// Sets the weights of a sample's four control points. Returns the index of the first point.
  std::size_t basis(std::size_t s, std::array<double, 4>& weight) const {
    const double parameter = samples_[s].parameter;
    const std::size_t piece = std::min(static_cast<std::size_t>(parameter), (count_ - 1) / 3 - 1);
    const double t = parameter - static_cast<double>(piece), u = 1 - t;
    weight = {u * u * u, 3 * u * u * t, 3 * u * t * t, t * t * t};
    return 3 * piece;
  }

  void add(std::size_t s, double amount, std::vector<Vec2>& to) const {
    std::array<double, 4> weight;
    const std::size_t first = basis(s, weight);
    for (std::size_t k = 0; k < 4; ++k) {
      to[first + k] = to[first + k] + amount * weight[k] * samples_[s].left;
    }
  }

  /// The first and the last control point of a closed curve are one.
  void close(std::vector<Vec2>& v) const {
    if (!is_closed_) return;
    v.front() = v.back() = 0.5 * (v.front() + v.back());
  }

  double inner(const std::vector<Vec2>& a, const std::vector<Vec2>& b) const {
    double sum = 0;
    for (std::size_t i = 0; i < count_; ++i) sum += dot(a[i], b[i]);
    return sum;
  }

  void apply(const std::vector<Vec2>& v, std::vector<Vec2>& out) const {
    for (std::size_t i = 0; i < count_; ++i) out[i] = kResistance / give_ * weight_ * v[i];
    for (std::size_t s = 0; s < samples_.size(); ++s) {
      std::array<double, 4> weight;
      const std::size_t first = basis(s, weight);
      double left = 0;
      for (std::size_t k = 0; k < 4; ++k) {
        left += weight[k] * dot(v[first + k], samples_[s].left);
      }
      add(s, shifts_[s].weight * left, out);
    }
    for (std::size_t i = 0; i + 3 < count_; i += 3) {
      stiffen(v, i + 1, i, out);
      stiffen(v, i + 2, i + 3, out);
    }
    close(out);
  }

  void stiffen(const std::vector<Vec2>& v, std::size_t handle, std::size_t end,
               std::vector<Vec2>& out) const {
    const Vec2 pull = kStiffness / give_ * weight_ * (v[handle] - v[end]);
    out[handle] = out[handle] + pull;
    out[end] = out[end] - pull;
  }

  const std::vector<CurveSample>& samples_;
  const std::vector<Shift>& shifts_;
  std::size_t count_;
  double give_;  ///< ShapeOptions::give
  bool is_closed_ = false;
  double weight_ = 0;
};

/// Makes handles that were in line so again.
void smooth_joint(const std::vector<Vec2>& before, std::size_t in, std::size_t joint,
                  std::size_t out, std::vector<Vec2>& points) {
  const Vec2 a = before[joint] - before[in], b = before[out] - before[joint];
  if (dot(a, b) < 0.999 * length(a) * length(b)) return;
  const Vec2 from = points[joint] - points[in], to = points[out] - points[joint];
  const double far_in = length(from), far_out = length(to);
  if (!(far_in > 0 && far_out > 0)) return;
  const Vec2 mean = from / far_in + to / far_out;
  const double norm = length(mean);
  if (!(norm > 0)) return;
  points[in] = points[joint] - far_in / norm * mean;
  points[out] = points[joint] + far_out / norm * mean;
}

/// Moves the control points of a piece that leaves the picture into the picture, because the piece
/// stays within their hull. If a piece stays inside, its handles may lie outside, as in a long arc.
void keep_inside(std::span<Vec2> points, Vec2 size) {
  constexpr int kParts = 32;
  const auto inside = [size](Vec2 p) {
    return Vec2{std::clamp(p.x, 0.0, size.x), std::clamp(p.y, 0.0, size.y)};
  };
  const curves::Cubic cubic = curves::piece(points, 0);
  bool leaves = false;
  for (int k = 0; k <= kParts; ++k) {
    const Vec2 p = curves::point_at(cubic, static_cast<double>(k) / kParts);
    leaves = leaves || !(p == inside(p));
  }
  if (!leaves) return;
  for (Vec2& p : points) p = inside(p);
}

void improve(std::span<const Plane> missing, const ShapeOptions& options, TracedCurve& curve) {
  const std::vector<CurveSample> samples = samples_along(curve, kSampleStep);
  const std::vector<Shift> shifts = shifts_along(missing, curve, options.reach, samples);
  const std::vector<Vec2> shift = ShapeFit(curve, samples, shifts, options.give).run();
  const std::vector<Vec2> before = curve.control_points;
  std::vector<Vec2>& points = curve.control_points;
  const auto width = static_cast<double>(missing[0].width);
  const auto height = static_cast<double>(missing[0].height);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double far = length(shift[i]);
    const Vec2 by = far > kLargestShift ? kLargestShift / far * shift[i] : shift[i];
    points[i] = points[i] + by;
  }
  for (std::size_t i = 3; i + 3 < points.size(); i += 3) {
    smooth_joint(before, i - 1, i, i + 1, points);
  }
  if (before.front() == before.back()) {
    points.back() = points.front();
    smooth_joint(before, points.size() - 2, points.size() - 1, 1, points);
    points.front() = points.back();
  }
  for (std::size_t i = 0; i + 3 < points.size(); i += 3) {
    keep_inside(std::span(points).subspan(i, 4), {width, height});
  }
}

}  // namespace

Status improve_shapes(Context& context, std::span<const Plane> missing,
                      std::span<TracedCurve> curves, const ShapeOptions& options) {
  return parallel_for(context, curves.size(), 2, [&](std::size_t i, std::size_t end) {
    for (; i < end; ++i) {
      if (!curves[i].is_frame) improve(missing, options, curves[i]);
    }
  });
}

}  // namespace sfumato::tracing
