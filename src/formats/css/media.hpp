#pragma once

#include <cstdint>
#include <string_view>

#include "formats/css/tokenizer.hpp"

namespace sfumato::css {

/// Whether a list of media queries matches a picture on a screen.
enum class Media : std::uint8_t {
  matches,
  differs,
  unknown  ///< it tests features, which are not evaluated
};

/// Reads "screen", "all and (color), not print" and the like; an empty list matches, an invalid
/// query does not.
Media media_of(std::string_view queries, TextPoll& poll);

}  // namespace sfumato::css
