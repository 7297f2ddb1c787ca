#pragma once

#include "formats/svg/read/input.hpp"
#include "sfumato/base/affine.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::svg {

/// Returns the map from an element's user space to that of its parent: the attribute `transform` or
/// the property of CSS, about `transform-origin` in the box of `transform-box` (CSS Transforms 1).
/// `viewport`: the nearest one. Errors: bad_input, limit, cancelled, out_of_memory.
Result<Affine> element_transform(Input& input, Element element, const Box& viewport);

/// Returns the map that the root's `transform` makes in a standalone SVG: of px, about the middle
/// of the picture unless transform-origin says otherwise. Errors: as above.
Result<Affine> root_transform(Input& input, Vec2 size_px);

/// Returns whether the element has `transform`, or `translate`, `rotate` or `scale` in a style.
bool has_transform(Input& input, Element element);

/// Returns whether a gradient or pattern has a `transform` in a style.
bool has_transform_style(Input& input, Element paint);

/// The transform of a gradient or pattern: the property `transform` of a style, or the attribute
/// with this name, about transform-origin, whose percentages are of the viewport. Errors: as above.
/// Precondition: it has one of them.
Result<Affine> paint_transform(Input& input, Element paint, const char* attribute,
                               const Box& viewport);

/// Returns the bounding box of the shapes in an element, in its user space. Errors: as above.
Result<Box> content_box(Input& input, Element element, const Box& viewport);

/// Returns the box of the nearest viewport: at the origin, of the size of its viewBox (CSS
/// Transforms 1, `view-box`).
Box view_box_of(Input& input, Element element, const Box& viewport);

}  // namespace sfumato::svg
