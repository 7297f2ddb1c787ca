#pragma once

#include <string_view>

#include "sfumato/base/box.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::svg {

/// The length to which a percentage refers.
enum class Axis : unsigned char {
  x,        ///< the viewport's width
  y,        ///< its height
  diagonal  ///< its diagonal divided by √2
};

/// Reads a length as user units: a number, or with px, pt, pc, mm, cm, in (96 px each), or % of the
/// viewport. em and other font units are errors. Errors: bad_input, without a place.
Result<double> parse_length(std::string_view text, const Box& viewport, Axis axis);

/// The viewport's size along an axis.
double extent(const Box& viewport, Axis axis);

}  // namespace sfumato::svg
