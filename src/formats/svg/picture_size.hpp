#pragma once

#include <optional>

#include "formats/svg/input.hpp"
#include "sfumato/base/affine.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/base/vec2.hpp"
#include "sfumato/document/document.hpp"

namespace sfumato::svg {

/// The result of width, height and preserveAspectRatio of <svg> for its viewBox.
struct PictureFrame {
  Box artboard;                   ///< the region shown; contains the viewBox or cuts it
  Affine artboard_from_view_box;  ///< a stretch, for preserveAspectRatio="none"; else the identity
  std::optional<Vec2> size_px;    ///< as Document::size_px
};

/// As in browsers and resvg: one of width and height determines the other by the viewBox;
/// percentages refer to the viewBox, and count only if both are percentages; if the aspect differs,
/// the picture shows more than the viewBox (meet), a part of it (slice), or is stretched (none). A
/// value that cannot be read is ignored with a warning.
PictureFrame read_picture_frame(Input& input, const Box& view_box);

/// Sets the artboard and the size; a stretch is applied to everything that is painted.
void show_in_frame(const PictureFrame& frame, Document& document);

}  // namespace sfumato::svg
