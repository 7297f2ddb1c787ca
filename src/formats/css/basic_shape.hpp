#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "formats/css/length.hpp"
#include "formats/css/tokenizer.hpp"
#include "sfumato/base/function_ref.hpp"

namespace sfumato::css {

/// The sizes to which the lengths of a basic shape refer.
enum class ReferenceBox : std::uint8_t {
  fill,    ///< fill-box, content-box, padding-box
  stroke,  ///< stroke-box, border-box, margin-box, and where nothing is said
  view     ///< view-box
};

/// A length from one side of a box, or from the other.
struct BoxOffset {
  Length length{};
  bool from_end = false;
};

/// A basic shape of CSS (CSS Shapes 1, and inset(), rect(), xywh() and path() of Shapes 2), or a
/// reference box alone.
struct BasicShape {
  enum class Kind : std::uint8_t {
    box,      ///< all of the reference box
    circle,   ///< radius[0], center
    ellipse,  ///< radius, center
    inset,    ///< edges, corners; rect() too
    xywh,     ///< edges: x, y, width and height; corners
    polygon,  ///< the points go to the sink of read_basic_shape()
    path      ///< path, from the corner of the reference box
  };
  enum class Extent : std::uint8_t { length, closest_side, farthest_side };

  struct Radius {
    Extent extent = Extent::closest_side;
    Length length{};
  };

  Kind kind = Kind::box;
  ReferenceBox box = ReferenceBox::stroke;
  bool even_odd = false;
  std::array<Radius, 2> radius{};
  std::array<BoxOffset, 2> center{{{{50, Unit::percent}}, {{50, Unit::percent}}}};
  std::array<BoxOffset, 4> edges{};  ///< top, right, bottom, left
  /// The radii of the corners, clockwise from the upper left one: along x, then along y.
  std::array<Length, 8> corners{};
  std::string_view path{};
};

/// Reads a value of `clip-path` that is a basic shape, a reference box, or both. No value if it is
/// invalid or not read.
///
/// needs_unit   numbers have a unit unless they are 0
/// point        is called with the points of a polygon: x and y
std::optional<BasicShape> read_basic_shape(std::string_view text, bool needs_unit, TextPoll& poll,
                                           FunctionRef<void(const Length&, const Length&)> point);

/// Returns whether the text is a value of `clip-path`.
bool is_clip_path(std::string_view text, bool needs_unit, TextPoll& poll);

}  // namespace sfumato::css
