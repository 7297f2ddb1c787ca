#pragma once

#include <cstddef>
#include <string_view>

#include "formats/css/tokenizer.hpp"
#include "sfumato/base/function_ref.hpp"

namespace sfumato::css {

/// "name: value" or "name: value !important" as it was written.
struct Declaration {
  std::string_view name{};   ///< raw: is_name(), unescaped()
  std::string_view value{};  ///< raw, trimmed, without the importance; may be empty
  bool is_important = false;
};

/// Reads the content between the braces of a rule, or of a style attribute: CSS Syntax 3, "consume
/// a block's contents". Nested rules are skipped. Calls `sink` with each declaration in order; the
/// caller decides whether name and value are known.
///
/// in_block    the text continues after the block: a '}' ends the block and is consumed
/// Returns     whether anything but declarations was skipped.
/// Cost        linear in the text.
bool read_declarations(Tokenizer& tokens, bool in_block,
                       FunctionRef<void(const Declaration&)> sink);

}  // namespace sfumato::css
