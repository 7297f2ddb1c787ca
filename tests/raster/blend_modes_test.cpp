#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "raster/pictures.hpp"
#include "raster/support.hpp"

namespace sfumato::test {
namespace {

using Color = std::array<double, 3>;

// The formulas of W3C Compositing and Blending Level 1, in its notation.

double screen(double b, double s) {
  return b + s - b * s;
}

double hard_light(double b, double s) {
  return s <= 0.5 ? b * 2 * s : screen(b, 2 * s - 1);
}

double color_dodge(double b, double s) {
  if (b == 0) return 0;
  return s == 1 ? 1 : std::min(1.0, b / (1 - s));
}

double color_burn(double b, double s) {
  if (b == 1) return 1;
  return s == 0 ? 0 : 1 - std::min(1.0, (1 - b) / s);
}

double soft_light(double b, double s) {
  if (s <= 0.5) return b - (1 - 2 * s) * b * (1 - b);
  const double d = b <= 0.25 ? ((16 * b - 12) * b + 4) * b : std::sqrt(b);
  return b + (2 * s - 1) * (d - b);
}

double lum(const Color& c) {
  return 0.3 * c[0] + 0.59 * c[1] + 0.11 * c[2];
}

double sat(const Color& c) {
  return *std::max_element(c.begin(), c.end()) - *std::min_element(c.begin(), c.end());
}

Color clip_color(Color c) {
  const double l = lum(c);
  const double n = *std::min_element(c.begin(), c.end());
  const double x = *std::max_element(c.begin(), c.end());
  for (double& v : c) {
    if (n < 0) v = l + (v - l) * l / (l - n);
    if (x > 1) v = l + (v - l) * (1 - l) / (x - l);
  }
  return c;
}

Color set_lum(Color c, double l) {
  const double d = l - lum(c);
  for (double& v : c) v += d;
  return clip_color(c);
}

Color set_sat(Color c, double s) {
  std::array<int, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(), [&](int i, int j) { return c[i] < c[j]; });
  double &low = c[order[0]], &middle = c[order[1]], &high = c[order[2]];
  if (high > low) {
    middle = (middle - low) * s / (high - low);
    high = s;
  } else {
    middle = high = 0;
  }
  low = 0;
  return c;
}

Color blend(BlendMode mode, const Color& b, const Color& s) {
  const auto each = [&](const auto& f) {
    return Color{f(b[0], s[0]), f(b[1], s[1]), f(b[2], s[2])};
  };
  switch (mode) {
    case BlendMode::normal:
      return s;
    case BlendMode::multiply:
      return each([](double x, double y) { return x * y; });
    case BlendMode::screen:
      return each(screen);
    case BlendMode::overlay:
      return each([](double x, double y) { return hard_light(y, x); });
    case BlendMode::darken:
      return each([](double x, double y) { return std::min(x, y); });
    case BlendMode::lighten:
      return each([](double x, double y) { return std::max(x, y); });
    case BlendMode::color_dodge:
      return each(color_dodge);
    case BlendMode::color_burn:
      return each(color_burn);
    case BlendMode::hard_light:
      return each(hard_light);
    case BlendMode::soft_light:
      return each(soft_light);
    case BlendMode::difference:
      return each([](double x, double y) { return std::fabs(x - y); });
    case BlendMode::exclusion:
      return each([](double x, double y) { return x + y - 2 * x * y; });
    case BlendMode::hue:
      return set_lum(set_sat(s, sat(b)), lum(b));
    case BlendMode::saturation:
      return set_lum(set_sat(b, sat(s)), lum(b));
    case BlendMode::color:
      return set_lum(s, lum(b));
    case BlendMode::luminosity:
      return set_lum(b, lum(s));
  }
  return s;
}

constexpr Rgb kColors[] = {{0, 0, 0},           {1, 1, 1},           {0.2f, 0.9f, 0.5f},
                           {0.7f, 0.1f, 0.05f}, {0.25f, 0.5f, 0.5f}, {1, 0, 0.6f}};

Color color_of(const Rgb& c) {
  return {c.r, c.g, c.b};
}

/// Returns a pixel of `top` blended onto a backdrop of one colour and alpha; rgba16, steps.
std::array<int, 4> blended_pixel(BlendMode mode, const Rgb& backdrop, float backdrop_alpha,
                                 const Rgb& source, float source_alpha) {
  const Box box{{0, 0}, {8, 8}};
  Picture picture = make_picture(flat_layer(box, backdrop, backdrop_alpha));
  picture.layers.push_back(flat_layer(box, source));
  picture.stack.push_back(PatchInstance{1, {}, source_alpha, mode});
  const Image image = rasterized(picture, image_size(3, 3, PixelFormat::rgba16));
  return {channel(image, 1, 1, 0), channel(image, 1, 1, 1), channel(image, 1, 1, 2),
          channel(image, 1, 1, 3)};
}

/// Returns co of "simple alpha compositing" with blending, not premultiplied.
std::array<double, 4> expected_pixel(BlendMode mode, const Rgb& backdrop, double ab,
                                     const Rgb& source, double as) {
  const Color b = color_of(backdrop), s = color_of(source), mixed = blend(mode, b, s);
  const double alpha = as + ab * (1 - as);
  std::array<double, 4> pixel{0, 0, 0, alpha};
  for (int c = 0; c < 3 && alpha > 0; ++c) {
    pixel[c] = (as * ((1 - ab) * s[c] + ab * mixed[c]) + (1 - as) * ab * b[c]) / alpha;
  }
  return pixel;
}

TEST(RasterBlendModes, every_mode_follows_its_formula) {
  for (int mode = 0; mode <= static_cast<int>(BlendMode::luminosity); ++mode) {
    for (const Rgb& backdrop : kColors) {
      for (const Rgb& source : kColors) {
        for (const auto& [ab, as] : {std::pair{1.0f, 1.0f}, {1.0f, 0.6f}, {0.5f, 0.25f}}) {
          const BlendMode blend_mode = static_cast<BlendMode>(mode);
          const auto pixel = blended_pixel(blend_mode, backdrop, ab, source, as);
          const auto expected = expected_pixel(blend_mode, backdrop, ab, source, as);
          for (int c = 0; c < 4; ++c)
            ASSERT_NEAR(pixel[c], 65535 * expected[c], 2) << "mode " << mode << " channel " << c;
        }
      }
    }
  }
}

TEST(RasterBlendModes, a_source_without_a_backdrop_is_itself_in_every_mode) {
  for (int mode = 0; mode <= static_cast<int>(BlendMode::luminosity); ++mode) {
    const auto pixel =
        blended_pixel(static_cast<BlendMode>(mode), {0.1f, 0.2f, 0.3f}, 0, {0.8f, 0.4f, 0}, 0.5f);
    EXPECT_NEAR(pixel[0], 65535 * 0.8, 1);
    EXPECT_NEAR(pixel[1], 65535 * 0.4, 1);
    EXPECT_EQ(pixel[2], 0);
    EXPECT_NEAR(pixel[3], 65535 * 0.5, 1);
  }
}

TEST(RasterBlendModes, a_backdrop_beyond_the_range_is_clamped_first) {
  const Box box{{0, 0}, {8, 8}};
  Picture picture = make_picture(flat_layer(box, {1.5f, -0.5f, 0.5f}));
  picture.layers.push_back(flat_layer(box, {0.5f, 0.5f, 0.5f}));
  picture.stack.push_back(PatchInstance{1, {}, 1, BlendMode::difference});
  const Image image = rasterized(picture, image_size(3, 3));
  EXPECT_NEAR(channel(image, 1, 1, 0), 65535 * 0.5, 1);
  EXPECT_NEAR(channel(image, 1, 1, 1), 65535 * 0.5, 1);
  EXPECT_EQ(channel(image, 1, 1, 2), 0);
}

}  // namespace
}  // namespace sfumato::test
