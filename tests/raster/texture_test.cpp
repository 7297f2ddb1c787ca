#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "raster/shaders/texture_filter.hpp"
#include "raster/shaders/texture_pyramid.hpp"

namespace sfumato::test {
namespace {

using raster::TexturePyramid;
using Sample = std::array<float, 4>;
using Texel = std::array<std::uint8_t, 4>;

Texture make_texture(int width, int height, const std::function<Texel(int, int)>& texel) {
  Texture texture;
  texture.width = width;
  texture.height = height;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (std::uint8_t v : texel(x, y)) texture.rgba.push_back(v);
    }
  }
  return texture;
}

Texel noise(int x, int y) {
  std::uint32_t h =
      static_cast<std::uint32_t>(x) * 374761393u + static_cast<std::uint32_t>(y) * 668265263u;
  h = (h ^ (h >> 13)) * 1274126177u;
  h ^= h >> 16;
  return {static_cast<std::uint8_t>(h), static_cast<std::uint8_t>(h >> 8),
          static_cast<std::uint8_t>(h >> 16), 255};
}

Texel checkerboard(int x, int y) {
  const std::uint8_t v = (x + y) % 2 ? 255 : 0;
  return {v, v, v, 255};
}

TexturePyramid pyramid_of(const Texture& texture, SimdLevel level = detected_simd_level()) {
  static Context context;  // must outlive the tables charged to it
  context.simd = level;
  Result<TexturePyramid> pyramid = TexturePyramid::create(context, texture);
  EXPECT_TRUE(pyramid.ok()) << to_string(pyramid.status());
  return std::move(*pyramid);
}

/// Returns pixels of an image's row, centres at (x + 1/2, y + 1/2).
std::vector<Sample> row_of(const TexturePyramid& pyramid, const Affine& layer_from_image, double x,
                           double y, int count) {
  std::vector<float> plane[4];
  for (auto& values : plane) values.resize(static_cast<std::size_t>(count));
  evaluate_texture(pyramid, layer_from_image, {x + 0.5, y + 0.5}, count,
                   {plane[0].data(), plane[1].data(), plane[2].data(), plane[3].data()});
  std::vector<Sample> samples(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < samples.size(); ++i) {
    for (std::size_t c = 0; c < 4; ++c) samples[i][c] = plane[c][i];
  }
  return samples;
}

Sample sample(const TexturePyramid& pyramid, const Affine& layer_from_image, double x, double y) {
  return row_of(pyramid, layer_from_image, x, y, 1).front();
}

void expect_texel(const Sample& actual, const Texel& expected, double tolerance = 1e-6) {
  for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(actual[c], expected[c] / 255.0, tolerance);
}

TEST(TextureFilter, pixels_on_texels_are_the_texels) {
  const TexturePyramid pyramid = pyramid_of(make_texture(13, 7, noise));
  for (int y = 0; y < 7; ++y) {
    const std::vector<Sample> row = row_of(pyramid, {}, 0, y, 13);
    for (int x = 0; x < 13; ++x) expect_texel(row[static_cast<std::size_t>(x)], noise(x, y));
  }
}

TEST(TextureFilter, a_turned_and_mirrored_texture_has_its_texels_still) {
  const TexturePyramid pyramid = pyramid_of(make_texture(13, 7, noise));
  for (int y = 0; y < 7; ++y) {
    for (int x = 0; x < 13; ++x) {
      expect_texel(sample(pyramid, {0, 1, 1, 0, 0, 0}, y, x), noise(x, y), 1e-5);
      expect_texel(sample(pyramid, {-1, 0, 0, 1, 13, 0}, 12 - x, y), noise(x, y), 1e-5);
    }
  }
}

TEST(TextureFilter, the_texels_of_a_half_transparent_texture_come_back_too) {
  const auto glass = [](int x, int y) {
    Texel texel = noise(x, y);
    texel[3] = static_cast<std::uint8_t>(1 + (37 * x + 11 * y) % 255);
    return texel;
  };
  const TexturePyramid pyramid = pyramid_of(make_texture(16, 16, glass));
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) {
      const Texel texel = glass(x, y);
      // A step of 1/65535 of the premultiplied colour.
      expect_texel(sample(pyramid, {}, x, y), texel, 1e-6 + 0.51 / (257.0 * texel[3]));
    }
  }
}

