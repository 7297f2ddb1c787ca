// The border of a layer beside nothing: its alpha is the area of each pixel that its triangles
// cover.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>
#include <vector>

#include "raster/pictures.hpp"
#include "raster/reference.hpp"
#include "raster/support.hpp"

namespace sfumato::test {
namespace {

constexpr int kOutlinesSide = 64;
const Box kOutlinesBox{{0, 0}, {kOutlinesSide, kOutlinesSide}};
const Rgb kDarkRed{0.8f, 0, 0.1f};

struct Shape {
  std::vector<Vec2> rim;  ///< all of it visible from `center`, in positive direction
  Vec2 center;
};

Shape random_star(std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * (random() / 4294967296.0);
  };
  Shape shape{{}, {uniform(24, 40), uniform(24, 40)}};
  const int count = 5 + static_cast<int>(random() % 9);
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * (i + uniform(0, 0.5)) / count;
    const double radius = uniform(2, 23);
    shape.rim.push_back(shape.center + Vec2{std::cos(angle), std::sin(angle)} * radius);
  }
  return shape;
}

RegionMesh fan(const Shape& shape) {
  RegionMesh mesh;
  mesh.vertex = shape.rim;
  mesh.vertex.push_back(shape.center);
  const auto count = static_cast<std::uint32_t>(shape.rim.size());
  for (std::uint32_t i = 0; i < count; ++i) mesh.add(count, i, (i + 1) % count, 0);
  return mesh;
}

/// Returns a layer of one colour inside the rim, nothing outside; `color` may depend on the point.
PatchLayer shape_layer(const Shape& shape, const ColorField& color) {
  PatchLayer layer = make_layer(fan(shape), color);
  for (std::size_t t = 0; t < layer.triangle_count(); ++t) layer.edge_is_curve[3 * t + 1] = 1;
  layer.frame = {{-kOutlinesSide, -kOutlinesSide}, {2 * kOutlinesSide, 2 * kOutlinesSide}};
  return layer;
}

PatchLayer red_layer(const Shape& shape) {
  return shape_layer(shape, [](int, Vec2) { return kDarkRed; });
}

Picture picture_of(PatchLayer layer, const Affine& map = {}) {
  Picture picture = make_picture(std::move(layer));
  picture.artboard = picture.viewport = kOutlinesBox;
  std::get<PatchInstance>(picture.stack[0]).artboard_from_layer = map;
  return picture;
}

/// Returns the share of a pixel inside the rim.
double exact_area(const Shape& shape, const Affine& map, int x, int y) {
  double area = 0;
  for (std::size_t i = 0; i < shape.rim.size(); ++i) {
    ReferenceTriangle triangle;
    triangle.corner = {map(shape.center), map(shape.rim[i]),
                       map(shape.rim[(i + 1) % shape.rim.size()])};
    const std::vector<Vec2> part = part_in_pixel(triangle, x, y);
    for (std::size_t k = 2; k < part.size(); ++k)
      area += std::fabs(cross(part[k - 1] - part[0], part[k] - part[0]) / 2);
  }
  return area;
}

const Affine kMaps[] = {{},
                        {0.8, 0.6, -0.6, 0.8, 25, -13},
                        {-1, 0, 0, 1, 64.3, 0.2},
                        {0.21, 0, 0, 0.34, 17, 11.5},
                        {3.3, -1.2, 1.4, 2.9, -110, -40}};

TEST(RasterOutlines, alpha_is_the_area_of_random_polygons_in_every_pixel) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    const Shape shape = random_star(seed);
    for (const Affine& map : kMaps) {
      const Image image = rasterized(picture_of(red_layer(shape), map),
                                     image_size(kOutlinesSide, kOutlinesSide, PixelFormat::rgba16));
      for (int y = 0; y < kOutlinesSide; ++y) {
        for (int x = 0; x < kOutlinesSide; ++x) {
          const double area = exact_area(shape, map, x, y);
          ASSERT_NEAR(channel(image, x, y, 3) / 65535.0, area, 2e-4)
              << seed << ' ' << x << ' ' << y;
          if (area > 0.01) {
            ASSERT_NEAR(channel(image, x, y, 0) / 65535.0, kDarkRed.r, 2e-4);
          }
        }
      }
    }
  }
}

