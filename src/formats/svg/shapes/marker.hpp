#pragma once

#include <cstdint>
#include <optional>

#include "formats/svg/read/input.hpp"
#include "formats/svg/shapes/marker_vertices.hpp"
#include "formats/svg/shapes/view_box.hpp"
#include "sfumato/base/affine.hpp"
#include "sfumato/base/box.hpp"

namespace sfumato::svg {

/// The attributes of a <marker> (SVG 2, 13.7.1).
struct Marker {
  enum class Orient : std::uint8_t { angle, along, along_start_reversed };

  Element element;
  bool is_of_stroke_width = true;  ///< markerUnits: lengths are in widths of the stroke
  Vec2 size{3, 3};                 ///< the viewport's; no area: nothing is drawn
  Vec2 reference;                  ///< the content's point that lies on the vertex
  Affine viewport_from_content;
  Orient orient = Orient::angle;
  double degrees = 0;       ///< of Orient::angle
  std::optional<Box> clip;  ///< the viewport, unless overflow is visible

  bool has_area() const { return size.x > 0 && size.y > 0; }
};

/// Reads a marker. viewport: for percentages. Errors: bad_input.
Result<Marker> read_marker(Input& input, Element element, const Box& viewport);

/// Returns the place of the marker's content on a vertex.
/// is_start   the vertex is the first of its shape
Affine user_from_marker(const Marker& marker, const MarkerVertex& vertex, bool is_start,
                        double stroke_width);

}  // namespace sfumato::svg
