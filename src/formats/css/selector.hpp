#pragma once

#include <cstdint>
#include <string_view>

#include "formats/css/tokenizer.hpp"

namespace sfumato::css {

/// What one selector of a list is.
struct Selector {
  enum class Kind : std::uint8_t {
    any,       ///< *
    element,   ///< name
    of_class,  ///< .name
    id,        ///< #name
    other,     ///< CSS has such, but it is none of these
    invalid    ///< CSS drops the rule
  };

  Kind kind = Kind::invalid;
  std::string_view name{};  ///< raw: unescaped()
  std::string_view text{};  ///< all of it
  bool is_last = false;
};

/// Takes the next selector of a list, up to its comma or the end of the text.
Selector take_selector(Tokenizer& tokens);

}  // namespace sfumato::css
