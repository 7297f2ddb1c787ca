#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "sfumato/raster/rasterize.hpp"

namespace sfumato::test {

/// How to cut an image: the first window may begin left of it and above, by less than its size.
struct Cut {
  int width, height;
  int x0 = 0, y0 = 0;
};

/// The rectangle of a cut's window in the image.
struct Part {
  int x, y, width, height;
};

inline std::vector<Part> parts_of(const Cut& cut, int width, int height) {
  std::vector<Part> parts;
  for (int y = cut.y0; y < height; y += cut.height) {
    for (int x = cut.x0; x < width; x += cut.width) {
      const int left = std::max(x, 0), top = std::max(y, 0);
      const int right = std::min(x + cut.width, width), bottom = std::min(y + cut.height, height);
      parts.push_back({left, top, right - left, bottom - top});
    }
  }
  return parts;
}

/// Returns the image that windows make together; calls `paint` with each window and its place.
template <class Paint>
Image joined(const RasterOptions& whole, const Cut& cut, const Paint& paint) {
  Image image{whole.width, whole.height, whole.format, {}};
  image.bytes.assign(image.row_bytes() * static_cast<std::size_t>(image.height), 0x5a);
  const auto pixel_bytes =
      static_cast<std::size_t>(channel_count(whole.format) * bytes_per_channel(whole.format));
  for (const Part& part : parts_of(cut, whole.width, whole.height)) {
    std::uint8_t* pixels = image.bytes.data() +
                           static_cast<std::size_t>(part.y) * image.row_bytes() +
                           static_cast<std::size_t>(part.x) * pixel_bytes;
    const Status status = paint(part, pixels, image.row_bytes());
    EXPECT_TRUE(status.ok()) << status.message;
  }
  return image;
}

inline RasterOptions window_options(const RasterOptions& whole, const Part& part) {
  RasterOptions options = whole;
  options.width = part.width;
  options.height = part.height;
  options.window = RasterWindow{part.x, part.y, whole.width, whole.height};
  return options;
}

/// Paints every window separately.
inline Image painted_in_windows(Context& context, const Picture& picture,
                                const RasterOptions& whole, const Cut& cut) {
  return joined(whole, cut, [&](const Part& part, std::uint8_t* pixels, std::size_t row_bytes) {
    return rasterize_into(context, picture, window_options(whole, part), pixels, row_bytes);
  });
}

/// Paints all windows of a picture that was prepared once.
inline Image painted_prepared(Context& context, const Picture& picture, const RasterOptions& whole,
                              const Cut& cut) {
  const Result<PreparedRaster> prepared = PreparedRaster::create(context, picture, whole);
  EXPECT_TRUE(prepared.ok()) << prepared.status().message;
  if (!prepared) return {};
  return joined(whole, cut, [&](const Part& part, std::uint8_t* pixels, std::size_t row_bytes) {
    return prepared->paint(context, part.x, part.y, part.width, part.height, pixels, row_bytes);
  });
}

/// Expects equal bytes.
inline void expect_same_pixels(const Image& found, const Image& expected,
                               const std::string& where) {
  ASSERT_EQ(found.bytes.size(), expected.bytes.size()) << where;
  std::size_t count = 0, first = 0;
  for (std::size_t i = found.bytes.size(); i-- > 0;) {
    if (found.bytes[i] == expected.bytes[i]) continue;
    ++count;
    first = i;
  }
  const std::size_t row = expected.row_bytes();
  const std::size_t pixel = row / static_cast<std::size_t>(expected.width);
  EXPECT_EQ(count, 0u) << where << ": of " << found.bytes.size() << " bytes; the first at ("
                       << first % row / pixel << ", " << first / row << "), "
                       << int{found.bytes[first]} << " for " << int{expected.bytes[first]};
}

}  // namespace sfumato::test
