#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <vector>

#include "sfumato/raster/rasterize.hpp"

namespace sfumato::test {

/// Half a step of 16 bits, plus the rasterizer's allowed error.
inline constexpr double kAllowed = 0.5 / 257 + 0.02;

inline RasterOptions image_size(int width, int height, PixelFormat format = PixelFormat::rgb16) {
  RasterOptions options;
  options.width = width;
  options.height = height;
  options.format = format;
  return options;
}

inline Image rasterized(const Picture& picture, const RasterOptions& options) {
  Context context;
  Result<Image> image = rasterize(context, picture, options);
  EXPECT_TRUE(image.ok()) << to_string(image.status());
  return image.ok() ? *image : Image{};
}

inline void expect_same_for_every_instruction_set(const Picture& picture,
                                                  const RasterOptions& options) {
  std::vector<std::uint8_t> first;
  for (SimdLevel level : {SimdLevel::sse2, SimdLevel::avx2, SimdLevel::avx512}) {
    if (level > detected_simd_level()) continue;
    Context context;
    context.simd = level;
    const Result<Image> image = rasterize(context, picture, options);
    ASSERT_TRUE(image.ok()) << to_string(image.status());
    if (first.empty()) first = image->bytes;
    EXPECT_EQ(image->bytes, first) << static_cast<int>(level);
  }
}

/// Returns a channel in steps of its format.
inline int channel(const Image& image, int x, int y, int c) {
  const std::size_t index =
      (static_cast<std::size_t>(y) * image.width + x) * channel_count(image.format) + c;
  if (bytes_per_channel(image.format) == 1) return image.bytes[index];
  std::uint16_t value;
  std::memcpy(&value, &image.bytes[2 * index], 2);
  return value;
}

/// Returns a channel in code values of 255.
inline double code_value(const Image& image, int x, int y, int c) {
  return bytes_per_channel(image.format) == 1 ? channel(image, x, y, c)
                                              : channel(image, x, y, c) / 257.0;
}

}  // namespace sfumato::test
