// The whole pipeline compared with exact colours at points of public scenes, computed by brute
// force.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "sfumato/raster/rasterize.hpp"
#include "sfumato/solve/diffuse.hpp"
#include "sfumato/solve/point_evaluator.hpp"
#include "support/places.hpp"
#include "support/scenes.hpp"

namespace sfumato {
namespace {

struct ReferencePoint {
  Vec2 position;
  double code_value[3];  ///< 0 to 255, unrounded
};

std::vector<ReferencePoint> read_reference(const std::string& scene) {
  std::ifstream file(test::shared_path("reference/") + scene + ".csv");
  std::vector<ReferencePoint> points;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream fields(line);
    ReferencePoint p;
    fields >> p.position.x >> p.position.y >> p.code_value[0] >> p.code_value[1] >> p.code_value[2];
    points.push_back(p);
  }
  return points;
}

Document without_blur(Document document) {
  for (Layer& layer : document.layers) {
    for (Curve& curve : layer.curves) {
      curve.left.blur_radius = {};
      curve.right.blur_radius = {};
    }
  }
  return document;
}

/// Returns the distance to the nearest end of an open curve.
double distance_to_end(const Document& document, Vec2 p) {
  double nearest = 1e30;
  for (const Curve& curve : document.layers[0].curves) {
    const Vec2 first = curve.control_points.front(), last = curve.control_points.back();
    if (first == last) continue;
    nearest = std::min({nearest, length(p - first), length(p - last)});
  }
  return nearest;
}

class Reference : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    const std::optional<Document> read = test::shared_scene(std::string(GetParam()) + ".xml");
    if (!read) GTEST_SKIP() << "the shared scenes are not here";
    document_ = without_blur(*read);
    points_ = read_reference(GetParam());
    ASSERT_GT(points_.size(), 100u);
  }

  Document document_;
  std::vector<ReferencePoint> points_;
};

TEST_P(Reference, the_exact_gather_at_single_points_is_within_one_code_value) {
  Context context;
  DiffuseOptions options;
  options.ends = gather::Ends::paper;
  options.tolerance = 0.02;
  Result<PointEvaluator> evaluator = PointEvaluator::create(context, document_, options);
  ASSERT_TRUE(evaluator.ok()) << evaluator.status().message;
  std::vector<Vec2> positions;
  for (const ReferencePoint& p : points_) positions.push_back(p.position);
  std::vector<float> rgb(3 * positions.size());
  std::vector<std::uint8_t> hit(positions.size());
  ASSERT_TRUE(evaluator->evaluate(context, 0, positions, rgb, hit).ok());
  for (std::size_t i = 0; i < points_.size(); ++i) {
    EXPECT_EQ(hit[i], 1);
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(255 * rgb[3 * i + c], points_[i].code_value[c], 1.0)
          << "at " << points_[i].position.x << ", " << points_[i].position.y;
    }
  }
}

TEST_P(Reference, the_default_picture_misses_by_half_a_code_value_rms) {
  Context context;
  Result<Picture> picture = diffuse(context, document_, {.ends = gather::Ends::paper});
  ASSERT_TRUE(picture.ok()) << picture.status().message;
  RasterOptions raster;
  raster.width = static_cast<int>(document_.artboard.width());
  raster.height = static_cast<int>(document_.artboard.height());
  raster.format = PixelFormat::rgb16;
  Result<Image> image = rasterize(context, *picture, raster);
  ASSERT_TRUE(image.ok()) << image.status().message;
  const auto* pixels = reinterpret_cast<const std::uint16_t*>(image->bytes.data());
  std::vector<double> misses;
  double sum = 0;
  for (const ReferencePoint& p : points_) {
    const auto column = static_cast<std::size_t>(p.position.x);
    const auto row = static_cast<std::size_t>(p.position.y);
    for (int c = 0; c < 3; ++c) {
      const double value = pixels[3 * (row * static_cast<std::size_t>(raster.width) + column) + c];
      const double miss = std::fabs(value / 257 - p.code_value[c]);
      sum += miss * miss;
      misses.push_back(miss);
      if (distance_to_end(document_, p.position) > 10) {
        EXPECT_LE(miss, 4) << "at " << p.position.x << ", " << p.position.y;
      }
    }
  }
  std::sort(misses.begin(), misses.end());
  EXPECT_LE(std::sqrt(sum / static_cast<double>(misses.size())), 0.5);
  EXPECT_LE(misses[misses.size() * 99 / 100], 2);
  RecordProperty("rms", std::to_string(std::sqrt(sum / static_cast<double>(misses.size()))));
  RecordProperty("p99", std::to_string(misses[misses.size() * 99 / 100]));
  RecordProperty("max", std::to_string(misses.back()));
}

INSTANTIATE_TEST_SUITE_P(SharedScenes, Reference,
                         testing::Values("lady_bug", "tomatos", "dolphin", "drape"),
                         [](const auto& name) { return std::string(name.param); });

}  // namespace
}  // namespace sfumato
