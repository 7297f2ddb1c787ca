// Distances to pixels by brute force, and thin lines that are connected like the thick ones.
#include "trace/image/thinning.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "trace/image/distance.hpp"

namespace sfumato::tracing {
namespace {

Plane nearest_by_trying(const Plane& plane) {
  Plane out = plane;
  for (int y = 0; y < plane.height; ++y) {
    for (int x = 0; x < plane.width; ++x) {
      double least = double{kFar};
      for (int v = 0; v < plane.height; ++v) {
        for (int u = 0; u < plane.width; ++u) {
          const double far = (u - x) * (u - x) + (v - y) * (v - y);
          least = std::min(least, far + double{plane.at(u, v)});
        }
      }
      out.row(y)[x] = static_cast<float>(least);
    }
  }
  return out;
}

TEST(TransformDistance, is_the_least_over_all_pixels) {
  std::mt19937 random(1);
  for (const auto& [width, height] : {std::pair{1, 1}, {17, 1}, {1, 23}, {31, 20}, {20, 37}}) {
    Plane plane{width, height, {}};
    for (int i = 0; i < width * height; ++i) {
      const std::uint32_t kind = random() % 20;
      plane.value.push_back(kind == 0 ? 0.0f : kind == 1 ? -float(random() % 9) : kFar);
    }
    plane.value[random() % plane.value.size()] = 0;
    const Plane expected = nearest_by_trying(plane);
    Context context;
    ASSERT_TRUE(transform_distance(context, plane).ok());
    for (std::size_t i = 0; i < plane.value.size(); ++i) {
      ASSERT_NEAR(plane.value[i], expected.value[i], 1e-3) << width << " x " << height;
    }
  }
}

TEST(TransformDistance, is_far_where_there_is_nothing) {
  Plane plane{20, 10, std::vector<float>(200, kFar)};
  Context context;
  ASSERT_TRUE(transform_distance(context, plane).ok());
  for (const float value : plane.value) EXPECT_GE(value, 0.99f * kFar);
}

PixelSet empty_set(int width, int height) {
  PixelSet set{width, height, {}};
  set.is_set.resize(set.stride() * (static_cast<std::size_t>(height) + 2));
  return set;
}

/// Returns strokes a few pixels wide, painted with a disc.
PixelSet random_strokes(std::uint32_t seed) {
  std::mt19937 random(seed);
  PixelSet set = empty_set(80, 60);
  std::uniform_real_distribution<double> x(5, 75), y(5, 55), radius(1.5, 4);
  for (int stroke = 0; stroke < 5; ++stroke) {
    const double ax = x(random), ay = y(random), bx = x(random), by = y(random);
    const double r = radius(random);
    for (int v = 0; v < set.height; ++v) {
      for (int u = 0; u < set.width; ++u) {
        const double along = std::clamp(((u - ax) * (bx - ax) + (v - ay) * (by - ay)) /
                                            std::max(std::hypot(bx - ax, by - ay), 1e-9) /
                                            std::max(std::hypot(bx - ax, by - ay), 1e-9),
                                        0.0, 1.0);
        const double far = std::hypot(u - ax - along * (bx - ax), v - ay - along * (by - ay));
        if (far <= r) set.is_set[set.index(u, v)] = 1;
      }
    }
  }
  return set;
}

/// Returns the number of connected sets of pixels: set pixels connect to eight neighbours, others
/// to four.
int component_count(const PixelSet& set, bool of_set) {
  std::vector<std::uint8_t> left(set.is_set.size());
  for (std::size_t i = 0; i < left.size(); ++i) left[i] = (set.is_set[i] != 0) == of_set;
  const auto rows = static_cast<int>(left.size() / set.stride());
  const auto columns = static_cast<int>(set.stride());
  int count = 0;
  std::vector<std::size_t> todo;
  for (std::size_t first = 0; first < left.size(); ++first) {
    if (!left[first]) continue;
    ++count;
    left[first] = 0;
    todo.push_back(first);
    while (!todo.empty()) {
      const int at = static_cast<int>(todo.back());
      todo.pop_back();
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          if (!of_set && dx != 0 && dy != 0) continue;
          const int x = at % columns + dx, y = at / columns + dy;
          if (x < 0 || y < 0 || x >= columns || y >= rows) continue;
          const auto other = static_cast<std::size_t>(y * columns + x);
          if (!left[other]) continue;
          left[other] = 0;
          todo.push_back(other);
        }
      }
    }
  }
  return count;
}

/// Returns the number of squares of three by three set pixels.
int thick_places(const PixelSet& set) {
  int count = 0;
  for (int y = 1; y + 1 < set.height; ++y) {
    for (int x = 1; x + 1 < set.width; ++x) {
      int pixels = 0;
      for (int i = 0; i < 9; ++i) pixels += set.is_set[set.index(x + i % 3 - 1, y + i / 3 - 1)];
      count += pixels == 9;
    }
  }
  return count;
}

TEST(Thin, keeps_how_lines_hang_together) {
  for (std::uint32_t seed = 1; seed <= 30; ++seed) {
    PixelSet set = random_strokes(seed);
    const PixelSet before = set;
    Context context;
    ASSERT_TRUE(thin(context, set).ok());
    EXPECT_GT(thick_places(before), 0);
    EXPECT_EQ(thick_places(set), 0) << "seed " << seed;
    EXPECT_EQ(component_count(set, true), component_count(before, true)) << "seed " << seed;
    EXPECT_EQ(component_count(set, false), component_count(before, false)) << "seed " << seed;
    for (std::size_t i = 0; i < set.is_set.size(); ++i) {
      ASSERT_LE(set.is_set[i], before.is_set[i]) << "adds no pixel";
    }
  }
}

TEST(Thin, makes_a_bar_a_line_of_one_pixel) {
  PixelSet set = empty_set(40, 15);
  for (int y = 5; y < 10; ++y) {
    for (int x = 5; x < 35; ++x) set.is_set[set.index(x, y)] = 1;
  }
  Context context;
  ASSERT_TRUE(thin(context, set).ok());
  for (int x = 8; x < 32; ++x) {
    int height = 0;
    for (int y = 0; y < 15; ++y) height += set.is_set[set.index(x, y)];
    EXPECT_EQ(height, 1) << x;
  }
}

TEST(Thin, leaves_thin_lines_as_they_are) {
  PixelSet set = empty_set(30, 30);
  for (int i = 3; i < 27; ++i) set.is_set[set.index(i, i)] = set.is_set[set.index(i, 29 - i)] = 1;
  const std::vector<std::uint8_t> before = set.is_set;
  Context context;
  ASSERT_TRUE(thin(context, set).ok());
  int lost = 0;
  for (std::size_t i = 0; i < before.size(); ++i) lost += before[i] - set.is_set[i];
  EXPECT_LE(lost, 4);  // around the crossing
  EXPECT_EQ(component_count(set, true), 1);
}

}  // namespace
}  // namespace sfumato::tracing
