#pragma once

#include <memory>
#include <string>
#include <vector>

#include "gather/point_source.hpp"
#include "gather/scene/locate.hpp"
#include "gather/scene/packing.hpp"
#include "prepared.hpp"

namespace sfumato::bench {

inline std::vector<gather::WalkPoint> located(const gather::Scene& scene,
                                              const std::vector<Vec2>& points) {
  Context context;
  const Result<gather::Locator> locator = gather::Locator::create(context, scene);
  const Result<gather::LocatedPoints> at = locator->locate(context, points);
  std::vector<gather::WalkPoint> walk;
  for (std::size_t i = 0; i < points.size(); ++i)
    walk.push_back({at->x[i], at->y[i], static_cast<std::int32_t>(at->triangle[i])});
  return walk;
}

/// Returns the nodes of a drawing in the order of a Gatherer: by triangle.
inline std::vector<gather::WalkPoint> node_points(const Prepared& drawing) {
  std::vector<gather::WalkPoint> walk = located(drawing.scene, drawing.points);
  std::ranges::stable_sort(walk, {}, &gather::WalkPoint::triangle);
  return walk;
}

/// Returns pixel centres of an image of this width, off the grid so that none lies on a curve's
/// control point, in tiles of 8 × 4 pixels.
inline std::vector<gather::WalkPoint> pixel_points(const Prepared& drawing, const Box& artboard,
                                                   int width) {
  constexpr int kTileWidth = 8, kTileHeight = 4;
  constexpr double kOff = 0.0371;
  const double pixel = artboard.width() / width;
  const int height = static_cast<int>(artboard.height() / pixel);
  std::vector<Vec2> points;
  for (int tile_y = 0; tile_y < height; tile_y += kTileHeight) {
    for (int tile_x = 0; tile_x < width; tile_x += kTileWidth) {
      for (int y = tile_y; y < std::min(tile_y + kTileHeight, height); ++y) {
        for (int x = tile_x; x < std::min(tile_x + kTileWidth, width); ++x) {
          points.push_back({artboard.min.x + (x + 0.5 + kOff) * pixel,
                            artboard.min.y + (y + 0.5 + kOff) * pixel});
        }
      }
    }
  }
  return located(drawing.scene, points);
}

/// Returns at most `count` of the points, in runs of neighbours from everywhere.
inline std::vector<gather::WalkPoint> sample_of(const std::vector<gather::WalkPoint>& all,
                                                std::size_t count) {
  constexpr std::size_t kRun = 32;
  if (all.size() <= count) return all;
  std::vector<gather::WalkPoint> some;
  const std::size_t runs = count / kRun, step = all.size() / runs;
  for (std::size_t i = 0; i < runs; ++i) {
    const auto first = all.begin() + static_cast<std::ptrdiff_t>(i * step);
    some.insert(some.end(), first, first + static_cast<std::ptrdiff_t>(std::min(kRun, step)));
  }
  return some;
}

}  // namespace sfumato::bench
