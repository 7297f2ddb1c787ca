#pragma once

#include <cstdint>
#include <vector>

#include "sfumato/base/image.hpp"
#include "sfumato/document/document.hpp"

namespace sfumato::test {

/// The differences of two RGB pictures of one document, one pixel per artboard unit.
struct Agreement {
  int compared = 0;       ///< pixels away from sharp curves
  int differing = 0;      ///< compared pixels with a difference above 3 code values in some channel
  int percentile_99 = 0;  ///< code values
  int worst = 0;          ///< code values
  int worst_x = 0;
  int worst_y = 0;
};

/// Returns a value per pixel: 1 next to a curve where a layer may jump, and around ends and joints
/// of curves, where its slope has no bound.
std::vector<std::uint8_t> sharp_pixels(const Document& document, int width, int height);

/// Compares two rgb8 images of the artboard's size.
Agreement compare_pictures(const Document& document, const Image& a, const Image& b);

}  // namespace sfumato::test
