#include "trace/image/gradient.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

#include "base/parallel.hpp"
#include "base/try.hpp"

namespace sfumato::tracing {
namespace {

/// A Gaussian is cut off where it has fallen to 1/2000 of its peak.
constexpr double kSigmas = 3.9;

/// Rows that one task filters.
constexpr std::size_t kFilteredRows = 16;

/// Half of a kernel: the weights of the pixel itself and of its neighbours on one side.
using HalfKernel = std::vector<float>;

HalfKernel gaussian(double sigma) {
  const int reach = std::max(1, static_cast<int>(std::ceil(kSigmas * sigma)));
  HalfKernel kernel(static_cast<std::size_t>(reach) + 1);
  double sum = 0;
  for (int i = 0; i <= reach; ++i) {
    const double weight = std::exp(-0.5 * i * i / (sigma * sigma));
    kernel[static_cast<std::size_t>(i)] = static_cast<float>(weight);
    sum += i == 0 ? weight : 2 * weight;
  }
  for (float& weight : kernel) weight = static_cast<float>(weight / sum);
  return kernel;
}

/// The weight of x + i in the antisymmetric derivative; a ramp of one per pixel gives 1.
HalfKernel derivative(const HalfKernel& smoothing) {
  HalfKernel kernel(smoothing.size());
  double slope = 0;
  for (std::size_t i = 0; i < kernel.size(); ++i) {
    kernel[i] = static_cast<float>(i) * smoothing[i];
    slope += 2.0 * static_cast<double>(i) * kernel[i];
  }
  for (float& weight : kernel) weight = static_cast<float>(weight / slope);
  return kernel;
}

/// out = the row filtered by both kernels; `padded` is where the row is continued.
void filter_row(const float* row, int width, const HalfKernel& even, const HalfKernel& odd,
                std::vector<float>& padded, float* smoothed, float* changed) {
  const int reach = static_cast<int>(even.size()) - 1;
  padded.resize(static_cast<std::size_t>(width + 2 * reach));
  for (int x = -reach; x < width + reach; ++x) {
    padded[static_cast<std::size_t>(x + reach)] = row[std::clamp(x, 0, width - 1)];
  }
  const float* middle = padded.data() + reach;
  for (int x = 0; x < width; ++x) smoothed[x] = even[0] * middle[x];
  if (changed) std::fill(changed, changed + width, 0.0f);
  for (int i = 1; i <= reach; ++i) {
    const float weight = even[static_cast<std::size_t>(i)];
    const float slope = odd[static_cast<std::size_t>(i)];
    const float* before = middle - i;
    const float* after = middle + i;
    for (int x = 0; x < width; ++x) smoothed[x] += weight * (after[x] + before[x]);
    if (!changed) continue;
    for (int x = 0; x < width; ++x) changed[x] += slope * (after[x] - before[x]);
  }
}

/// Adds a symmetric or antisymmetric sum over column neighbours of row y to `out`, which is zero.
void filter_columns(const Plane& from, int y, const HalfKernel& kernel, bool is_odd, float* out) {
  const int reach = static_cast<int>(kernel.size()) - 1;
  const int width = from.width;
  const float* middle = from.row(y);
  for (int x = 0; x < width; ++x) out[x] = kernel[0] * middle[x];
  const float sign = is_odd ? -1.0f : 1.0f;
  for (int i = 1; i <= reach; ++i) {
    const float weight = kernel[static_cast<std::size_t>(i)];
    const float* above = from.row(std::max(y - i, 0));
    const float* below = from.row(std::min(y + i, from.height - 1));
    for (int x = 0; x < width; ++x) out[x] += weight * (below[x] + sign * above[x]);
  }
}

/// A structure tensor [xx xy; xy yy] to its larger eigenvalue's root and vector.
struct Eigen {
  float strength, x, y;
};

Eigen eigen_of(float xx, float xy, float yy) {
  const float half = 0.5f * (xx - yy), mean = 0.5f * (xx + yy);
  const float root = std::sqrt(half * half + xy * xy);
  // There are two formulas for the vector; this one has no cancellation.
  float x = half >= 0 ? half + root : xy;
  float y = half >= 0 ? xy : root - half;
  const float norm = std::sqrt(x * x + y * y);
  if (norm > 0) {
    x /= norm, y /= norm;
  } else {
    x = 1, y = 0;
  }
  return {std::sqrt(std::max(mean + root, 0.0f)), x, y};
}

class GradientFilter {
 public:
  GradientFilter(Context& context, double sigma, Gradient& out)
      : context_(context), even_(gaussian(sigma)), odd_(derivative(even_)), out_(out) {}

