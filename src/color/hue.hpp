#pragma once

#include "sfumato/base/color.hpp"

namespace sfumato::color {

/// Converts HSL to sRGB: the hue in turns, 0 up to 1; saturation and lightness from 0 to 1.
Rgb rgb_from_hsl(double turns, double saturation, double lightness);

/// Converts HWB to sRGB: whiteness and blackness from 0 to 1; a gray where their sum is 1 or more.
Rgb rgb_from_hwb(double turns, double white, double black);

}  // namespace sfumato::color
