#include "trace/curves/side_colors.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "base/parallel.hpp"

namespace sfumato::tracing {
namespace {

constexpr double kSideStep = 1.5;  ///< between samples along a curve, pixels
/// Distances of samples from the curve, pixels; for a blurred curve plus 0.6 of its radius.
constexpr std::array<double, 4> kBeside{1.5, 2.0, 2.5, 3.0};
constexpr std::array<double, 3> kBesideFrame{0.5, 1.0, 1.5};
constexpr double kBlurShare = 0.6;
/// Points of the median along a curve: one more than twice this.
constexpr std::ptrdiff_t kMedianReach = 2;
/// By how much the tolerance grows where stops are too many, and up to where: beyond it no colour
/// differs from another.
constexpr double kToleranceGrowth = 1.5;
constexpr double kLargestTolerance = 2;
/// A Gaussian of σ = 1 over the points of a side.
constexpr std::array<float, 4> kSideWeights{0.39905f, 0.24204f, 0.05400f, 0.00443f};

float median(std::span<float> values) {
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5f * (values[half - 1] + values[half]);
}

SideValue value_at(const Picture& picture, Vec2 p) {
  return {picture.code[0].sample(p), picture.code[1].sample(p), picture.code[2].sample(p),
          picture.opacity ? picture.opacity->sample(p) : 1.0f};
}

SideValue median_across(const Picture& picture, const TracedCurve& curve, const CurveSample& at,
                        double sign) {
  const std::span<const double> beside =
      curve.is_frame ? std::span<const double>(kBesideFrame) : std::span<const double>(kBeside);
  std::array<std::array<float, 4>, 4> seen{};
  for (std::size_t i = 0; i < beside.size(); ++i) {
    const double far = sign * (beside[i] + kBlurShare * curve.radius);
    const SideValue value = value_at(picture, at.point + far * at.left);
    for (std::size_t c = 0; c < 4; ++c) seen[c][i] = value[c];
  }
  SideValue value;
  for (std::size_t c = 0; c < 4; ++c) value[c] = median(std::span(seen[c]).first(beside.size()));
  return value;
}

/// Medians of five neighbours, then a Gaussian; short lists stay as they are.
void smooth_along(std::vector<SideValue>& values) {
  const auto count = static_cast<std::ptrdiff_t>(values.size());
  if (count <= 5) return;
  const auto near = [&](std::ptrdiff_t i) {
    return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, count - 1));
  };
  std::vector<SideValue> medians(values.size());
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    for (std::size_t c = 0; c < 4; ++c) {
      std::array<float, 2 * kMedianReach + 1> seen;
      for (std::ptrdiff_t k = -kMedianReach; k <= kMedianReach; ++k) {
        seen[static_cast<std::size_t>(k + kMedianReach)] = values[near(i + k)][c];
      }
      medians[near(i)][c] = median(seen);
    }
  }
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    for (std::size_t c = 0; c < 4; ++c) {
      float sum = kSideWeights[0] * medians[near(i)][c];
      for (std::ptrdiff_t k = 1; k < std::ssize(kSideWeights); ++k) {
        sum += kSideWeights[static_cast<std::size_t>(k)] *
               (medians[near(i - k)][c] + medians[near(i + k)][c]);
      }
      values[near(i)][c] = sum;
    }
  }
}

/// Which samples become stops: linear interpolation between these misses none by more than the
/// tolerance (Ramer 1972, Douglas and Peucker 1973). Ascending.
std::vector<std::size_t> stops_among(const std::vector<CurveSample>& samples,
                                     const std::vector<SideValue>& values, double tolerance) {
  struct Range {
    std::size_t first, last;
  };
  std::vector<std::size_t> kept{0, samples.size() - 1};
  std::vector<Range> waiting{{0, samples.size() - 1}};
  while (!waiting.empty()) {
    const auto [first, last] = waiting.back();
    waiting.pop_back();
    double most = tolerance * tolerance;
    std::size_t at = 0;
    const double way = samples[last].parameter - samples[first].parameter;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double t = (samples[i].parameter - samples[first].parameter) / std::max(way, 1e-9);
      double miss = 0;
      for (std::size_t c = 0; c < 4; ++c) {
        const double between = values[first][c] + t * (values[last][c] - values[first][c]);
        miss += (between - values[i][c]) * (between - values[i][c]);
      }
      if (miss > most) most = miss, at = i;
    }
    if (at == 0) continue;
    kept.push_back(at);
    waiting.push_back({first, at});
    waiting.push_back({at, last});
  }
  std::ranges::sort(kept);
  return kept;
}

SideStops stops_of(const Picture& picture, const TracedCurve& curve,
                   const std::vector<CurveSample>& samples, double sign, double tolerance) {
  std::vector<SideValue> values;
  values.reserve(samples.size());
  for (const CurveSample& at : samples) values.push_back(median_across(picture, curve, at, sign));
  smooth_along(values);
  SideStops stops;
  for (const std::size_t i : stops_among(samples, values, tolerance)) {
    stops.place.push_back(samples[i].parameter);
    stops.value.push_back(values[i]);
  }
  return stops;
}

Status sample_within(Context& context, const Picture& picture, double tolerance,
                     std::span<TracedCurve> curves) {
  return parallel_for(context, curves.size(), 1, [&](std::size_t i, std::size_t) {
    TracedCurve& curve = curves[i];
    const std::vector<CurveSample> samples = samples_along(curve, kSideStep);
    if (!curve.is_frame) curve.side[0] = stops_of(picture, curve, samples, 1, tolerance);
    curve.side[1] = stops_of(picture, curve, samples, -1, tolerance);
  });
}

}  // namespace

Status sample_sides(Context& context, const Picture& picture, double tolerance,
                    std::size_t most_stops, std::span<TracedCurve> curves) {
  for (;; tolerance *= kToleranceGrowth) {
    Status status = sample_within(context, picture, tolerance, curves);
    std::size_t stops = 0;
    for (const TracedCurve& curve : curves) stops += stop_count(curve);
    if (!status || stops <= most_stops || tolerance > kLargestTolerance) return status;
  }
}

}  // namespace sfumato::tracing
