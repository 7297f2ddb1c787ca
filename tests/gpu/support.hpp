#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <string>

#include "gpu/device.hpp"
#include "raster/support.hpp"
#include "sfumato/gpu/render.hpp"
#include "support/places.hpp"

/// Skips a test if there is no OpenGL ES 3 context.
#define SFUMATO_NEEDS_GPU()                                                        \
  if (const auto found = sfumato::gpu::Device::create(); !found) {                 \
    ASSERT_EQ(found.status().code, sfumato::StatusCode::unavailable);              \
    GTEST_SKIP() << found.status().message << " (libgl1-mesa-dri is enough here)"; \
  }

namespace sfumato::test {

inline const std::string kExamplesFolder = source_path("examples");

/// The difference of two images of one picture, in code values of 255, for colours times alpha.
struct Nearness {
  std::size_t pixels = 0;
  std::size_t differing = 0;  ///< by more than one code value
  double worst = 0;
  int worst_x = 0, worst_y = 0;
};

inline Nearness nearness(const Image& a, const Image& b) {
  Nearness result;
  const int channels = channel_count(a.format);
  const auto value = [&](const Image& image, int x, int y, int c) {
    const double alpha = channels == 4 ? code_value(image, x, y, 3) / 255 : 1;
    return code_value(image, x, y, c) * (c < 3 ? alpha : 1);
  };
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      double difference = 0;
      for (int c = 0; c < channels; ++c)
        difference = std::max(difference, std::abs(value(a, x, y, c) - value(b, x, y, c)));
      ++result.pixels;
      if (difference > 1.001) ++result.differing;
      if (difference <= result.worst) continue;
      result.worst = difference;
      result.worst_x = x;
      result.worst_y = y;
    }
  }
  return result;
}

inline Image on_gpu(const Picture& picture, const RasterOptions& options) {
  Context context;
  Result<Image> image = render_on_gpu(context, picture, options);
  EXPECT_TRUE(image.ok()) << to_string(image.status());
  EXPECT_EQ(context.budget.used(), 0u);
  return image.ok() ? std::move(*image) : Image{};
}

/// Expects GPU and CPU to agree, except for one pixel in 5,000 (docs/gpu.md, "How near to the
/// CPU").
inline void expect_near(const Picture& picture, const RasterOptions& options) {
  const Image expected = rasterized(picture, options);
  const Image image = on_gpu(picture, options);
  ASSERT_EQ(image.bytes.size(), expected.bytes.size());
  ASSERT_GT(image.bytes.size(), 0u);
  const Nearness near = nearness(expected, image);
  EXPECT_LE(near.differing, near.pixels / 5000)
      << "worst " << near.worst << " at " << near.worst_x << ", " << near.worst_y;
}

}  // namespace sfumato::test
