#pragma once

#include <optional>

#include "formats/svg/input.hpp"
#include "sfumato/base/affine.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/base/vec2.hpp"
#include "sfumato/document/document.hpp"

namespace sfumato::svg {

/// What width, height and preserveAspectRatio of <svg> make of its viewBox.
struct PictureFrame {
  Box artboard;                   ///< what the picture shows, the viewBox in it or cut by it
  Affine artboard_from_view_box;  ///< a stretch, for preserveAspectRatio="none"; else the identity
  std::optional<Vec2> size_px;    ///< as Document::size_px
};

/// As browsers and resvg have it: one of width and height sets the other by the viewBox;
/// percentages are of the viewBox, and count where both are; where the aspect differs, the picture
/// shows more than the viewBox (meet), a part of it (slice), or is stretched (none). What cannot be
/// read is told in a warning and left out.
PictureFrame read_picture_frame(Input& input, const Box& view_box);

/// Sets the artboard and the size; a stretch goes to all that is painted.
void show_in_frame(const PictureFrame& frame, Document& document);

}  // namespace sfumato::svg
