#pragma once

/// Transfer functions of CSS Color 4, mirrored for negative values.
namespace sfumato::color {

double linear_from_srgb(double code);
double srgb_from_linear(double linear);
double linear_from_a98(double code);       ///< |x|^(563/256)
double linear_from_prophoto(double code);  ///< |x|^1.8, linear near 0
double linear_from_rec2020(double code);   ///< |x|^2.4: referred to a display

}  // namespace sfumato::color
