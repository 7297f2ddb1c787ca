#pragma once

#include <cstdint>

#include "sfumato/base/image.hpp"

namespace sfumato::test {

/// Returns a picture with typical features of photos, made by formula: a background of two
/// gradients, a sharp shaded ball, a disc out of focus, a soft shadow, a bright bar, and noise of
/// standard deviation 2/255. A `width` of 240 works well; the height is 3/4 of it. `seed` is for
/// the noise.
Image synthetic_photo(int width, std::uint32_t seed = 1);

}  // namespace sfumato::test
