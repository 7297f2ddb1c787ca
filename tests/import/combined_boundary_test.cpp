// Union, intersection, difference and exclusion of two filled regions.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "import/boundary.hpp"
#include "import/chords.hpp"
#include "support/flattened.hpp"

namespace sfumato {
namespace {

using svg_import::Contours;
using svg_import::FilledContours;

constexpr double kCombineTolerance = 100.0 / 16384;

using Polygons = std::vector<std::vector<Vec2>>;

Polygons polygons_of(const Contours& contours) {
  Polygons polygons;
  for (const std::vector<Vec2>& contour : contours) {
    polygons.push_back(test::flattened(contour, kCombineTolerance / 4));
  }
  return polygons;
}

int winding_around(const Polygons& polygons, Vec2 point) {
  std::vector<svg_import::Chord> chords;
  for (const std::vector<Vec2>& polygon : polygons) {
    for (std::size_t i = 1; i < polygon.size(); ++i) {
      chords.push_back({polygon[i - 1], polygon[i]});
    }
  }
  return svg_import::winding_number(chords, point);
}

double distance_from(const Polygons& polygons, Vec2 p) {
  double least = std::numeric_limits<double>::max();
  for (const std::vector<Vec2>& polygon : polygons) {
    for (std::size_t i = 1; i < polygon.size(); ++i) {
      const Vec2 a = polygon[i - 1], along = polygon[i] - a;
      const double size = length_squared(along);
      const double t = size > 0 ? std::clamp(dot(p - a, along) / size, 0.0, 1.0) : 0;
      least = std::min(least, length(p - a - along * t));
    }
  }
  return least;
}

bool holds(int winding, bool even_odd) {
  return even_odd ? winding % 2 != 0 : winding != 0;
}

bool combined(RegionOperation operation, bool first, bool second) {
  switch (operation) {
    case RegionOperation::unite:
      return first || second;
    case RegionOperation::intersect:
      return first && second;
    case RegionOperation::subtract:
      return first && !second;
    case RegionOperation::exclude:
      break;
  }
  return first != second;
}

constexpr RegionOperation kOperations[] = {RegionOperation::unite, RegionOperation::intersect,
                                           RegionOperation::subtract, RegionOperation::exclude};

double area_of(const Contours& contours) {
  double sum = 0;
  for (const std::vector<Vec2>& polygon : polygons_of(contours)) {
    for (std::size_t i = 1; i < polygon.size(); ++i) sum += cross(polygon[i - 1], polygon[i]) / 2;
  }
  return sum;
}

Contours rectangle(double left, double top, double right, double bottom) {
  std::vector<Vec2> chain{{left, top}};
  for (const Vec2 to : {Vec2{right, top}, Vec2{right, bottom}, Vec2{left, bottom}, chain[0]}) {
    const Vec2 from = chain.back();
    chain.insert(chain.end(), {lerp(from, to, 1.0 / 3), lerp(from, to, 2.0 / 3), to});
  }
  return {chain};
}

/// Returns closed curves through any points.
Contours random_contours(std::mt19937& random) {
  const auto share = [&] { return static_cast<double>(random()) / 4294967296.0; };
  const auto point = [&] { return Vec2{10 + 80 * share(), 10 + 80 * share()}; };
  Contours contours;
  for (int count = 1 + static_cast<int>(2 * share()); count > 0; --count) {
    std::vector<Vec2> chain{point()};
    for (int pieces = 2 + static_cast<int>(4 * share()); pieces > 0; --pieces) {
      const Vec2 to = pieces == 1 ? chain.front() : point();
      chain.insert(chain.end(), {point(), point(), to});
    }
    contours.push_back(chain);
  }
  return contours;
}

double area_of(RegionOperation operation, const Contours& first, const Contours& second) {
  Context context;
  const auto made =
      svg_import::combined_boundary(context, operation, {first}, {second}, kCombineTolerance);
  EXPECT_TRUE(made);
  return made ? area_of(*made) : 0;
}

TEST(CombinedBoundary, of_rectangles_has_its_area) {
  const Contours a = rectangle(0, 0, 20, 20), b = rectangle(10, 5, 30, 15);
  EXPECT_NEAR(area_of(RegionOperation::unite, a, b), 500, 1e-6);
  EXPECT_NEAR(area_of(RegionOperation::intersect, a, b), 100, 1e-6);
  EXPECT_NEAR(area_of(RegionOperation::subtract, a, b), 300, 1e-6);
  EXPECT_NEAR(area_of(RegionOperation::subtract, b, a), 100, 1e-6);
  EXPECT_NEAR(area_of(RegionOperation::exclude, a, b), 400, 1e-6);
}

TEST(CombinedBoundary, of_a_region_with_itself_or_a_neighbor) {
  const Contours a = rectangle(0, 0, 20, 20), beside = rectangle(20, 0, 30, 20);
  const Contours within = rectangle(5, 5, 10, 10), apart = rectangle(40, 40, 50, 50);
  EXPECT_NEAR(area_of(RegionOperation::intersect, a, a), 400, 1e-6);
  EXPECT_EQ(area_of(RegionOperation::subtract, a, a), 0);
  EXPECT_EQ(area_of(RegionOperation::exclude, a, a), 0);
  EXPECT_NEAR(area_of(RegionOperation::unite, a, beside), 600, 1e-6);
  EXPECT_EQ(area_of(RegionOperation::intersect, a, beside), 0);
  EXPECT_NEAR(area_of(RegionOperation::subtract, a, within), 375, 1e-6);
  EXPECT_NEAR(area_of(RegionOperation::intersect, a, within), 25, 1e-6);
  EXPECT_EQ(area_of(RegionOperation::intersect, a, apart), 0);
  EXPECT_EQ(area_of(RegionOperation::intersect, a, {}), 0);
  EXPECT_NEAR(area_of(RegionOperation::subtract, a, {}), 400, 1e-6);
}

/// Expects that points well away from both outlines are inside or outside the result as the
/// operation requires.
void expect_combined(const Contours& first, bool first_even_odd, const Contours& second,
                     bool second_even_odd, const std::string& name) {
  const Polygons of_first = polygons_of(first), of_second = polygons_of(second);
  for (const RegionOperation operation : kOperations) {
    Context context;
    const auto made = svg_import::combined_boundary(context, operation, {first, first_even_odd},
                                                    {second, second_even_odd}, kCombineTolerance);
    ASSERT_TRUE(made) << name;
    const Polygons result = polygons_of(*made);
    for (int i = 0; i < 20 * 20; ++i) {
      const Vec2 p{(i % 20 + 0.487) * 5, (i / 20 + 0.513) * 5};
      if (std::min(distance_from(of_first, p), distance_from(of_second, p)) < 0.1) continue;
      const bool is_inside = combined(operation, holds(winding_around(of_first, p), first_even_odd),
                                      holds(winding_around(of_second, p), second_even_odd));
      ASSERT_EQ(winding_around(result, p), is_inside ? 1 : 0)
          << name << ", operation " << static_cast<int>(operation) << " at " << p.x << ", " << p.y;
    }
  }
}

TEST(CombinedBoundary, of_random_curves_holds_what_the_operation_says) {
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    std::mt19937 random(seed);
    const Contours first = random_contours(random), second = random_contours(random);
    expect_combined(first, seed % 2 == 1, second, seed % 4 > 1, "seed " + std::to_string(seed));
  }
}

}  // namespace
}  // namespace sfumato
