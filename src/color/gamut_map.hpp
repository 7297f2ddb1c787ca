#pragma once

#include "color/matrix.hpp"
#include "sfumato/base/color.hpp"

namespace sfumato::color {

/// A colour as sRGB can show it.
struct SrgbColor {
  Rgb color;
  /// Whether the colour lay outside sRGB, by more than rounding of written components causes: a
  /// tenth of the just noticeable difference.
  bool is_mapped = false;
};

/// Returns the sRGB colour for a colour in XYZ (D65). A colour outside sRGB is mapped as CSS Color
/// 4, section 13, defines: a binary search reduces chroma in OKLCH until clipping makes no visible
/// difference. White for lightness of 1 and more, black for 0 and less.
///
/// - `xyz`: coordinates within some thousands in any space of CSS
///
/// Cost: up to 12 steps of three cube roots for a colour outside.
SrgbColor map_to_srgb(const Triple& xyz);

}  // namespace sfumato::color
