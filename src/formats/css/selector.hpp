#pragma once

#include <cstdint>
#include <string_view>

#include "formats/css/tokenizer.hpp"

namespace sfumato::css {

/// One selector of a list.
struct Selector {
  enum class Kind : std::uint8_t {
    any,       ///< *
    element,   ///< name
    of_class,  ///< .name
    id,        ///< #name
    other,     ///< valid CSS, but not one of these
    invalid    ///< CSS drops the rule
  };

  Kind kind = Kind::invalid;
  std::string_view name{};  ///< raw: unescaped()
  std::string_view text{};  ///< all of it
  bool is_last = false;
};

/// Consumes the next selector of a list, up to its comma or the end of the text.
Selector take_selector(Tokenizer& tokens);

}  // namespace sfumato::css
