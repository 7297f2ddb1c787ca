#pragma once

#include <cstddef>
#include <string_view>

#include "formats/css/tokenizer.hpp"
#include "sfumato/base/function_ref.hpp"

namespace sfumato::css {

/// "name: value" or "name: value !important" as it was written.
struct Declaration {
  std::string_view name{};   ///< raw: is_name(), unescaped()
  std::string_view value{};  ///< raw, trimmed, without the importance; perhaps empty
  bool is_important = false;
};

/// What stands between the braces of a rule, or in a style attribute: CSS Syntax 3, "consume a
/// block's contents". Rules within are passed over. Tells `sink` each declaration in its turn;
/// whether the name and the value mean anything is the caller's to say.
///
/// in_block    the text goes on behind the block: a '}' ends it, and is taken
/// Returns     whether anything was passed over that is no declaration.
/// Cost        linear in the text.
bool read_declarations(Tokenizer& tokens, bool in_block,
                       FunctionRef<void(const Declaration&)> sink);

}  // namespace sfumato::css
