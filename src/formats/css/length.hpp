#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "formats/css/tokenizer.hpp"
#include "sfumato/base/vec2.hpp"

namespace sfumato::css {

/// The units of lengths; `number` has none.
enum class Unit : std::uint8_t {
  number,
  percent,
  px,
  pt,
  pc,
  mm,
  cm,
  in,
  q,  ///< a quarter of a millimetre
  em,
  ex,
  ch,
  rem,
  vw,
  vh,
  vmin,
  vmax
};

struct Length {
  double value = 0;
  Unit unit = Unit::number;
};

/// The sizes to which units of fonts and of the viewport refer, in px.
struct UnitSizes {
  double em = 16;  ///< the element's font size
  double rem = 16;
  Vec2 viewport{};
};

/// Returns the unit with this name, in any case; "%" is one, and "" is Unit::number.
std::optional<Unit> unit_of(std::string_view name);

/// Returns whether a unit needs UnitSizes.
inline bool is_relative(Unit unit) {
  return unit >= Unit::em;
}

/// Returns the length of a number, a percentage, or a dimension with a known unit; else no value.
std::optional<Length> length_of(const Token& token);

/// Returns a length in px. `ex` and `ch` are half an `em`, because no font is known.
/// whole   the value of 100%
double in_pixels(const Length& length, const UnitSizes& sizes, double whole);

/// Returns the font size of an element (`font-size`). `outer`: the sizes of its parent; percentages
/// and em refer to these. No value if the text is no font size.
/// needs_unit   a number has a unit unless it is 0
std::optional<double> font_size_of(std::string_view text, const UnitSizes& outer, bool needs_unit,
                                   TextPoll& poll);

}  // namespace sfumato::css