  Status run(std::span<const Plane> channels, TableMemory& memory) {
    const int width = channels[0].width, height = channels[0].height;
    TableMemory scratch("the edges of a picture");
    for (Plane* plane : {&out_.strength, &out_.normal_x, &out_.normal_y}) {
      SFUMATO_TRY(make_plane(context_, width, height, memory, *plane));
      std::ranges::fill(plane->value, 0.0f);
    }
    SFUMATO_TRY(make_plane(context_, width, height, scratch, smoothed_));
    SFUMATO_TRY(make_plane(context_, width, height, scratch, changed_));
    for (const Plane& channel : channels) SFUMATO_TRY(add(channel));
    return finish();
  }

 private:
  std::size_t row_count() const { return static_cast<std::size_t>(smoothed_.height); }

  /// Sums the tensor: xx in `strength`, xy in `normal_x`, yy in `normal_y`.
  Status add(const Plane& channel) {
    const int width = channel.width;
    SFUMATO_TRY(
        parallel_for(context_, row_count(), kFilteredRows, [&](std::size_t y, std::size_t end) {
          std::vector<float> padded;
          for (int row = static_cast<int>(y); row < static_cast<int>(end); ++row) {
            filter_row(channel.row(row), width, even_, odd_, padded, smoothed_.row(row),
                       changed_.row(row));
          }
        }));
    return parallel_for(context_, row_count(), kFilteredRows, [&](std::size_t y, std::size_t end) {
      std::vector<float> dx(static_cast<std::size_t>(width)), dy(dx.size());
      for (int row = static_cast<int>(y); row < static_cast<int>(end); ++row) {
        filter_columns(changed_, row, even_, false, dx.data());
        filter_columns(smoothed_, row, odd_, true, dy.data());
        float* xx = out_.strength.row(row);
        float* xy = out_.normal_x.row(row);
        float* yy = out_.normal_y.row(row);
        for (std::size_t x = 0; x < dx.size(); ++x) {
          xx[x] += dx[x] * dx[x];
          xy[x] += dx[x] * dy[x];
          yy[x] += dy[x] * dy[x];
        }
      }
    });
  }

  Status finish() {
    const auto width = static_cast<std::size_t>(smoothed_.width);
    return parallel_for(context_, row_count(), kFilteredRows, [&](std::size_t y, std::size_t end) {
      for (std::size_t i = y * width; i < end * width; ++i) {
        const Eigen eigen =
            eigen_of(out_.strength.value[i], out_.normal_x.value[i], out_.normal_y.value[i]);
        out_.strength.value[i] = eigen.strength;
        out_.normal_x.value[i] = eigen.x;
        out_.normal_y.value[i] = eigen.y;
      }
    });
  }

  Context& context_;
  HalfKernel even_, odd_;
  Gradient& out_;
  Plane smoothed_, changed_;
};

}  // namespace

Status find_gradient(Context& context, std::span<const Plane> channels, double sigma,
                     TableMemory& memory, Gradient& out) {
  return GradientFilter(context, sigma, out).run(channels, memory);
}

Status smooth(Context& context, double sigma, TableMemory& memory, Plane& channel) {
  const HalfKernel kernel = gaussian(sigma);
  TableMemory scratch("the edges of a picture");
  Plane rows;
  SFUMATO_TRY(make_plane(context, channel.width, channel.height, scratch, rows));
  const auto height = static_cast<std::size_t>(channel.height);
  SFUMATO_TRY(parallel_for(context, height, kFilteredRows, [&](std::size_t y, std::size_t end) {
    std::vector<float> padded;
    for (int row = static_cast<int>(y); row < static_cast<int>(end); ++row) {
      filter_row(channel.row(row), channel.width, kernel, kernel, padded, rows.row(row), nullptr);
    }
  }));
  SFUMATO_TRY(make_plane(context, channel.width, channel.height, memory, channel));
  return parallel_for(context, height, kFilteredRows, [&](std::size_t y, std::size_t end) {
    for (int row = static_cast<int>(y); row < static_cast<int>(end); ++row) {
      filter_columns(rows, row, kernel, false, channel.row(row));
    }
  });
}

}  // namespace sfumato::tracing
