#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "formats/css/length.hpp"
#include "formats/css/properties.hpp"
#include "formats/css/tokenizer.hpp"
#include "sfumato/base/function_ref.hpp"

namespace sfumato::css {

/// One function of the property `transform`.
struct TransformFunction {
  enum class Kind : std::uint8_t {
    matrix,     ///< number: a to f
    translate,  ///< offset
    scale,      ///< number: of x and y
    rotate,     ///< number: degrees
    skew        ///< number: degrees of x and y
  };

  Kind kind = Kind::matrix;
  std::array<double, 6> number{};
  std::array<Length, 2> offset{};  ///< x and y
};

/// Reads a value of the property `transform` (CSS Transforms 1, section 13) and calls `sink` with
/// its functions in order. `none` has none. Functions of three dimensions are read where they stay
/// in the plane. False if the value is invalid or not read.
bool read_transform_list(std::string_view text, TextPoll& poll,
                         FunctionRef<void(const TransformFunction&)> sink);

/// Returns the value of `translate`, `rotate` or `scale` (CSS Transforms 2, section 5), which acts
/// outside the element's `transform`. `none` changes nothing. No value if it is invalid, or turns
/// the element out of the plane.
std::optional<TransformFunction> transform_step_of(Property property, std::string_view text,
                                                   TextPoll& poll);

/// Returns the value of `transform-origin`: offsets from the upper left corner of the reference
/// box. No value if it is invalid.
/// needs_unit   numbers have a unit unless they are 0
std::optional<std::array<Length, 2>> transform_origin_of(std::string_view text, bool needs_unit,
                                                         TextPoll& poll);

}  // namespace sfumato::css