TEST(TextureFilter, transparent_texels_do_not_colour_their_neighbours) {
  const TexturePyramid pyramid = pyramid_of(make_texture(8, 8, [](int x, int) {
    return x < 4 ? Texel{255, 0, 0, 255} : Texel{0, 255, 0, 0};
  }));
  for (double scale : {0.1, 0.37, 1.7, 3.0}) {
    for (double x = 0; x < 6 / scale; x += 0.3) {
      const Sample s = sample(pyramid, {scale, 0, 0, scale, 0, 0}, x, 3);
      EXPECT_NEAR(s[1], 0, 1e-6);
      EXPECT_TRUE(s[3] <= 0.001f || s[0] > 0.999f);
    }
  }
}

TEST(TextureFilter, magnified_it_does_not_overshoot) {
  const TexturePyramid pyramid = pyramid_of(make_texture(8, 8, [](int x, int) {
    return x < 4 ? Texel{64, 64, 64, 255} : Texel{192, 192, 192, 255};
  }));
  float before = 0;
  for (double x = 10; x < 70; ++x) {
    const float v = sample(pyramid, {0.1, 0, 0, 0.1, 0, 0}, x, 40)[0];
    EXPECT_GE(v, 64 / 255.0f - 1e-6f);
    EXPECT_LE(v, 192 / 255.0f + 1e-6f);
    EXPECT_GE(v, before - 1e-6f);
    before = v;
  }
}

TEST(TextureFilter, a_constant_texture_is_constant_at_every_scale) {
  const TexturePyramid pyramid = pyramid_of(make_texture(19, 5, [](int, int) {
    return Texel{51, 102, 153, 204};
  }));
  for (const Affine& map : {Affine{0.1, 0.02, 0, 0.3, 4, 5}, Affine{1.3, 0.4, -0.3, 2.2, -7, 1},
                            Affine{40, 1, 3, 0.1, 2, 2}, Affine{1e6, 0, 0, 1e6, 0, 0}}) {
    for (const Sample& s : row_of(pyramid, map, -20, 3, 40)) {
      expect_texel(s, {51, 102, 153, 204}, 2e-4);
    }
  }
}

TEST(TextureFilter, it_repeats_with_its_size_seamlessly) {
  const TexturePyramid pyramid = pyramid_of(make_texture(12, 10, noise));
  for (double scale : {0.3, 0.9, 1.4, 2.6, 5.5}) {
    const Affine map{scale, 0.1 * scale, -0.2 * scale, scale, 0.7, 0.2};
    Affine shifted = map;
    shifted.e += 12 * 3;
    shifted.f -= 10 * 2;
    for (int y = 0; y < 6; ++y) {
      const std::vector<Sample> here = row_of(pyramid, map, -10, y, 30);
      const std::vector<Sample> there = row_of(pyramid, shifted, -10, y, 30);
      for (std::size_t i = 0; i < here.size(); ++i) {
        for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(here[i][c], there[i][c], 1e-4);
      }
    }
  }
}

TEST(TextureFilter, a_texture_that_does_not_repeat_goes_on_as_its_edges) {
  Texture texture = make_texture(6, 4, noise);
  texture.repeats = false;
  const TexturePyramid pyramid = pyramid_of(texture);
  expect_texel(sample(pyramid, {}, -100, 2), noise(0, 2));
  expect_texel(sample(pyramid, {}, 1e9, 2), noise(5, 2));
  expect_texel(sample(pyramid, {}, 3, -9), noise(3, 0));
  expect_texel(sample(pyramid, {}, -3, 70), noise(0, 3));
}

TEST(TextureFilter, a_gap_between_repeats_shows_the_nearest_edge_and_a_short_period_cuts) {
  Texture texture = make_texture(6, 4, noise);
  texture.period = {9, 3};
  const TexturePyramid pyramid = pyramid_of(texture);
  for (int y = -6; y < 9; ++y) {
    for (int x = -18; x < 27; ++x) {
      const int column = std::min((x + 18) % 9, 5), row = (y + 6) % 3;
      expect_texel(sample(pyramid, {}, x, y), noise(column, row));
    }
  }
}

