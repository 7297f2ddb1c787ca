#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "formats/svg/read/input.hpp"
#include "formats/svg/style/plain_style.hpp"
#include "sfumato/base/affine.hpp"
#include "sfumato/base/box.hpp"

namespace sfumato::svg {

/// A marker whose content is being drawn on a vertex.
struct DrawnMarker {
  Element element;
  std::vector<Element> around;  ///< it in the document, the outermost first, which it inherits from
  ContextPaints context;        ///< of the shape that has the marker
  Affine frame_from_viewport;
  std::optional<Box> clip;             ///< its viewport; none: nothing is cut off
  const DrawnMarker* outer = nullptr;  ///< the marker around that shape
};

/// Returns whether the marker is being drawn already.
bool is_drawn(const DrawnMarker* innermost, Element marker);

/// Markers within each other, the innermost included.
std::size_t depth_of(const DrawnMarker* innermost);

/// Returns whether the marker cuts something off a box in its content.
bool cuts(const DrawnMarker& marker, const Affine& frame_from_user, const Box& box);

}  // namespace sfumato::svg
