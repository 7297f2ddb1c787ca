#pragma once

#include <cstdint>
#include <vector>

#include "sfumato/base/image.hpp"
#include "sfumato/document/document.hpp"

namespace sfumato::test {

/// Two RGB pictures of one document held against each other, one pixel to an artboard unit.
struct Agreement {
  int compared = 0;       ///< pixels away from what is sharp
  int differing = 0;      ///< of those: by more than 3 code values in some channel
  int percentile_99 = 0;  ///< code values
  int worst = 0;          ///< code values
  int worst_x = 0;
  int worst_y = 0;
};

/// Per pixel: 1 next to a curve across which a layer may jump, and around ends and joints of
/// curves, where its slope has no bound.
std::vector<std::uint8_t> sharp_pixels(const Document& document, int width, int height);

/// Both images are rgb8 and of the artboard's size.
Agreement compare_pictures(const Document& document, const Image& a, const Image& b);

}  // namespace sfumato::test
