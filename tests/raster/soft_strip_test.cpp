#include "raster/coverage/soft_strip.hpp"

#include <gtest/gtest.h>

#include "curves/front_share.hpp"

namespace sfumato::raster {
namespace {

/// Returns the distance, in radii, where 1 - β is `share`.
double distance_of(double share) {
  double near = 0, far = 1;
  for (int i = 0; i < 50; ++i) {
    const double middle = (near + far) / 2;
    (1 - curves::front_share(middle, 1.0) > share ? near : far) = middle;
  }
  return near;
}

TEST(SoftStrip, every_strip_reaches_the_mean_of_its_eighth_of_the_blur) {
  constexpr int kSteps = 4000;
  for (int strip = 0; strip < kStrips; ++strip) {
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) sum += distance_of((3 - strip + (i + 0.5) / kSteps) / 8);
    EXPECT_NEAR(kStripReach[strip], sum / kSteps, 1e-4) << strip;
  }
}

}  // namespace
}  // namespace sfumato::raster
