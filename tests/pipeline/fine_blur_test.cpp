// Blurs of up to two pixels, from document to pixels: each pixel shows the mean of the exact
// picture over its square, and outlines change continuously with the radius.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "raster/support.hpp"
#include "sfumato/api/render_pixels.hpp"
#include "sfumato/raster/rasterize.hpp"
#include "sfumato/solve/diffuse.hpp"
#include "support/drawing.hpp"

namespace sfumato::test {
namespace {

constexpr int kSide = 12;
constexpr int kSamples = 16;  ///< of the reference, per pixel side
constexpr double kBound = 4;  ///< code values
constexpr double kCornerBound = 7;

using MakeDocument = std::function<Document(float radius)>;

/// Code values of all pixels' channels, premultiplied.
using Values = std::vector<double>;

/// Returns means over squares of `samples`² pixels.
Values means(const Image& image, int samples) {
  Values values;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      double sum[4] = {};
      for (int i = 0; i < samples * samples; ++i) {
        const int px = x * samples + i % samples, py = y * samples + i / samples;
        const double alpha = code_value(image, px, py, 3) / 255;
        for (int c = 0; c < 3; ++c) sum[c] += alpha * code_value(image, px, py, c);
        sum[3] += 255 * alpha;
      }
      for (double channel : sum) values.push_back(channel / (samples * samples));
    }
  }
  return values;
}

Values drawn(const Document& document) {
  Context context;
  const Result<Picture> picture = diffuse(context, document, {});
  EXPECT_TRUE(picture.ok());
  return means(rasterized(*picture, image_size(kSide, kSide, PixelFormat::rgba16)), 1);
}

Values exact(const Document& document) {
  Context context;
  DiffuseOptions options;
  options.pixels_per_unit = kSamples;
  RasterOptions size = image_size(kSide * kSamples, kSide * kSamples, PixelFormat::rgba16);
  size.antialias = false;
  const Result<Image> image = render_pixels(context, document, options, size);
  EXPECT_TRUE(image.ok());
  return means(*image, kSamples);
}

std::size_t worst_index(const Values& a, const Values& b) {
  std::size_t worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (std::fabs(a[i] - b[i]) > std::fabs(a[worst] - b[worst])) worst = i;
  return worst;
}

/// Expects, for R from 0 to 2 pixels, the mean over the pixel, and no jumps beyond the exact
/// picture's.
void expect_means(const std::string& name, const MakeDocument& make, double bound = kBound) {
  double worst_miss = 0, worst_jump = 0, at_miss = 0, at_jump = 0;
  Values miss_before;
  std::size_t pixel = 0;
  for (int step = 0; step <= 40; ++step) {
    const float radius = 0.05f * static_cast<float>(step);
    const Document document = make(radius);
    const Values is = drawn(document), expected = exact(document);
    const std::size_t i = worst_index(is, expected);
    if (const double off = std::fabs(is[i] - expected[i]); off > worst_miss)
      worst_miss = off, at_miss = radius, pixel = i;
    Values miss(is.size());
    for (std::size_t k = 0; k < is.size(); ++k) miss[k] = is[k] - expected[k];
    if (step > 0) {
      const std::size_t k = worst_index(miss, miss_before);
      if (const double jump = std::fabs(miss[k] - miss_before[k]); jump > worst_jump)
        worst_jump = jump, at_jump = radius;
    }
    miss_before = miss;
  }
  EXPECT_LE(worst_miss, bound) << name << " at R = " << at_miss << ", pixel (" << pixel / 4 % kSide
                               << ", " << pixel / 4 / kSide << ")";
  EXPECT_LE(worst_jump, bound) << name << " at R = " << at_jump;
}

Document on_artboard(Curve curve) {
  return one_layer({std::move(curve)}, {{0, 0}, {kSide, kSide}});
}

/// Returns an edge through the artboard that reaches beyond it at both ends.
Curve edge(double angle, double offset) {
  const Vec2 along{std::cos(angle), std::sin(angle)};
  const Vec2 middle = Vec2{0.5 * kSide, 0.5 * kSide} + offset * Vec2{-along.y, along.x};
  return colored(straight_curve(middle - 30 * along, middle + 30 * along), kWhite, kBlack);
}

Curve square(Vec2 low, Vec2 high) {
  Curve curve;
  const Vec2 corner[] = {low, {low.x, high.y}, high, {high.x, low.y}, low};
  curve.control_points = {low};
  for (int i = 0; i < 4; ++i)
    for (double t : {1.0 / 3, 2.0 / 3, 1.0})
      curve.control_points.push_back(lerp(corner[i], corner[i + 1], t));
  return curve;
}

TEST(FineBlur, straight_edge_is_the_mean_over_the_pixel) {
  // The level edge lies between samples of the reference; slanted ones cross many rows of them.
  for (double angle : {0.0, 0.3, 0.76, 1.4}) {
    for (double offset : {0.0, 0.1875, 0.5}) {
      expect_means("angle " + std::to_string(angle) + " offset " + std::to_string(offset),
                   [&](float radius) { return on_artboard(blurred(edge(angle, offset), radius)); });
    }
  }
}

TEST(FineBlur, sides_of_different_radii_are_the_mean_over_the_pixel) {
  for (float share : {0.0f, 0.3f, 0.6f}) {
    expect_means("other side's share " + std::to_string(share), [&](float radius) {
      Curve curve = blurred(edge(0.3, 0.2), radius);
      curve.right.blur_radius.stops[0].value *= share;
      return on_artboard(std::move(curve));
    });
  }
}

TEST(FineBlur, radius_that_grows_along_an_edge_is_the_mean_over_the_pixel) {
  expect_means("growing", [](float radius) {
    Curve curve = edge(0.3, 0.2);
    curve.left.blur_radius = {StopSpace::parameter, {{0.4, 0.0f}, {0.6, radius}}};
    curve.right.blur_radius = curve.left.blur_radius;
    return on_artboard(std::move(curve));
  });
}

TEST(FineBlur, circle_is_the_mean_over_the_pixel) {
  expect_means("circle", [](float radius) {
    return on_artboard(blurred(colored(circle_curve({5.8, 6.1}, 4), kWhite, kBlack), radius));
  });
}

TEST(FineBlur, corners_are_near_the_mean_over_the_pixel) {
  const Curve outline = colored(square({2.6875, 2.375}, {9.125, 9.3125}), kWhite, kBlack);
  expect_means(
      "square", [&](float radius) { return on_artboard(blurred(outline, radius)); }, kCornerBound);
}

TEST(FineBlur, opacity_is_the_mean_over_the_pixel) {
  expect_means("opacity", [](float radius) {
    return on_artboard(blurred(with_opacity(edge(0.3, 0.2), 1, 0), radius));
  });
  expect_means("opacity of one colour", [](float radius) {
    Curve curve = colored(edge(0.3, 0.2), kRed, kRed);
    return on_artboard(blurred(with_opacity(std::move(curve), 1, 0.2f), radius));
  });
}

}  // namespace
}  // namespace sfumato::test