/// Returns the mean of a repeating tile of `noise`.
double tile_mean(const Texture& texture, int channel) {
  const int width = texture.period.x > 0 ? static_cast<int>(texture.period.x) : texture.width;
  const int height = texture.period.y > 0 ? static_cast<int>(texture.period.y) : texture.height;
  double sum = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      sum += noise(std::min(x, texture.width - 1),
                   std::min(y, texture.height - 1))[static_cast<std::size_t>(channel)];
    }
  }
  return sum / (255.0 * width * height);
}

TEST(TextureFilter, far_away_a_repeating_texture_is_its_mean) {
  for (const Vec2 period : {Vec2{}, Vec2{21, 40}, Vec2{10, 9}}) {
    Texture texture = make_texture(16, 23, noise);
    texture.period = period;
    const TexturePyramid pyramid = pyramid_of(texture);
    for (double scale : {200.0, 1e4, 1e7}) {
      const Sample s = sample(pyramid, {scale, 0, 0, scale, 0, 0}, 3, 8);
      for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(s[static_cast<std::size_t>(c)], tile_mean(texture, c), 2e-3);
      }
    }
  }
}

TEST(TextureFilter, a_minified_checkerboard_is_even_grey) {
  const TexturePyramid pyramid = pyramid_of(make_texture(64, 64, checkerboard));
  const double c = std::cos(0.5), s = std::sin(0.5);
  for (const Affine& map :
       {Affine{2, 0, 0, 2, 0.1, 0.2}, Affine{3.3, 0, 0, 3.3, 0, 0},
        Affine{7.9, 0.3, -0.3, 7.9, 0, 0}, Affine{12.3, 0, 0, 2, 0, 0}, Affine{2, 0, 0, 31, 0, 0},
        Affine{16 * c, 16 * s, -2 * s, 2 * c, 0, 0}, Affine{900, 0, 0, 900, 0, 0}}) {
    double sum = 0, squares = 0;
    for (int y = 0; y < 50; ++y) {
      for (const Sample& sample : row_of(pyramid, map, 0, y, 50)) {
        sum += sample[0] - 0.5;
        squares += (sample[0] - 0.5) * (sample[0] - 0.5);
      }
    }
    EXPECT_NEAR(sum / 2500, 0, 1e-3);
    EXPECT_LT(std::sqrt(squares / 2500), 0.012) << map.a << ' ' << map.d;
  }
}

TEST(TextureFilter, minified_along_one_axis_it_stays_sharp_along_the_other) {
  const auto stripes = [](int, int y) {
    return y % 2 ? Texel{255, 255, 255, 255} : Texel{0, 0, 0, 255};
  };
  const TexturePyramid pyramid = pyramid_of(make_texture(64, 64, stripes));
  const Affine map{15, 0, 0, 1, 0, 0};
  EXPECT_NEAR(sample(pyramid, map, 1, 3)[0], 1, 1e-4);
  EXPECT_NEAR(sample(pyramid, map, 1, 4)[0], 0, 1e-4);
}

/// Returns the tent over the texels, one by one; the texture repeats and the map does not mirror.
double tent_over_texels(const Texture& texture, const Affine& texture_from_image, Vec2 pixel) {
  const Affine& map = texture_from_image;
  const Affine image_from_texture = inverse(map);
  const Vec2 middle = map(pixel);
  const Vec2 reach{std::abs(map.a) + std::abs(map.c), std::abs(map.b) + std::abs(map.d)};
  double sum = 0, total = 0;
  for (double y = std::floor(middle.y - reach.y); y <= middle.y + reach.y; ++y) {
    for (double x = std::floor(middle.x - reach.x); x <= middle.x + reach.x; ++x) {
      const Vec2 d = image_from_texture({x + 0.5, y + 0.5}) - pixel;
      const double weight = std::max(0.0, 1 - std::abs(d.x)) * std::max(0.0, 1 - std::abs(d.y));
      const auto column =
          static_cast<std::size_t>(x - texture.width * std::floor(x / texture.width));
      const auto row =
          static_cast<std::size_t>(y - texture.height * std::floor(y / texture.height));
      sum += weight * texture.rgba[4 * (row * static_cast<std::size_t>(texture.width) + column)];
      total += weight;
    }
  }
  return sum / total;
}

