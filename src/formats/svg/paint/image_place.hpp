#pragma once

#include "formats/svg/read/input.hpp"
#include "formats/svg/shapes/view_box.hpp"
#include "sfumato/base/box.hpp"

namespace sfumato::svg {

/// The viewport of an <image>, in its user space. A width or height that is `auto` follows from the
/// image's own size and aspect ratio. `natural`: the image's size in px. The result may be empty or
/// inverted. Errors: bad_input.
Result<Box> read_image_box(Input& input, const StyleScope& scope, const Box& viewport,
                           Vec2 natural);

/// `preserveAspectRatio` of the element; the initial value if it is null or has none.
/// Errors: bad_input.
Result<AspectRatio> read_aspect_ratio(Input& input, Element bearer);

}  // namespace sfumato::svg
