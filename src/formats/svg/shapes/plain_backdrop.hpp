#pragma once

#include <cstdint>
#include <optional>

#include "formats/css/color.hpp"
#include "formats/svg/read/input.hpp"

namespace sfumato::svg {

/// A filter that Illustrator writes into masks.
struct BackdropFilter {
  enum class Kind : std::uint8_t {
    none,     ///< the colours stay
    flood,    ///< the element is laid over one colour
    inverted  ///< each channel is 1 minus its value, with the same alpha
  };
  Kind kind = Kind::none;
  Element filter;      ///< its region is painted
  css::Color color{};  ///< of a flood
};

/// Returns the filter of an element if it is <feFlood> and a normal <feBlend> with it, or one
/// <feColorMatrix> that changes nothing or inverts colours. No value for any other filter, and for
/// none. Errors: bad_input, cancelled.
Result<std::optional<BackdropFilter>> backdrop_filter(Input& input, Element element);

/// Returns whether the content of a mask is one group whose colours a filter inverts. Errors: as
/// above.
Result<bool> is_inverted_mask(Input& input, Element mask);

}  // namespace sfumato::svg
