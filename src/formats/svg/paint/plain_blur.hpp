#pragma once

#include <optional>

#include "formats/svg/paint/paints.hpp"
#include "formats/svg/read/input.hpp"

namespace sfumato::svg {

/// Returns the standard deviation, in user units of the element, if its filter does nothing but
/// blur evenly: one <feGaussianBlur> with one deviation, or blur() of CSS. No value for any other
/// filter, and for none.
std::optional<double> gaussian_blur(Input& input, Element element);

/// Returns whether the filter region of a shape cuts off a visible part of its blur.
/// around      how far the paint reaches beyond the shape's box, in user space
/// deviation   what gaussian_blur() returned
bool cuts_blur(Input& input, const PaintedShape& shape, double around, double deviation);

}  // namespace sfumato::svg
