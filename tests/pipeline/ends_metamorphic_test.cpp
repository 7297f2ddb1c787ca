// Drawings with many free ends, from the document to pixels: moved, mirrored, rotated, enlarged;
// and with very many ends.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "sfumato/api/render_pixels.hpp"
#include "sfumato/base/native/thread_pool.hpp"
#include "sfumato/raster/rasterize.hpp"
#include "sfumato/solve/diffuse.hpp"
#include "support/drawing.hpp"
#include "support/sanitizers.hpp"

namespace sfumato::test {
namespace {

constexpr int kWidth = 96, kHeight = 64;

/// Returns one bent curve in each square of `cell` units, clear of its neighbours, with both ends
/// free; every fourth is blurred.
Document strokes(int width, int height, int cell) {
  std::mt19937 random(7);
  const auto share = [&] { return static_cast<double>(random() % 4096) / 4096; };
  const auto color = [&] {
    return Rgb{static_cast<float>(share()), static_cast<float>(share()),
               static_cast<float>(share())};
  };
  std::vector<Curve> curves;
  for (int y = 0; y < height; y += cell) {
    for (int x = 0; x < width; x += cell) {
      const auto point = [&](double left) {
        return Vec2{x + cell * (left + 0.2 * share()), y + cell * (0.1 + 0.8 * share())};
      };
      Curve curve;
      for (const double left : {0.1, 0.3, 0.5, 0.7}) curve.control_points.push_back(point(left));
      curve = colored(std::move(curve), color(), color());
      const bool is_blurred = curves.size() % 4 == 3;
      curves.push_back(is_blurred ? blurred(std::move(curve), static_cast<float>(cell) / 8)
                                  : std::move(curve));
    }
  }
  return one_layer(std::move(curves), {{0, 0}, {1.0 * width, 1.0 * height}});
}

/// mirrored: the map swaps the sides. scale: for radii.
template <class Map>
Document mapped(Document document, Map map, bool mirrored = false, float scale = 1) {
  const Vec2 a = map(document.artboard.min), b = map(document.artboard.max);
  document.artboard = {};
  document.artboard.extend(a);
  document.artboard.extend(b);
  for (Curve& curve : document.layers[0].curves) {
    for (Vec2& p : curve.control_points) p = map(p);
    if (mirrored) std::swap(curve.left, curve.right);
    for (Side* side : {&curve.left, &curve.right}) {
      for (Stop<float>& stop : side->blur_radius.stops) stop.value *= scale;
    }
  }
  return document;
}

enum class Way { patches, pixels };

Image drawn(const Document& document, Way way, int width = kWidth, int height = kHeight,
            bool antialias = true) {
  Context context;
  RasterOptions size;
  size.width = width;
  size.height = height;
  size.antialias = antialias;
  DiffuseOptions options;
  options.ends = gather::Ends::soft;
  options.pixels_per_unit = width / document.artboard.width();
  if (way == Way::pixels) {
    size.antialias = false;
    Result<Image> image = render_pixels(context, document, options, size);
    EXPECT_TRUE(image.ok()) << image.status().message;
    return image ? std::move(*image) : Image{};
  }
  const Result<Picture> picture = diffuse(context, document, options);
  EXPECT_TRUE(picture.ok()) << picture.status().message;
  if (!picture) return {};
  Result<Image> image = rasterize(context, *picture, size);
  EXPECT_TRUE(image.ok()) << image.status().message;
  return image ? std::move(*image) : Image{};
}

struct Miss {
  int largest = 0;
  double mean = 0;
};

/// Compares with `other`, whose pixel at place(x, y) shows the content of (x, y) of `image`. Code
/// values.
template <class Place>
Miss miss_of(const Image& image, const Image& other, Place place) {
  Miss miss;
  const std::size_t channels = image.bytes.size() / (std::size_t{kWidth} * kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const auto [u, v] = place(x, y);
      for (std::size_t c = 0; c < channels; ++c) {
        const int here = image.bytes[channels * static_cast<std::size_t>(y * kWidth + x) + c];
        const int there = other.bytes[channels * static_cast<std::size_t>(v * other.width + u) + c];
        miss.largest = std::max(miss.largest, std::abs(here - there));
        miss.mean += std::abs(here - there) / static_cast<double>(image.bytes.size());
      }
    }
  }
  return miss;
}

/// Limits for the difference of pictures, drawn pixel by pixel and from patches.
struct Bounds {
  Miss pixels, patches;
};

/// The same numbers except for the last bits.
constexpr Bounds kSame{{1, 0.01}, {1, 0.01}};

/// Different meshes, each refined to an error of one code value (with the paper's ends 22 and
/// 0.13).
constexpr Bounds kOtherMesh{{1, 0.01}, {8, 0.15}};

template <class Place>
void expect_same(const Document& changed, const Bounds& bounds, Place place, int width = kWidth,
                 int height = kHeight) {
  const Document document = strokes(kWidth, kHeight, 16);
  for (const Way way : {Way::pixels, Way::patches}) {
    const Miss miss = miss_of(drawn(document, way), drawn(changed, way, width, height), place);
    const Miss& most = way == Way::pixels ? bounds.pixels : bounds.patches;
    EXPECT_LE(miss.largest, most.largest);
    EXPECT_LE(miss.mean, most.mean);
  }
}

using Pixel = std::pair<int, int>;

TEST(EndsMetamorphic, a_mirrored_drawing_is_the_mirrored_picture) {
  const auto mirror = [](Vec2 p) { return Vec2{kWidth - p.x, p.y}; };
  expect_same(mapped(strokes(kWidth, kHeight, 16), mirror, true), kOtherMesh, [](int x, int y) {
    return Pixel{kWidth - 1 - x, y};
  });
}

TEST(EndsMetamorphic, a_turned_drawing_is_the_turned_picture) {
  const auto turn = [](Vec2 p) { return Vec2{kHeight - p.y, p.x}; };
  expect_same(
      mapped(strokes(kWidth, kHeight, 16), turn), kOtherMesh,
      [](int x, int y) {
        return Pixel{kHeight - 1 - y, x};
      },
      kHeight, kWidth);
}

TEST(EndsMetamorphic, a_moved_drawing_is_the_same_picture) {
  const auto move = [](Vec2 p) { return p + Vec2{4096, -1023}; };
  expect_same(mapped(strokes(kWidth, kHeight, 16), move), kSame, [](int x, int y) {
    return Pixel{x, y};
  });
}

TEST(EndsMetamorphic, a_drawing_of_twice_the_size_is_the_same_picture) {
  const auto grow = [](Vec2 p) { return 2 * p; };
  expect_same(mapped(strokes(kWidth, kHeight, 16), grow, false, 2), kSame, [](int x, int y) {
    return Pixel{x, y};
  });
}

/// Returns the document with every curve reversed.
Document turned_round(Document document) {
  for (Curve& curve : document.layers[0].curves) {
    std::ranges::reverse(curve.control_points);
    std::swap(curve.left, curve.right);
    const auto end = static_cast<double>(curve.piece_count());
    const auto turn = [end](auto& list) {
      for (auto& stop : list.stops) stop.offset = end - stop.offset;
      std::ranges::reverse(list.stops);
    };
    for (Side* side : {&curve.left, &curve.right}) {
      turn(side->color.stops);
      turn(side->blur_radius);
    }
  }
  return document;
}

TEST(EndsMetamorphic, curves_walked_from_their_other_ends_are_the_same_picture) {
  expect_same(turned_round(strokes(kWidth, kHeight, 16)), kOtherMesh, [](int x, int y) {
    return Pixel{x, y};
  });
}

/// Returns two curves whose ends face each other across a gap, in pixels; bent: each turns away
/// from it.
Document facing(double gap, double bend, float radius) {
  const Vec2 middle{48.3, 31.7}, along{0.96, 0.28}, across{-0.28, 0.96};
  const auto arm = [&](double side) {
    Curve curve;
    for (const double at : {0.0, 10.0, 20.0, 30.0}) {
      curve.control_points.push_back(middle + side * (gap / 2 + at) * along +
                                     bend * at * at / 60 * across);
    }
    return curve;
  };
  const Rgb red{1, 0, 0}, blue{0, 0, 1}, green{0, 1, 0}, white{1, 1, 1};
  Curve first = colored(arm(-1), red, blue), second = colored(arm(1), green, white);
  if (radius > 0) first = blurred(std::move(first), radius);
  return one_layer({first, second}, {{0, 0}, {1.0 * kWidth, 1.0 * kHeight}});
}

void expect_miss(const Miss& miss, const Miss& most, const std::string& name) {
  EXPECT_LE(miss.largest, most.largest) << name;
  EXPECT_LE(miss.mean, most.mean) << name;
}

TEST(EndsMetamorphic, ends_that_face_each_other_are_as_drawn_pixel_by_pixel) {
  const auto same = [](int x, int y) { return Pixel{x, y}; };
  // At pixel centres, as `pixels` draws, so that no curve is antialiased.
  const auto centers = [](const Document& document, Way way) {
    return drawn(document, way, kWidth, kHeight, false);
  };
  for (const double gap : {0.3, 2.0}) {
    for (const double bend : {0.0, 0.5, 1.5}) {
      for (const float radius : {0.0F, 3.0F}) {
        const std::string name = std::to_string(gap) + " apart, bent " + std::to_string(bend) +
                                 ", blurred " + std::to_string(radius);
        const Document document = facing(gap, bend, radius), other = turned_round(document);
        const Image pixels = centers(document, Way::pixels);
        const Image patches = centers(document, Way::patches);
        expect_miss(miss_of(patches, pixels, same), {8, 0.1}, name);
        expect_miss(miss_of(centers(other, Way::pixels), pixels, same), kSame.pixels, name);
        expect_miss(miss_of(centers(other, Way::patches), patches, same), kSame.patches, name);
      }
    }
  }
}

/// Sanitizers are slow, and need no more for their checks.
constexpr int kManyWidth = SFUMATO_HAS_SANITIZER ? 200 : 632;

/// Draws the upper left corner of a drawing; every curve is in the layer.
Status draw_corner(Context& context, const Document& document, gather::Ends ends) {
  DiffuseOptions options;
  options.ends = ends;
  options.viewport = Box{{0, 0}, {64, 64}};
  const Result<Picture> picture = diffuse(context, document, options);
  if (!picture) return picture.status();
  return rasterize(context, *picture, {.width = 64, .height = 64}).status();
}

TEST(ManyEnds, a_hundred_thousand_are_drawn_within_512_mib) {
  const Document document = strokes(kManyWidth, kManyWidth / 2, 2);
  ThreadPool pool(2);
  Context context{.executor = &pool, .budget = Budget(std::size_t{512} << 20)};
  const Status status = draw_corner(context, document, gather::Ends::soft);
  EXPECT_TRUE(status.ok()) << status.message;
}

TEST(ManyEnds, too_little_memory_for_them_is_an_answer) {
  const Document document = strokes(kManyWidth, kManyWidth / 2, 2);
  for (int mib = 1; mib <= 64; mib *= 4) {
    Context context{.budget = Budget(static_cast<std::size_t>(mib) << 20)};
    const Status status = draw_corner(context, document, gather::Ends::soft);
    EXPECT_TRUE(status.ok() || status.code == StatusCode::limit) << status.message;
    EXPECT_TRUE(mib > 1 || !status.ok());
    EXPECT_EQ(context.budget.used(), 0u);
  }
}

TEST(ManyEnds, ten_thousand_in_one_picture_are_mixtures_of_its_colours) {
  const Document document = strokes(200, 100, 2);
  ThreadPool pool(2);
  Context context{.executor = &pool};
  const Result<Picture> picture = diffuse(context, document, {.max_error = 0});
  ASSERT_TRUE(picture.ok()) << picture.status().message;
  for (const float value : picture->layers[0].color.node_value) {
    ASSERT_TRUE(value >= -1e-5f && value <= 1 + 1e-5f) << value;
  }
}

}  // namespace
}  // namespace sfumato::test
