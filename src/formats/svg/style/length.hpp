#pragma once

#include <string_view>

#include "formats/css/length.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::svg {

/// The length to which a percentage refers.
enum class Axis : unsigned char {
  x,        ///< the viewport's width
  y,        ///< its height
  diagonal  ///< its diagonal divided by √2
};

/// Reads a number with a unit of CSS or none, as in attributes. Errors: bad_input, without a place.
Result<css::Length> read_length(std::string_view text);

/// Returns a length in user units, for an element whose units have these sizes; percentages are of
/// the viewport. `text`: the length as written, for the message. Errors: bad_input, without a
/// place.
Result<double> user_length(const css::Length& length, const css::UnitSizes& sizes,
                           const Box& viewport, Axis axis, std::string_view text);

/// Reads a length where no font is known: units of fonts and of the picture's size are errors.
/// Errors: bad_input, without a place.
Result<double> parse_length(std::string_view text, const Box& viewport, Axis axis);

/// Returns the viewport's size along an axis.
double extent(const Box& viewport, Axis axis);

}  // namespace sfumato::svg
