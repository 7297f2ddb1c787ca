#pragma once

#include <array>
#include <span>
#include <vector>

#include "sfumato/base/color.hpp"
#include "sfumato/base/image.hpp"

namespace sfumato::test {

/// One number for each pixel, row by row.
struct Plane {
  int width = 0;
  int height = 0;
  std::vector<float> value;

  float at(int x, int y) const { return value[static_cast<std::size_t>(y) * width + x]; }
};

/// Red, green and blue of a picture: sRGB code values from 0 to 1.
using Planes = std::array<Plane, 3>;

/// Returns an image on a background, which shows through its alpha.
Planes planes_of(const Image& image, Rgb background = {1, 1, 1});

/// Returns weights of a Gaussian from -radius to radius, or with `slope` of its derivative (a plane
/// that rises by 1 a pixel gives 1).
std::vector<double> gaussian_weights(double sigma, int radius, bool slope = false);

/// Returns the plane filtered with weights for rows and then for columns; it is mirrored at its
/// edges.
Plane filtered(const Plane& plane, std::span<const double> across, std::span<const double> down);

}  // namespace sfumato::test
