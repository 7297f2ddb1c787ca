#pragma once

#include "solve/layers/prepare_layer.hpp"

namespace sfumato::solve {

/// Returns whether gathering at the pixels of a layer that is shown once, in the window, costs less
/// than solving its patches. pixel: the side of a pixel, layer units.
bool pixels_cost_less(const curves::FlatCurves& flat, const Box& window, double pixel);

/// Returns whether all points of a layer show a colour that can be interpolated from pixel to
/// pixel: the layer is opaque, both sides of its curves have colours, and none has an image-domain
/// shader.
bool has_plain_colors(const SampledFields& fields);

}  // namespace sfumato::solve
