#pragma once

#include <optional>
#include <string_view>

#include "formats/css/tokenizer.hpp"

namespace sfumato::css {

/// Bytes of the name of a custom property that is read.
inline constexpr std::size_t kVariableNameBytes = 256;

/// Returns whether a declaration's name is that of a custom property that is read: "--" and more,
/// without escapes, of at most kVariableNameBytes.
bool is_variable_name(std::string_view raw_name);

/// A var() in a value.
struct VariableReference {
  std::string_view name{};                     ///< of the custom property
  std::optional<std::string_view> fallback{};  ///< may be empty
};

/// Returns whether a token begins var(…).
inline bool begins_variable(const Token& token) {
  return token.is(TokenType::function) && is_named(token.value, "var");
}

/// Consumes the rest of a var(…) whose first token is taken; no value if it is invalid.
std::optional<VariableReference> take_variable(Tokenizer& tokens);

enum class Variables : unsigned char { none, valid, invalid };

/// Whether a value has var(), and all of them are valid.
Variables variables_in(std::string_view value, TextPoll& poll);

}  // namespace sfumato::css