TEST(TextureFilter, every_level_shows_what_the_texels_show) {
  const auto black_and_white = [](int x, int y) {
    const std::uint8_t v = noise(x, y)[0] < 128 ? 0 : 255;
    return Texel{v, v, v, 255};
  };
  Texture texture = make_texture(256, 256, black_and_white);
  texture.repeats = true;
  const TexturePyramid pyramid = pyramid_of(texture);
  for (const double ratio : {1.0, 3.0, 10.0}) {
    for (double scale = 1.05; scale * ratio < 100; scale *= 1.23) {
      for (const double angle : {0.0, 0.6}) {
        const double c = std::cos(angle), s = std::sin(angle);
        const Affine map{ratio * scale * c, ratio * scale * s, -scale * s, scale * c, 3.3, 7.7};
        const std::vector<Sample> row = row_of(pyramid, map, 0, 1, 24);
        for (int x = 0; x < 24; x += 3) {
          const double exact = tent_over_texels(texture, map, {x + 0.5, 1.5});
          EXPECT_NEAR(255 * row[static_cast<std::size_t>(x)][0], exact, 2)
              << ratio << " " << scale << " " << angle << " at " << x;
        }
      }
    }
  }
}

TEST(TextureFilter, every_instruction_set_gives_the_same_bits) {
  Texture texture = make_texture(37, 21, noise);
  texture.rgba[3] = 7;
  const TexturePyramid base = pyramid_of(texture, SimdLevel::sse2);
  for (SimdLevel level : {SimdLevel::avx2, SimdLevel::avx512}) {
    if (level > detected_simd_level()) GTEST_SKIP() << "no such instruction set here";
    const TexturePyramid other = pyramid_of(texture, level);
    for (const Affine& map : {Affine{0.3, 0.1, -0.2, 0.3, 1, 2}, Affine{2.3, 0.4, -0.3, 1.2, -7, 1},
                              Affine{17, 1, 0, 1, 0, 0}}) {
      EXPECT_EQ(row_of(base, map, -30, 2, 100), row_of(other, map, -30, 2, 100));
    }
  }
}

TEST(TextureFilter, extreme_maps_and_periods_give_finite_colours) {
  Texture wide = make_texture(3, 2, noise), thin = wide, fraction = wide;
  wide.period = {1e7, 1e7};
  thin.period = {1e-7, 1e7};
  fraction.period = {2.3, 1.7};
  Texture single = make_texture(1, 1, noise);
  for (const Texture& texture : {wide, thin, fraction, single}) {
    const TexturePyramid pyramid = pyramid_of(texture);
    for (double scale : {1e-300, 1e-6, 0.7, 13.0, 1e9, 1e300}) {
      for (const Affine& map :
           {Affine{scale, 0, 0, scale, 1e7, -1e7}, Affine{scale, 0, scale, 1, 0, 0}}) {
        for (const Sample& s : row_of(pyramid, map, -3, 5, 7)) {
          for (float v : s) EXPECT_TRUE(v >= 0 && v <= 1) << v;
        }
      }
    }
  }
}

TEST(TexturePyramid, its_memory_is_charged_and_given_back) {
  Context context;
  {
    const Result<TexturePyramid> pyramid =
        TexturePyramid::create(context, make_texture(64, 64, noise));
    ASSERT_TRUE(pyramid.ok());
    EXPECT_GE(context.budget.used(), std::size_t{64 * 64 * 8});
    EXPECT_LT(context.budget.used(), std::size_t{64 * 64 * 11});
  }
  EXPECT_EQ(context.budget.used(), 0u);
}

TEST(TexturePyramid, a_budget_that_is_too_small_is_a_limit_error) {
  Context context{.budget = Budget(1000)};
  const Result<TexturePyramid> pyramid =
      TexturePyramid::create(context, make_texture(64, 64, noise));
  EXPECT_EQ(pyramid.status().code, StatusCode::limit);
  EXPECT_EQ(context.budget.used(), 0u);
}

}  // namespace
}  // namespace sfumato::test
