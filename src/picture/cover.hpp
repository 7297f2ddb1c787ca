#pragma once

#include "sfumato/picture/picture.hpp"

namespace sfumato::picture {

/// Returns whether one opaque layer of the picture paints all of a box of the artboard frame. Then
/// the box shows nothing of a background, and drawing it needs no alpha. Cost: O(triangles).
bool covers(const Picture& picture, const Box& box);

}  // namespace sfumato::picture
