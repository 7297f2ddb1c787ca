#include "formats/css/media.hpp"

#include "formats/css/value.hpp"

namespace sfumato::css {
namespace {

using enum TokenType;

bool is_word(const Token& token, std::string_view word) {
  return token.is(ident) && is_named(token.value, word);
}

bool is_end(const Token& token) {
  return token.is(end) || token.is(comma);
}

/// Passes over the rest of a query; its comma, or the end.
Token rest_of_query(Tokenizer& tokens, Token token) {
  while (!is_end(token)) {
    skip_component(tokens, token);
    token = next_solid(tokens);
  }
  return token;
}

Media negated(Media media) {
  if (media == Media::unknown) return media;
  return media == Media::matches ? Media::differs : Media::matches;
}

/// Reads a media type and its further conditions. `token`: the type; then the token that ends the
/// query.
Media type_query(Tokenizer& tokens, Token& token) {
  for (const std::string_view reserved : {"not", "only", "and", "or", "layer"}) {
    if (is_word(token, reserved)) return Media::differs;
  }
  const bool fits = is_word(token, "screen") || is_word(token, "all");
  token = next_solid(tokens);
  if (is_end(token)) return fits ? Media::matches : Media::differs;
  return fits && is_word(token, "and") ? Media::unknown : Media::differs;
}

/// Reads one query. `token`: its first token; then a token in it or the token that ends it.
Media query(Tokenizer& tokens, Token& token) {
  if (token.is(open_paren)) return Media::unknown;
  const bool is_negated = is_word(token, "not");
  if (is_negated || is_word(token, "only")) {
    token = next_solid(tokens);
    if (is_negated && token.is(open_paren)) return Media::unknown;
  }
  if (!token.is(ident)) return Media::differs;
  const bool is_type = !is_word(token, "and") && !is_word(token, "or");
  const Media media = type_query(tokens, token);
  const bool is_whole = is_end(token) || is_word(token, "and");
  return is_negated && is_type && is_whole ? negated(media) : media;
}

}  // namespace

Media media_of(std::string_view queries, TextPoll& poll) {
  Tokenizer tokens(queries, poll);
  Token token = next_solid(tokens);
  if (token.is(end)) return Media::matches;
  Media media = Media::differs;
  for (;; token = next_solid(tokens)) {
    const Media one = query(tokens, token);
    if (one == Media::matches) return one;
    if (one == Media::unknown) media = one;
    token = rest_of_query(tokens, token);
    if (token.is(end)) return media;
  }
}

}  // namespace sfumato::css