TEST(RasterOutlines, a_circle_of_one_colour_has_sixty_levels_of_alpha) {
  Shape circle{{}, {31.71, 32.27}};
  for (int i = 0; i < 400; ++i) {
    const double angle = 2 * std::numbers::pi * i / 400;
    circle.rim.push_back(circle.center + Vec2{std::cos(angle), std::sin(angle)} * 28.3);
  }
  const Image image =
      rasterized(picture_of(red_layer(circle)), image_size(117, 117, PixelFormat::rgba8));
  std::set<int> levels;
  double sum = 0;
  for (int i = 0; i < 117 * 117; ++i) {
    levels.insert(channel(image, i % 117, i / 117, 3));
    sum += channel(image, i % 117, i / 117, 3) / 255.0;
  }
  EXPECT_GE(levels.size(), 60u);
  const double area = 200 * std::sin(2 * std::numbers::pi / 400) * 28.3 * 28.3;
  EXPECT_NEAR(sum * (64.0 / 117) * (64.0 / 117), area, 0.2);
}

TEST(RasterOutlines, what_lies_below_shows_in_the_rest_of_a_pixel) {
  const Shape below = random_star(5), above = random_star(6);
  Picture picture = picture_of(red_layer(below));
  picture.layers.push_back(shape_layer(above, [](int, Vec2) { return Rgb{0, 1, 1}; }));
  picture.stack.push_back(PatchInstance{1, {}, 1, BlendMode::normal});
  RasterOptions options = image_size(kOutlinesSide, kOutlinesSide);
  options.background = Rgb{1, 1, 0};
  const Image image = rasterized(picture, options);
  for (int y = 0; y < kOutlinesSide; ++y) {
    for (int x = 0; x < kOutlinesSide; ++x) {
      const double a = exact_area(below, {}, x, y), b = exact_area(above, {}, x, y);
      const double red = (1 - b) * (a * kDarkRed.r + (1 - a));
      const double green = b + (1 - b) * (1 - a);
      ASSERT_NEAR(channel(image, x, y, 0) / 65535.0, red, 2e-4) << x << ' ' << y;
      ASSERT_NEAR(channel(image, x, y, 1) / 65535.0, green, 2e-4) << x << ' ' << y;
    }
  }
}

TEST(RasterOutlines, a_layer_ends_as_its_opacity_would) {
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    const Shape shape = random_star(seed);
    Picture faded = picture_of(red_layer(shape));
    set_opacity(
        fan(shape), [](int, Vec2) { return 1.0f; }, &faded.layers[0]);
    const RasterOptions options = image_size(90, 90, PixelFormat::rgba16);
    const Image a = rasterized(picture_of(red_layer(shape)), options);
    const Image b = rasterized(faded, options);
    for (int i = 0; i < 90 * 90; ++i) {
      const int x = i % 90, y = i / 90;
      ASSERT_NEAR(channel(a, x, y, 3), channel(b, x, y, 3), 2) << seed;
      if (channel(a, x, y, 3) > 600) {
        ASSERT_NEAR(channel(a, x, y, 0), channel(b, x, y, 0), 40) << seed;
      }
    }
  }
}

TEST(RasterOutlines, a_group_ends_as_what_stands_in_it) {
  const Shape shape = random_star(3);
  Picture grouped = picture_of(red_layer(shape));
  grouped.stack.clear();
  grouped.stack.push_back(GroupBegin{});
  grouped.stack.push_back(PatchInstance{});
  grouped.stack.push_back(GroupEnd{});
  const RasterOptions options = image_size(kOutlinesSide, kOutlinesSide, PixelFormat::rgba8);
  const Image a = rasterized(picture_of(red_layer(shape)), options);
  const Image b = rasterized(grouped, options);
  for (std::size_t i = 0; i < a.bytes.size(); ++i) ASSERT_NEAR(a.bytes[i], b.bytes[i], 1);
}

TEST(RasterOutlines, frames_side_by_side_leave_no_seam) {
  // Two halves meet in the middle of a column of pixels, where curves cross between them.
  const Box left{{-64, -64}, {32.5, 128}}, right{{32.5, -64}, {128, 128}};
  const auto half = [](const Box& box, Vec2 a, Vec2 b) {
    return make_layer(cut_box(box, a, b), [](int region, Vec2) {
      return region ? Rgb{1, 1, 1} : Rgb{0.2f, 0.2f, 0.2f};
    });
  };
  Picture picture = picture_of(half(left, {-64, 10}, {32.5, 40}));
  picture.layers.push_back(half(right, {32.5, 40}, {128, 10}));
  picture.stack.push_back(PatchInstance{1, {}, 1, BlendMode::normal});
  for (int side : {64, 63, 100, 7}) {
    const Image image = rasterized(picture, image_size(side, side, PixelFormat::rgba8));
    for (int i = 0; i < side * side; ++i) ASSERT_EQ(channel(image, i % side, i / side, 3), 255);
  }
}

