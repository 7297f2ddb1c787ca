// The quality measures of traces, compared with closed forms and a readable reference.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/draw.hpp"
#include "support/drawing.hpp"
#include "support/found_curves.hpp"
#include "support/picture_quality.hpp"
#include "support/synthetic_photo.hpp"

namespace sfumato {
namespace {

Image one_color_image(int side, std::uint8_t value) {
  Image image{side, side, PixelFormat::rgb8, {}};
  image.bytes.assign(3 * static_cast<std::size_t>(side) * side, value);
  return image;
}

test::Planes even(int side, std::uint8_t value) {
  return test::planes_of(one_color_image(side, value));
}

TEST(Psnr, is_that_of_the_difference) {
  EXPECT_NEAR(test::psnr_db(even(20, 100), even(20, 151)), -20 * std::log10(0.2), 1e-5);
  EXPECT_TRUE(std::isinf(test::psnr_db(even(20, 7), even(20, 7))));
}

TEST(Psnr, takes_alpha_as_on_the_background) {
  Image image{1, 1, PixelFormat::rgba8, {255, 255, 255, 51}};
  EXPECT_NEAR(test::planes_of(image, {0, 0, 0})[0].at(0, 0), 0.2, 1e-6);
  EXPECT_NEAR(test::planes_of(image, {1, 1, 1})[0].at(0, 0), 1, 1e-6);
}

TEST(Ssim, of_even_pictures_compares_their_means) {
  const double a = 0.2, b = 0.6, constant = 1e-4;
  EXPECT_NEAR(*test::ssim(even(16, 51), even(16, 153)),
              (2 * a * b + constant) / (a * a + b * b + constant), 1e-4);
}

TEST(Ssim, needs_a_window) {
  EXPECT_FALSE(test::ssim(even(10, 0), even(10, 0)));
  EXPECT_NEAR(*test::ssim(even(11, 0), even(11, 0)), 1, 1e-6);
}

/// Returns the value by definition, window by window.
double reference_ssim(const test::Plane& a, const test::Plane& b) {
  double sum = 0;
  int count = 0;
  for (int y = 5; y < a.height - 5; ++y) {
    for (int x = 5; x < a.width - 5; ++x, ++count) {
      double weight = 0, ma = 0, mb = 0, va = 0, vb = 0, vab = 0;
      for (const bool second : {false, true}) {
        for (int j = -5; j <= 5; ++j) {
          for (int i = -5; i <= 5; ++i) {
            const double w = std::exp(-(i * i + j * j) / 4.5);
            const double p = a.at(x + i, y + j), q = b.at(x + i, y + j);
            if (!second) {
              weight += w, ma += w * p, mb += w * q;
            } else {
              va += w * (p - ma) * (p - ma), vb += w * (q - mb) * (q - mb);
              vab += w * (p - ma) * (q - mb);
            }
          }
        }
        if (!second) ma /= weight, mb /= weight;
      }
      va /= weight, vb /= weight, vab /= weight;
      sum +=
          (2 * ma * mb + 1e-4) * (2 * vab + 9e-4) / ((ma * ma + mb * mb + 1e-4) * (va + vb + 9e-4));
    }
  }
  return sum / count;
}

TEST(Ssim, is_its_definition) {
  const test::Planes a = test::planes_of(test::synthetic_photo(48, 1));
  const test::Planes b = test::planes_of(test::synthetic_photo(48, 2));
  const double reference =
      (reference_ssim(a[0], b[0]) + reference_ssim(a[1], b[1]) + reference_ssim(a[2], b[2])) / 3;
  EXPECT_LT(reference, 0.99);
  EXPECT_NEAR(*test::ssim(a, b), reference, 1e-4);
}

Document circle_at(Vec2 center, Rgb inside = test::kWhite) {
  return test::one_layer({test::colored(test::circle_curve(center, 30), test::kBlack, inside)});
}

test::Planes planes_of_drawing(const Document& document) {
  Context context;
  const Result<Image> image = test::draw(context, document, 200, 200, PixelFormat::rgb8);
  EXPECT_TRUE(image.ok()) << to_string(image.status());
  return image.ok() ? test::planes_of(*image) : even(200, 0);
}

TEST(FoundCurves, finds_a_drawing_in_itself) {
  const Document circle = circle_at({50, 50});
  const test::FoundCurves found = test::find_curves(circle, circle, planes_of_drawing(circle));
  EXPECT_NEAR(found.true_length_px, 2 * std::numbers::pi * 60, 0.5);
  EXPECT_EQ(found.visible_share, 1);
  EXPECT_EQ(found.found_share, 1);
  EXPECT_EQ(found.true_share, 1);
  EXPECT_EQ(found.mean_distance_px, 0);
}

TEST(FoundCurves, measures_how_far_a_trace_is_off) {
  const Document circle = circle_at({50, 50});
  // Half a unit is a pixel; across the circle's direction it is 2/π of that on the mean.
  const test::FoundCurves near =
      test::find_curves(circle, circle_at({50.5, 50}), planes_of_drawing(circle));
  EXPECT_EQ(near.found_share, 1);
  EXPECT_NEAR(near.mean_distance_px, 2 / std::numbers::pi, 0.05);
  // Six pixels: near where |cos| is below a third.
  const test::FoundCurves far =
      test::find_curves(circle, circle_at({53, 50}), planes_of_drawing(circle));
  const double share = 2 / std::numbers::pi * std::asin(1.0 / 3);
  EXPECT_NEAR(far.found_share, share, 0.03);
  EXPECT_NEAR(far.true_share, share, 0.03);
}

TEST(FoundCurves, counts_what_can_be_seen) {
  Document document = circle_at({35, 50});
  const Curve hidden = test::circle_curve({85, 50}, 10);
  document.layers[0].curves.push_back(test::colored(hidden, test::kBlack, test::kBlack));
  const test::FoundCurves found =
      test::find_curves(document, circle_at({35, 50}), planes_of_drawing(document));
  EXPECT_NEAR(found.visible_share, 0.75, 0.01);
  EXPECT_EQ(found.found_share, 1);
}

TEST(FoundCurves, finds_nothing_in_nothing) {
  const Document circle = circle_at({50, 50});
  const test::FoundCurves found =
      test::find_curves(circle, test::one_layer({}), planes_of_drawing(circle));
  EXPECT_EQ(found.found_share, 0);
  EXPECT_EQ(found.true_share, 0);
}

}  // namespace
}  // namespace sfumato
