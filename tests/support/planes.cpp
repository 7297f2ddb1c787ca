#include "support/planes.hpp"

#include <cmath>
#include <cstring>

namespace sfumato::test {
namespace {

/// Returns a channel from 0 to 1.
double code_value(const Image& image, std::size_t index) {
  if (bytes_per_channel(image.format) == 1) return image.bytes[index] / 255.0;
  std::uint16_t wide = 0;
  std::memcpy(&wide, image.bytes.data() + 2 * index, sizeof wide);
  return wide / 65535.0;
}

/// Returns the index in a row of `count` that is mirrored at its ends: ... 1 0 | 0 1 2 ... | last
/// ...
int mirrored(int i, int count) {
  while (i < 0 || i >= count) i = i < 0 ? -1 - i : 2 * count - 1 - i;
  return i;
}

}  // namespace

Planes planes_of(const Image& image, Rgb background) {
  const std::size_t count = static_cast<std::size_t>(image.width) * image.height;
  const std::array<float, 3> behind{background.r, background.g, background.b};
  const auto channels = static_cast<std::size_t>(channel_count(image.format));
  Planes planes;
  for (std::size_t c = 0; c < 3; ++c) {
    planes[c] = {image.width, image.height, std::vector<float>(count)};
    for (std::size_t i = 0; i < count; ++i) {
      const double alpha = channels == 4 ? code_value(image, 4 * i + 3) : 1;
      const double shown = code_value(image, channels * i + c);
      planes[c].value[i] = static_cast<float>(alpha * shown + (1 - alpha) * double{behind[c]});
    }
  }
  return planes;
}

std::vector<double> gaussian_weights(double sigma, int radius, bool slope) {
  std::vector<double> weights;
  double sum = 0, moment = 0;
  for (int i = -radius; i <= radius; ++i) {
    const double bell = std::exp(-i * i / (2 * sigma * sigma));
    weights.push_back(slope ? i * bell : bell);
    sum += bell;
    moment += i * i * bell;
  }
  for (double& weight : weights) weight /= slope ? moment : sum;
  return weights;
}

Plane filtered(const Plane& plane, std::span<const double> across, std::span<const double> down) {
  const int x_radius = static_cast<int>(across.size() / 2);
  const int y_radius = static_cast<int>(down.size() / 2);
  Plane rows = plane, result = plane;
  for (int y = 0; y < plane.height; ++y) {
    for (int x = 0; x < plane.width; ++x) {
      double sum = 0;
      for (int i = -x_radius; i <= x_radius; ++i) {
        sum += across[static_cast<std::size_t>(i + x_radius)] *
               double{plane.at(mirrored(x + i, plane.width), y)};
      }
      rows.value[static_cast<std::size_t>(y) * plane.width + x] = static_cast<float>(sum);
    }
  }
  for (int y = 0; y < plane.height; ++y) {
    for (int x = 0; x < plane.width; ++x) {
      double sum = 0;
      for (int i = -y_radius; i <= y_radius; ++i) {
        sum += down[static_cast<std::size_t>(i + y_radius)] *
               double{rows.at(x, mirrored(y + i, plane.height))};
      }
      result.value[static_cast<std::size_t>(y) * plane.width + x] = static_cast<float>(sum);
    }
  }
  return result;
}

}  // namespace sfumato::test
