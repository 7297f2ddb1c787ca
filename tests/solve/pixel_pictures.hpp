#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "sfumato/raster/rasterize.hpp"
#include "sfumato/solve/diffuse.hpp"
#include "support/drawing.hpp"
#include "support/windows.hpp"

// Pictures for the pixels of an image of 100 × 100.
namespace sfumato::test {

inline Picture solved(const Document& document, const DiffuseOptions& options, Context& context) {
  Result<Picture> picture = diffuse(context, document, options);
  EXPECT_TRUE(picture.ok()) << picture.status().message;
  return picture ? std::move(*picture) : Picture{};
}

inline Picture solved(const Document& document, const DiffuseOptions& options) {
  Context context;
  return solved(document, options, context);
}

/// Draws on a background, so that colours count as much as they show.
inline RasterOptions plain_options() {
  RasterOptions options;
  options.width = options.height = 100;
  options.background = kGreen;
  options.dither = false;
  return options;
}

inline Image drawn(const Picture& picture, const RasterOptions& options, Context& context) {
  Result<Image> image = rasterize(context, picture, options);
  EXPECT_TRUE(image.ok()) << image.status().message;
  return image ? std::move(*image) : Image{};
}

inline Image drawn(const Picture& picture) {
  Context context;
  return drawn(picture, plain_options(), context);
}

inline int largest_difference(const Image& a, const Image& b) {
  int most = 0;
  EXPECT_EQ(a.bytes.size(), b.bytes.size());
  for (std::size_t i = 0; i < std::min(a.bytes.size(), b.bytes.size()); ++i)
    most = std::max(most, std::abs(int{a.bytes[i]} - int{b.bytes[i]}));
  return most;
}

/// Expects that windows of a picture have the bytes of the whole image.
inline void expect_equal_windows(const Picture& picture) {
  Context context;
  const Cut cut{23, 17, -5, -3};
  EXPECT_EQ(painted_in_windows(context, picture, plain_options(), cut).bytes, drawn(picture).bytes);
}

constexpr DiffuseOptions grid() {
  DiffuseOptions options;
  options.pixel_grid = true;
  return options;
}

}  // namespace sfumato::test
