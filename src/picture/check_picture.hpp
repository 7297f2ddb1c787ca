#pragma once

#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato::picture {

/// Whether a map into pixels is such that squares of its coordinates do not overflow.
bool is_moderate(const Affine& m);

/// Whether the tables of every layer fit together, positions are finite, layers and shaders that
/// are named are there, opacities lie in [0, 1], groups are closed, and shaders and strokes are as
/// `validate` wants them: what painting relies on. Node values may be anything. Errors: bad_input,
/// limit (stack items, group depth, shaders of a layer), cancelled.
Status check_picture(const Context& context, const Picture& picture);

}  // namespace sfumato::picture
