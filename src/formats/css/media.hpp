#pragma once

#include <cstdint>
#include <string_view>

#include "formats/css/tokenizer.hpp"

namespace sfumato::css {

/// Whether a list of media queries means a picture on a screen.
enum class Media : std::uint8_t {
  matches,
  differs,
  unknown  ///< it asks for features, which are not looked at
};

/// Reads "screen", "all and (color), not print" and the like; an empty list matches, what is no
/// query matches nothing.
Media media_of(std::string_view queries, TextPoll& poll);

}  // namespace sfumato::css
