#include "formats/css/variables.hpp"

#include "base/text/ascii.hpp"
#include "formats/css/value.hpp"

namespace sfumato::css {
namespace {

using enum TokenType;

/// The text up to the parenthesis that closes the function, which is taken.
std::string_view take_fallback(Tokenizer& tokens) {
  const std::size_t begin = tokens.position();
  for (;;) {
    const std::size_t before = tokens.position();
    const Token token = tokens.next();
    if (token.is(close_paren) || token.is(end)) {
      return ascii_trimmed(tokens.text().substr(begin, before - begin));
    }
    skip_component(tokens, token);
  }
}

}  // namespace

bool is_variable_name(std::string_view raw_name) {
  return raw_name.size() > 2 && raw_name.size() <= kVariableNameBytes &&
         raw_name.starts_with("--") && raw_name.find('\\') == std::string_view::npos;
}

std::optional<VariableReference> take_variable(Tokenizer& tokens) {
  const Token name = next_solid(tokens);
  if (!name.is(ident) || !name.value.starts_with("--")) return std::nullopt;
  VariableReference reference{name.value};
  const Token next = next_solid(tokens);
  if (next.is(comma)) {
    reference.fallback = take_fallback(tokens);
  } else if (!next.is(close_paren) && !next.is(end)) {
    return std::nullopt;
  }
  return reference;
}

Variables variables_in(std::string_view value, TextPoll& poll) {
  if (value.find('(') == std::string_view::npos) return Variables::none;
  Tokenizer tokens(value, poll);
  Variables found = Variables::none;
  for (Token token = tokens.next(); !token.is(end); token = tokens.next()) {
    if (!begins_variable(token)) continue;
    found = Variables::valid;
    // The fallback is looked through as well: it may hold others.
    const std::size_t inside = tokens.position();
    const Token name = next_solid(tokens);
    const Token next = next_solid(tokens);
    const bool is_valid = name.is(ident) && name.value.starts_with("--") &&
                          (next.is(comma) || next.is(close_paren) || next.is(end));
    if (!is_valid) return Variables::invalid;
    tokens.rewind(inside);
  }
  return found;
}

}  // namespace sfumato::css
