#pragma once

#include <optional>

#include "formats/svg/read/input.hpp"
#include "formats/svg/read/plain_svg.hpp"
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

/// The viewBox of <svg>, whose coordinates are in range. Errors: bad_input.
Result<std::optional<Box>> read_view_box(Input& input);

/// Returns width and height of an <svg> without a viewBox, if they are lengths above 0. A
/// percentage does not count, because it refers to the program that shows the picture. A value that
/// cannot be read is ignored with a warning.
OpenSize read_open_size(Input& input);

/// Returns the transform of <svg> as a map of the viewBox's plane. Errors: bad_input.
Result<Affine> root_map(Input& input, const PictureFrame& frame);

/// Sets the artboard and the size; a stretch is applied to everything that is painted.
void show_in_frame(const PictureFrame& frame, Document& document);

}  // namespace sfumato::svg
