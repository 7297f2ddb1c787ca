#pragma once

#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato::picture {

/// Whether a map into pixels is so small that squares of its coordinates do not overflow.
bool is_moderate(const Affine& m);

/// Checks everything on which painting relies: the tables of every layer are consistent, positions
/// are finite, named layers and shaders exist, opacities lie in [0, 1], groups are closed, and
/// `validate` accepts shaders and strokes. Node values may be anything. Errors: bad_input, limit
/// (stack items, group depth, shaders of a layer), cancelled.
Status check_picture(const Context& context, const Picture& picture);

}  // namespace sfumato::picture
