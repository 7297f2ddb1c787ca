#pragma once

#include <vector>

#include "formats/svg/paint/texture_files.hpp"
#include "formats/svg/read/input.hpp"
#include "formats/svg/shapes/path.hpp"
#include "sfumato/base/affine.hpp"
#include "sfumato/base/box.hpp"

namespace sfumato::svg {

/// An <image> of an ordinary SVG: a rectangle and its texture.
struct PlainImage {
  TexturePlace texture;
  Box visible;  ///< the part of the image in its viewport, user space; empty: nothing is drawn
};

/// Reads the file, the viewport and `preserveAspectRatio` (SVG 2, section 12.3).
/// Errors: bad_input, limit, cancelled, out_of_memory.
Result<PlainImage> read_plain_image(Input& input, TextureFiles& files, const StyleScope& scope,
                                    const Affine& artboard_from_user, const Box& viewport);

/// Returns the outline of a box, allocated from `memory`. Errors: limit, cancelled.
Result<std::vector<Subpath>> box_outline(const Context& context, const Box& box,
                                         TableMemory& memory);

}  // namespace sfumato::svg