/// Returns the parts of kOutlinesBox left and right of the line through two points on its upper and
/// lower edge.
Shape half(Vec2 top, Vec2 bottom, bool is_left) {
  const double side = is_left ? -kOutlinesSide : 2 * kOutlinesSide;
  std::vector<Vec2> rim{{side, -kOutlinesSide}, top, bottom, {side, 2 * kOutlinesSide}};
  if (!is_left) std::reverse(rim.begin(), rim.end());
  const Vec2 center = (rim[0] + rim[1] + rim[2] + rim[3]) / 4;
  return {rim, center};
}

TEST(RasterOutlines, layers_that_abut_let_nothing_through) {
  for (const double x : {13.0, 20.5, 31.7, 44.2}) {
    const Vec2 top{x, -kOutlinesSide}, bottom{x + 11, 2 * kOutlinesSide};
    Picture picture = picture_of(red_layer(half(top, bottom, true)));
    picture.layers.push_back(shape_layer(half(top, bottom, false), [](int, Vec2) {
      return Rgb{0.8f, 1, 0.1f};
    }));
    picture.stack.push_back(PatchInstance{1, {}, 1, BlendMode::normal});
    for (int side : {64, 101, 300}) {
      RasterOptions options = image_size(side, side, PixelFormat::rgba8);
      const Image clear = rasterized(picture, options);
      options.background = Rgb{0, 0, 1};
      options.format = PixelFormat::rgb8;
      const Image onto_blue = rasterized(picture, options);
      for (int i = 0; i < side * side; ++i) {
        ASSERT_EQ(channel(clear, i % side, i / side, 3), 255) << i;
        for (int c = 0; c < 3; ++c)
          ASSERT_EQ(channel(clear, i % side, i / side, c),
                    channel(onto_blue, i % side, i / side, c));
        ASSERT_NEAR(channel(clear, i % side, i / side, 2), 26, 1);
      }
    }
  }
}

TEST(RasterOutlines, what_is_painted_between_layers_that_abut_hides_the_lower) {
  const Vec2 top{20.5, -kOutlinesSide}, bottom{31.5, 2 * kOutlinesSide};
  Picture picture = picture_of(red_layer(half(top, bottom, true)));
  picture.layers.push_back(flat_layer({{-1, -1}, {65, 65}}, Rgb{0, 1, 0}));
  picture.layers.push_back(shape_layer(half(top, bottom, false), [](int, Vec2) {
    return Rgb{0, 0, 1};
  }));
  picture.stack.push_back(PatchInstance{1, {}, 1, BlendMode::normal});
  picture.stack.push_back(PatchInstance{2, {}, 1, BlendMode::normal});
  const Image image = rasterized(picture, image_size(90, 90, PixelFormat::rgba8));
  for (int i = 0; i < 90 * 90; ++i) ASSERT_EQ(channel(image, i % 90, i / 90, 0), 0);
}

TEST(RasterOutlines, curves_inside_a_layer_let_nothing_through) {
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    const RegionMesh mesh = jittered_grid(
        kOutlinesBox, 30, seed, [](int column, int row) { return (column * 7 + row * 3) % 5; });
    Picture picture = make_picture(make_layer(mesh, [](int, Vec2) { return kDarkRed; }));
    for (int side : {64, 61, 200}) {
      const Image image = rasterized(picture, image_size(side, side, PixelFormat::rgba16));
      for (int i = 0; i < side * side; ++i) ASSERT_EQ(channel(image, i % side, i / side, 3), 65535);
    }
  }
}

TEST(RasterOutlines, every_instruction_set_gives_the_same_bytes) {
  Picture picture = picture_of(red_layer(random_star(9)), kMaps[1]);
  expect_same_for_every_instruction_set(picture, image_size(150, 97, PixelFormat::rgba16));
  expect_same_for_every_instruction_set(picture, image_size(150, 97, PixelFormat::rgb8));
}

TEST(RasterOutlines, without_antialiasing_pixels_are_all_or_nothing) {
  RasterOptions options = image_size(kOutlinesSide, kOutlinesSide, PixelFormat::rgba8);
  options.antialias = false;
  const Image image = rasterized(picture_of(red_layer(random_star(2))), options);
  for (int i = 0; i < kOutlinesSide * kOutlinesSide; ++i) {
    const int alpha = channel(image, i % kOutlinesSide, i / kOutlinesSide, 3);
    ASSERT_TRUE(alpha == 0 || alpha == 255);
  }
}

}  // namespace
}  // namespace sfumato::test
