#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <vector>

#include "sfumato/raster/rasterize.hpp"

namespace sfumato::test {

/// Returns the mean difference of all channels of two pictures, drawn `side` pixels wide and high,
/// in code values.
inline double mean_difference(const Picture& a, const Picture& b, int side = 128) {
  Context context;
  RasterOptions options;
  options.width = options.height = side;
  const Result<Image> one = rasterize(context, a, options);
  const Result<Image> other = rasterize(context, b, options);
  EXPECT_TRUE(one.ok() && other.ok());
  double sum = 0;
  const std::vector<std::uint8_t>& pixels = one->bytes;
  const std::vector<std::uint8_t>& others = other->bytes;
  EXPECT_EQ(pixels.size(), others.size());
  for (std::size_t i = 0; i < pixels.size(); ++i) sum += std::abs(int{pixels[i]} - int{others[i]});
  return sum / static_cast<double>(pixels.size());
}

}  // namespace sfumato::test
