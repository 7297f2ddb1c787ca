// The gather at every pixel compared with brute-force colours, for drawings of every artistic
// control.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

#include "sfumato/api/render_pixels.hpp"
#include "sfumato/formats/read_document.hpp"
#include "support/places.hpp"
#include "support/scenes.hpp"

namespace sfumato {
namespace {

const std::string kControlsFolder = test::shared_path("reference/controls/");

struct ControlPoint {
  int x, y;
  double code_value[4];  ///< premultiplied, 0 to 255
};

std::vector<ControlPoint> read_points(const std::string& text) {
  std::istringstream file(text);
  std::vector<ControlPoint> points;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream fields(line);
    ControlPoint p{};
    double x = 0, y = 0;
    fields >> x >> y;
    for (double& value : p.code_value) fields >> value;
    p.x = static_cast<int>(x), p.y = static_cast<int>(y);
    points.push_back(p);
  }
  return points;
}

/// Images beside the drawings.
class ControlImages final : public ResourceLoader {
 public:
  Result<std::vector<std::uint8_t>> load(std::string_view href) const override {
    const auto bytes = test::file_bytes(kControlsFolder + std::string(href));
    if (!bytes) return make_error(StatusCode::bad_input, std::string(href));
    return std::vector<std::uint8_t>(bytes->begin(), bytes->end());
  }
};

class ControlPoints : public testing::TestWithParam<const char*> {};

TEST_P(ControlPoints, are_those_of_brute_force) {
  const auto svg = test::file_bytes(kControlsFolder + GetParam() + ".svg");
  const auto csv = test::file_bytes(kControlsFolder + GetParam() + ".csv");
  if (!svg || !csv) GTEST_SKIP() << "the shared reference colours are not here";
  Context context;
  const ControlImages images;
  Result<ReadDocument> read = read_document(context, *svg, "a.svg", &images);
  ASSERT_TRUE(read.ok()) << read.status().message;
  Document& document = read->document;
  document.background.reset();
  DiffuseOptions diffuse_options;
  diffuse_options.tolerance = 0.002;
  diffuse_options.ends = gather::Ends::paper;
  RasterOptions options;
  options.width = static_cast<int>(document.artboard.width());
  options.height = static_cast<int>(document.artboard.height());
  options.format = PixelFormat::rgba16;
  options.antialias = false;
  const Result<Image> image = render_pixels(context, document, diffuse_options, options);
  ASSERT_TRUE(image.ok()) << image.status().message;

  const std::vector<ControlPoint> points = read_points(*csv);
  ASSERT_GE(points.size(), 100u);
  double sum = 0;
  for (const ControlPoint& p : points) {
    std::uint16_t sample[4];
    const std::size_t pixel = static_cast<std::size_t>(p.y) * options.width + p.x;
    std::memcpy(sample, image->bytes.data() + sizeof(sample) * pixel, sizeof(sample));
    double worst = 0;
    for (int c = 0; c < 4; ++c) {
      const double share = c < 3 ? sample[3] / 65535.0 : 1;
      worst = std::max(worst, std::fabs(sample[c] / 257.0 * share - p.code_value[c]));
    }
    EXPECT_LE(worst, 2) << "at " << p.x << ", " << p.y;
    sum += worst * worst;
  }
  EXPECT_LE(std::sqrt(sum / static_cast<double>(points.size())), 0.5);
}

INSTANTIATE_TEST_SUITE_P(
    Controls, ControlPoints,
    testing::Values("arcs0", "barrier0", "blur-big0", "blur-const0", "blur-sides0", "blur-small0",
                    "blur-vary0", "bug-blur-line", "bug-blur-line2", "bug-coincident", "bug-ring",
                    "bug-selfoverlap", "closed0", "coincident1", "cross0", "gradlin0", "gradrad0",
                    "instance0", "layers0", "linear0", "local0", "oklab0", "opacity0", "opblur0",
                    "open0", "stops0", "texture0", "touch0", "urlop0", "weight0", "within0"),
    [](const auto& one) {
      std::string name = one.param;
      std::ranges::replace(name, '-', '_');
      return name;
    });

}  // namespace
}  // namespace sfumato
