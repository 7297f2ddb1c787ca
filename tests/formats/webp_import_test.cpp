#include "codecs/webp/webp_import.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "sfumato/base/native/thread_pool.hpp"

/// Compares the picture that libwebp receives in parts with the one that it makes from the whole.
namespace sfumato {
namespace {

struct Webp {
  WebPPicture picture{};

  explicit Webp(const Image& image) {
    WebPPictureInit(&picture);
    picture.width = image.width;
    picture.height = image.height;
  }
  ~Webp() { WebPPictureFree(&picture); }
  Webp(const Webp&) = delete;
  Webp& operator=(const Webp&) = delete;
};

/// Returns all planes, row by row.
std::vector<std::uint8_t> planes(const WebPPicture& picture) {
  std::vector<std::uint8_t> all;
  const auto append = [&all](const std::uint8_t* plane, int stride, int width, int height) {
    for (int y = 0; plane && y < height; ++y) {
      all.insert(all.end(), plane + std::ptrdiff_t{stride} * y,
                 plane + std::ptrdiff_t{stride} * y + width);
    }
  };
  const int half_width = (picture.width + 1) / 2, half_height = (picture.height + 1) / 2;
  append(picture.y, picture.y_stride, picture.width, picture.height);
  append(picture.u, picture.uv_stride, half_width, half_height);
  append(picture.v, picture.uv_stride, half_width, half_height);
  append(picture.a, picture.a_stride, picture.width, picture.height);
  return all;
}

std::vector<std::uint8_t> in_parts(Context& context, const Image& image) {
  Webp webp(image);
  const Status status = codecs::import_yuv(context, image, webp.picture);
  EXPECT_TRUE(status.ok()) << status.message;
  return planes(webp.picture);
}

std::vector<std::uint8_t> as_one(const Image& image) {
  Webp webp(image);
  webp.picture.use_argb = 1;
  const int stride = static_cast<int>(image.row_bytes());
  EXPECT_TRUE(channel_count(image.format) == 4
                  ? WebPPictureImportRGBA(&webp.picture, image.bytes.data(), stride)
                  : WebPPictureImportRGB(&webp.picture, image.bytes.data(), stride));
  EXPECT_TRUE(WebPPictureSharpARGBToYUVA(&webp.picture));
  return planes(webp.picture);
}

/// Returns rings of saturated colours, the worst case for half-sized chroma, over a gradient, with
/// alpha in one corner.
Image rings(int width, int height, PixelFormat format) {
  Image image{width, height, format, {}};
  image.bytes.resize(image.row_bytes() * static_cast<std::size_t>(height));
  const auto channels = static_cast<std::size_t>(channel_count(format));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      std::uint8_t* pixel = &image.bytes[channels * (static_cast<std::size_t>(y) * width + x)];
      const bool is_red = static_cast<int>(std::hypot(x - 500, y - 500) / 23) % 2 == 0;
      pixel[0] = is_red ? 255 : 0;
      pixel[1] = static_cast<std::uint8_t>(is_red ? 255 * x / width : 200);
      pixel[2] = static_cast<std::uint8_t>(255 * y / height);
      if (channels == 4) pixel[3] = x + y < 300 ? 128 : 255;
    }
  }
  return image;
}

struct Difference {
  int largest = 0;
  double mean = 0;
};

Difference difference(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
  Difference found;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const int step = std::abs(int{a[i]} - int{b[i]});
    found.largest = std::max(found.largest, step);
    found.mean += step / static_cast<double>(a.size());
  }
  return found;
}

TEST(WebpImport, an_image_of_one_part_is_what_libwebp_makes_of_it) {
  Context context;
  for (const PixelFormat format : {PixelFormat::rgb8, PixelFormat::rgba8}) {
    for (const int side : {1, 2, 3, 7, 512}) {
      const Image image = rings(side, side, format);
      EXPECT_EQ(in_parts(context, image), as_one(image)) << side;
    }
  }
}

TEST(WebpImport, an_image_of_many_parts_is_that_to_a_code_value) {
  Context context;
  for (const PixelFormat format : {PixelFormat::rgb8, PixelFormat::rgba8}) {
    const Image image = rings(1601, 1033, format);
    const auto parts = in_parts(context, image), whole = as_one(image);
    ASSERT_EQ(parts.size(), whole.size());
    const Difference found = difference(parts, whole);
    EXPECT_LE(found.largest, 1);
    EXPECT_LT(found.mean, 1e-3);
  }
}

TEST(WebpImport, the_bits_do_not_depend_on_the_threads) {
  const Image image = rings(1601, 1033, PixelFormat::rgba8);
  Context alone;
  const auto expected = in_parts(alone, image);
  for (const int threads : {2, 5}) {
    ThreadPool executor(threads);
    Context context{.executor = &executor};
    EXPECT_EQ(in_parts(context, image), expected) << threads;
  }
}

}  // namespace
}  // namespace sfumato
