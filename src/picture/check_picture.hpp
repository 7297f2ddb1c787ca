#pragma once

#include <cstdint>

#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato::picture {

/// Returns whether a map into pixels is so small that squares of its coordinates do not overflow.
bool is_moderate(const Affine& m);

/// The longest side of an image, in pixels.
inline constexpr int kLargestImageSide = 1 << 24;

/// Returns whether an image of any size can show the viewport: the map into its pixels is moderate.
bool can_be_drawn(const Box& viewport);

/// The outputs that a picture is checked for.
enum class PictureUse : std::uint8_t {
  pixels,  ///< rasterize()
  any      ///< all others: they take no picture for a pixel grid
};

/// Checks all conditions that painting relies on: the tables of every layer are consistent,
/// positions are finite, named layers and shaders exist, opacities lie in [0, 1], groups are
/// closed, and `validate` accepts shaders and strokes. Node values may be any numbers. Errors:
/// bad_input, limit (stack items, group depth, shaders of a layer), cancelled.
Status check_picture(const Context& context, const Picture& picture,
                     PictureUse use = PictureUse::any);

}  // namespace sfumato::picture
