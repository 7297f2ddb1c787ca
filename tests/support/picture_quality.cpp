#include "support/picture_quality.hpp"

#include <cmath>
#include <limits>

namespace sfumato::test {
namespace {

constexpr double kSigma = 1.5;
constexpr int kRadius = 5;  // 3.5 standard deviations
constexpr double kMeanConstant = 0.01 * 0.01;
constexpr double kVarianceConstant = 0.03 * 0.03;

Plane product(const Plane& a, const Plane& b) {
  Plane result = a;
  for (std::size_t i = 0; i < a.value.size(); ++i) result.value[i] *= b.value[i];
  return result;
}

double channel_ssim(const Plane& a, const Plane& b) {
  const std::vector<double> bell = gaussian_weights(kSigma, kRadius);
  const auto smooth = [&](const Plane& plane) { return filtered(plane, bell, bell); };
  const Plane mean_a = smooth(a), mean_b = smooth(b);
  const Plane square_a = smooth(product(a, a)), square_b = smooth(product(b, b));
  const Plane mixed = smooth(product(a, b));
  double sum = 0;
  int count = 0;
  for (int y = kRadius; y < a.height - kRadius; ++y) {
    for (int x = kRadius; x < a.width - kRadius; ++x, ++count) {
      const double m = mean_a.at(x, y), n = mean_b.at(x, y);
      const double variances = square_a.at(x, y) - m * m + square_b.at(x, y) - n * n;
      const double covariance = mixed.at(x, y) - m * n;
      sum += (2 * m * n + kMeanConstant) * (2 * covariance + kVarianceConstant) /
             ((m * m + n * n + kMeanConstant) * (variances + kVarianceConstant));
    }
  }
  return sum / count;
}

}  // namespace

double psnr_db(const Planes& a, const Planes& b) {
  double sum = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t i = 0; i < a[c].value.size(); ++i) {
      const double difference = double{a[c].value[i]} - double{b[c].value[i]};
      sum += difference * difference;
    }
  }
  if (sum == 0) return std::numeric_limits<double>::infinity();
  return 10 * std::log10(3 * static_cast<double>(a[0].value.size()) / sum);
}

std::optional<double> ssim(const Planes& a, const Planes& b) {
  if (a[0].width <= 2 * kRadius || a[0].height <= 2 * kRadius) return std::nullopt;
  return (channel_ssim(a[0], b[0]) + channel_ssim(a[1], b[1]) + channel_ssim(a[2], b[2])) / 3;
}

}  // namespace sfumato::test
