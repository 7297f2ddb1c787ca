// Free ends of open curves: no sliver ahead of them, and no change where there are none.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "curves/bezier.hpp"
#include "sfumato/formats/read_document.hpp"
#include "sfumato/raster/rasterize.hpp"
#include "sfumato/solve/diffuse.hpp"
#include "sfumato/solve/point_evaluator.hpp"
#include "support/drawing.hpp"
#include "support/places.hpp"
#include "support/scenes.hpp"

namespace sfumato {
namespace {

Document evening() {
  Context context;
  const auto bytes = test::file_bytes(test::source_path("examples/evening.xml"));
  Result<ReadDocument> read = read_document(context, bytes.value_or(""), "evening.xml");
  EXPECT_TRUE(read.ok());
  return read ? std::move(read->document) : Document{};
}

struct End {
  Vec2 position, direction;
};

/// Returns whether a curve other than `own` comes within `distance` of the point.
bool is_near_another(const Layer& layer, const Curve& own, Vec2 point, double distance) {
  constexpr int kSamples = 256;
  for (const Curve& curve : layer.curves) {
    if (&curve == &own) continue;
    for (std::size_t i = 0; i < curve.piece_count(); ++i) {
      const curves::Cubic cubic = curves::piece(curve.control_points, i);
      for (int k = 0; k <= kSamples; ++k) {
        const Vec2 sample = curves::point_at(cubic, static_cast<double>(k) / kSamples);
        if (length(sample - point) < distance) return true;
      }
    }
  }
  return false;
}

/// Returns the ends of open curves inside the artboard with nothing else within the arcs of `tick`.
std::vector<End> ends_of(const Document& document) {
  std::vector<End> ends;
  for (const Curve& curve : document.layers[0].curves) {
    const auto& p = curve.control_points;
    if (p.front() == p.back()) continue;
    for (const End& end :
         {End{p.front(), p.front() - p[1]}, End{p.back(), p.back() - p.end()[-2]}}) {
      const Box inside = document.artboard.grown_by(-1);
      if (!inside.contains(end.position) || !(length(end.direction) > 0)) continue;
      if (is_near_another(document.layers[0], curve, end.position, 17)) continue;
      ends.push_back({end.position, end.direction / length(end.direction)});
    }
  }
  return ends;
}

/// Returns the largest second difference, in code values, at steps of half a pixel on arcs of 1 to
/// 16 pixels ahead of the end.
double tick(Context& context, const PointEvaluator& evaluator, const End& end) {
  double largest = 0;
  const Vec2 left{end.direction.y, -end.direction.x};
  for (double radius = 1; radius <= 16; radius *= 2) {
    std::vector<Vec2> points;
    const double step = 0.5 / radius;
    for (double angle = -1.2; angle <= 1.2; angle += step) {
      points.push_back(end.position +
                       radius * (std::cos(angle) * end.direction + std::sin(angle) * left));
    }
    const auto channels = static_cast<std::size_t>(evaluator.color_channels(0));
    std::vector<float> color(channels * points.size());
    std::vector<std::uint8_t> hit(points.size());
    EXPECT_TRUE(evaluator.evaluate(context, 0, points, color, hit).ok());
    for (std::size_t i = channels; i + channels < color.size(); ++i) {
      const double bend = color[i - channels] - 2 * color[i] + color[i + channels];
      largest = std::max(largest, 255 * std::fabs(bend));
    }
  }
  return largest;
}

std::vector<double> ticks(const Document& document, gather::Ends ends) {
  Context context;
  DiffuseOptions options;
  options.ends = ends;
  options.viewport = document.artboard.grown_by(16);  // the reach of the arcs
  const Result<PointEvaluator> evaluator = PointEvaluator::create(context, document, options);
  EXPECT_TRUE(evaluator.ok());
  std::vector<double> ticks;
  for (const End& end : ends_of(document)) ticks.push_back(tick(context, *evaluator, end));
  return ticks;
}

TEST(Ends, no_cloud_of_evening_has_a_tick_ahead_of_its_end) {
  const Document document = evening();
  const auto above_4 = [](const std::vector<double>& all) {
    return std::ranges::count_if(all, [](double tick) { return tick > 4; });
  };
  EXPECT_GE(above_4(ticks(document, gather::Ends::paper)), 8);
  EXPECT_EQ(above_4(ticks(document, gather::Ends::soft)), 0);
}

TEST(Ends, soft_ends_need_fewer_nodes) {
  const Document document = evening();
  Context context;
  DiffuseStats soft, paper;
  EXPECT_TRUE(diffuse(context, document, {.ends = gather::Ends::soft}, &soft).ok());
  EXPECT_TRUE(diffuse(context, document, {.ends = gather::Ends::paper}, &paper).ok());
  EXPECT_LT(static_cast<double>(soft.nodes), 0.85 * static_cast<double>(paper.nodes));
}

std::vector<std::uint8_t> drawn(const Document& document, gather::Ends ends) {
  Context context;
  const Result<Picture> picture = diffuse(context, document, {.ends = ends});
  EXPECT_TRUE(picture.ok());
  const Result<Image> image =
      rasterize(context, *picture, {.width = 100, .height = 100, .format = PixelFormat::rgba8});
  EXPECT_TRUE(image.ok());
  return image->bytes;
}

TEST(Ends, closed_shapes_and_ends_on_other_curves_are_the_same_bytes_with_paper) {
  const Rgb red{1, 0, 0}, blue{0, 0, 1}, green{0, 1, 0}, white{1, 1, 1};
  Document document =
      test::one_layer({test::colored(test::circle_curve({50, 50}, 40), white, red),
                       test::colored(test::straight_curve({50, 10}, {50, 90}), blue, green)});
  EXPECT_EQ(drawn(document, gather::Ends::soft), drawn(document, gather::Ends::paper));
  document.layers[0].curves.pop_back();
  EXPECT_EQ(drawn(document, gather::Ends::soft), drawn(document, gather::Ends::paper));
}

TEST(Ends, opacity_alone_and_with_colour_turns_too) {
  const Curve around = test::colored(test::circle_curve({50, 50}, 45), {1, 1, 1}, {1, 1, 1});
  const Curve line = test::straight_curve({30, 50}, {60, 50});
  for (bool is_joint : {false, true}) {
    const Curve border = is_joint ? test::with_opacity(around, 1, 1) : around;
    const Curve inner = is_joint
                            ? test::with_opacity(test::colored(line, {1, 0, 0}, {0, 0, 1}), 0, 1)
                            : test::with_opacity(line, 0, 1);
    const Document document = test::one_layer({border, inner});
    EXPECT_NE(drawn(document, gather::Ends::soft), drawn(document, gather::Ends::paper));
  }
}

}  // namespace
}  // namespace sfumato
