// Whole documents gathered by point_walk.glsl: random ones compared with the packets, examples on
// the device compared with the twin.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "gpu/gather_device.hpp"
#include "sfumato/api/render_pixels.hpp"
#include "sfumato/base/native/thread_pool.hpp"
#include "sfumato/formats/read_document.hpp"
#include "sfumato/solve/point_evaluator.hpp"
#include "support.hpp"
#include "support/folder_files.hpp"
#include "support/places.hpp"
#include "support/random_document.hpp"
#include "support/scenes.hpp"
#include "support/twin_source.hpp"

namespace sfumato::test {
namespace {

struct Differences {
  double squares = 0;
  double largest = 0;
  std::size_t count = 0;

  void add(const std::vector<float>& a, const std::vector<float>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      const double difference = 255 * std::fabs(double{a[i]} - double{b[i]});
      squares += difference * difference;
      largest = std::max(largest, difference);
    }
    count += a.size();
  }
  double rms() const { return std::sqrt(squares / static_cast<double>(count)); }
};

std::vector<Vec2> points_in(const Box& box, std::uint64_t seed, int count) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> share(0.001, 0.999);
  std::vector<Vec2> points;
  for (int i = 0; i < count; ++i) {
    points.push_back(
        {box.min.x + share(random) * box.width(), box.min.y + share(random) * box.height()});
  }
  return points;
}

/// Returns the values of a layer at points, colours and then opacities.
std::vector<float> values_at(const PointEvaluator& evaluator, std::uint32_t layer,
                             const std::vector<Vec2>& points, PointSource* source) {
  Context context;
  context.point_source = source;
  const auto room = [&](int channels) {
    return std::vector<float>(static_cast<std::size_t>(channels) * points.size());
  };
  std::vector<float> color = room(evaluator.color_channels(layer));
  std::vector<float> opacity = room(evaluator.opacity_channels(layer));
  std::vector<std::uint8_t> hit(points.size());
  const Status status = evaluator.evaluate(context, layer, points, color, hit, opacity);
  EXPECT_TRUE(status.ok()) << to_string(status);
  color.insert(color.end(), opacity.begin(), opacity.end());
  return color;
}

// Beside curves of little weight the packets leave out up to half a code value of an opacity; the
// walk of points leaves out a tenth of that.
TEST(GpuGatherDocuments, random_ones_agree_with_the_packets) {
  Differences from_packets, from_all;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    const Document document = random_document(seed);
    Context context;
    const Result<PointEvaluator> evaluator = PointEvaluator::create(context, document, {});
    ASSERT_TRUE(evaluator.ok()) << to_string(evaluator.status());
    for (std::uint32_t layer = 0; layer < document.layers.size(); ++layer) {
      if (evaluator->color_channels(layer) == 0) continue;
      const std::vector<Vec2> points = points_in(document.artboard, seed, 100);
      TwinSource<16> twin, thorough;
      thorough.negligible = 0;
      Context probe;
      std::vector<float> color(static_cast<std::size_t>(evaluator->color_channels(layer)) * 100);
      std::vector<std::uint8_t> hit(100);
      // An instance may show another part of the layer than the artboard's part.
      if (!evaluator->evaluate(probe, layer, points, color, hit)) continue;
      const std::vector<float> walked = values_at(*evaluator, layer, points, &twin);
      from_all.add(walked, values_at(*evaluator, layer, points, &thorough));
      from_packets.add(walked, values_at(*evaluator, layer, points, nullptr));
    }
  }
  EXPECT_GT(from_all.count, 10'000u);
  EXPECT_LE(from_all.largest, 0.05);
  EXPECT_LE(from_all.rms(), 1e-3);
  EXPECT_LE(from_packets.largest, 0.5);
  EXPECT_LE(from_packets.rms(), 1e-2);
}

TEST(GpuGatherDocuments, some_examples_have_the_pixels_of_the_twin) {
  const auto device = gpu::GatherDevice::create();
  if (!device) GTEST_SKIP() << device.status().message;
  for (const char* name : {"blur.svg", "flower.svg", "strokes.svg", "textures.svg"}) {
    SCOPED_TRACE(name);
    ThreadPool executor;
    Context context;
    context.executor = &executor;
    const FolderFiles files(kExamplesFolder);
    const auto bytes = file_bytes(kExamplesFolder + "/" + name);
    ASSERT_TRUE(bytes);
    const Result<ReadDocument> read = read_document(context, *bytes, "example", &files);
    ASSERT_TRUE(read.ok()) << to_string(read.status());
    const Box& artboard = read->document.artboard;
    RasterOptions options;
    options.width = 64;
    options.antialias = false;
    options.height = static_cast<int>(std::ceil(64 * artboard.height() / artboard.width()));
    const auto drawn = [&](PointSource* source) {
      context.point_source = source;
      const Result<Image> image = render_pixels(context, read->document, {}, options);
      EXPECT_TRUE(image.ok()) << to_string(image.status());
      return image.ok() ? image->bytes : std::vector<std::uint8_t>();
    };
    TwinSource<16> twin;
    twin.least = device->get()->least_points();
    EXPECT_EQ(drawn(device->get()), drawn(&twin));
    EXPECT_GT(twin.asked(), 0u);
  }
}

}  // namespace
}  // namespace sfumato::test
