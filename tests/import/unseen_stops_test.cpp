// Gradients with a step at the edge of the shape.
#include "import/unseen_stops.hpp"

#include <gtest/gtest.h>

#include <string>

#include "sfumato/import/import_svg.hpp"
#include "support/draw.hpp"

namespace sfumato {
namespace {

using svg_import::unseen_stops;
using svg_import::UnseenStops;

/// Returns a row of pixels of a rectangle that ends at x = 50.5, on a clear ground.
Image row_of_rectangle(const std::string& gradient, const std::string& stops) {
  Context context;
  const auto made = import_svg(context,
                               "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 10'>"
                               "<linearGradient id='g' " +
                                   gradient + ">" + stops +
                                   "</linearGradient>"
                                   "<rect x='10.5' y='-5' width='40' height='20' "
                                   "fill='url(#g)'/></svg>",
                               "step.svg");
  EXPECT_TRUE(made);
  auto image = test::draw(context, made->document, 100, 10, PixelFormat::rgba8);
  EXPECT_TRUE(image);
  return std::move(*image);
}

int alpha_at(const Image& image, int x) {
  return image.bytes[static_cast<std::size_t>(4 * (5 * image.width + x) + 3)];
}

constexpr const char* kStep =
    "<stop stop-opacity='0'/><stop stop-color='red'/>"
    "<stop offset='1' stop-color='red'/><stop offset='1' stop-opacity='0'/>";

TEST(UnseenStops, a_step_at_the_edge_leaves_the_edge_as_it_is) {
  for (const char* gradient :
       {"", "gradientUnits='userSpaceOnUse' x1='10.5' x2='50.5'",
        "gradientUnits='userSpaceOnUse' x1='21' x2='101' gradientTransform='scale(.5)'"}) {
    const Image image = row_of_rectangle(gradient, kStep);
    EXPECT_EQ(alpha_at(image, 9), 0) << gradient;
    EXPECT_NEAR(alpha_at(image, 10), 128, 1) << gradient;
    EXPECT_EQ(alpha_at(image, 30), 255) << gradient;
    EXPECT_NEAR(alpha_at(image, 50), 128, 1) << gradient;
    EXPECT_EQ(alpha_at(image, 51), 0) << gradient;
  }
}

TEST(UnseenStops, a_step_within_the_shape_is_drawn) {
  const Image image = row_of_rectangle("gradientUnits='userSpaceOnUse' x1='20.5' x2='40.5'", kStep);
  EXPECT_EQ(alpha_at(image, 15), 0);
  EXPECT_NEAR(alpha_at(image, 20), 128, 1);
  EXPECT_EQ(alpha_at(image, 30), 255);
  EXPECT_NEAR(alpha_at(image, 40), 128, 1);
  EXPECT_EQ(alpha_at(image, 45), 0);
}

TEST(UnseenStops, are_those_of_linear_gradients_that_end) {
  GradientFill fill;
  fill.shape = LinearGradient{{0, 0}, {1, 0}};
  fill.stops = {{0, {}, 1}, {1, {}, 1}, {1, {}, 1}, {1, {}, 1}};
  const svg_import::Contours within{{{0.1, 5}, {0.9, 9}}}, beyond{{{0.1, 5}, {1.1, 9}}};
  EXPECT_EQ(unseen_stops(fill, within, 0.01), (UnseenStops{0, 2}));
  EXPECT_EQ(unseen_stops(fill, beyond, 0.01), UnseenStops{});
  EXPECT_EQ(unseen_stops(fill, beyond, 0.11), (UnseenStops{0, 2}));
  fill.spread = SpreadMethod::reflect;
  EXPECT_EQ(unseen_stops(fill, within, 0.01), UnseenStops{});
  fill.spread = SpreadMethod::pad;
  fill.stops = {{1, {}, 1}, {1, {}, 1}};
  EXPECT_EQ(unseen_stops(fill, within, 0.01), UnseenStops{});
  fill.shape = RadialGradient{};
  EXPECT_EQ(unseen_stops(fill, within, 0.01), UnseenStops{});
}

}  // namespace
}  // namespace sfumato
