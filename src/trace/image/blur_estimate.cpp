#include "trace/image/blur_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "trace/image/gradient.hpp"

namespace sfumato::tracing {
namespace {

constexpr double kScaleRatio = 1.6;
/// R in multiples of σ with which the blend of eq. 8 is most like an edge blurred by a Gaussian.
constexpr double kRadiusPerSigma = 1.88;
constexpr double kLargestRadius = 16;
/// The standard deviation σ of a pixel's own square.
constexpr double kPixelSigma = 0.45;

/// Returns σ² of the edge's own blur if its gradient falls by `ratio` from scale s1 to s2: g(s) ∝ 1
/// / √(σ² + s²).
double blur_variance(double ratio, double s1, double s2) {
  const double squared = std::clamp(ratio * ratio, 0.02, 0.999);
  const double variance = (squared * s2 * s2 - s1 * s1) / (1 - squared);
  const double most = kLargestRadius / kRadiusPerSigma;
  return std::clamp(variance, 0.0, most * most);
}

/// Curves found at one scale share two gradients.
class ScaleEstimator {
 public:
  ScaleEstimator(Context& context, std::span<const Plane> channels, double scale)
      : context_(context), channels_(channels), s1_(std::max(1.0, 0.7 * scale)) {}

  Status prepare() {
    SFUMATO_TRY(find_gradient(context_, channels_, s1_, memory_, fine_));
    return find_gradient(context_, channels_, s2(), memory_, coarse_);
  }

  double radius_of(const TracedCurve& curve) const {
    std::vector<double> variances;
    for (const CurveSample& at : samples_along(curve, 1)) {
      const double fine = fine_.strength.sample(at.point);
      const double coarse = coarse_.strength.sample(at.point);
      variances.push_back(blur_variance(coarse / std::max(fine, 1e-9), s1_, s2()));
    }
    const auto middle = variances.begin() + static_cast<std::ptrdiff_t>(variances.size() / 2);
    std::nth_element(variances.begin(), middle, variances.end());
    const double own = std::sqrt(std::max(*middle - kPixelSigma * kPixelSigma, 0.0));
    const double radius = kRadiusPerSigma * own;
    return radius > kSharpRadius ? radius : 0.0;
  }

 private:
  double s2() const { return kScaleRatio * s1_; }

  Context& context_;
  std::span<const Plane> channels_;
  double s1_;
  TableMemory memory_{"the edges of a picture"};
  Gradient fine_, coarse_;
};

}  // namespace

Status estimate_blur(Context& context, std::span<const Plane> channels,
                     std::span<TracedCurve> curves) {
  std::vector<double> scales;
  for (const TracedCurve& curve : curves) {
    if (!curve.is_frame && std::ranges::find(scales, curve.scale) == scales.end()) {
      scales.push_back(curve.scale);
    }
  }
  for (const double scale : scales) {
    ScaleEstimator estimator(context, channels, scale);
    SFUMATO_TRY(estimator.prepare());
    for (TracedCurve& curve : curves) {
      if (context.cancelled()) return context.cancel_status();
      if (!curve.is_frame && curve.scale == scale) curve.radius = estimator.radius_of(curve);
    }
  }
  return ok_status();
}

}  // namespace sfumato::tracing
