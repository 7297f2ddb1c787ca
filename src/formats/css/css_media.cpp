#include "formats/css/css_media.hpp"

#include "formats/css/css_value.hpp"

namespace sfumato {
namespace {

using enum CssTokenType;

bool is_word(const CssToken& token, std::string_view word) {
  return token.is(ident) && css_is_name(token.value, word);
}

bool is_end(const CssToken& token) {
  return token.is(end) || token.is(comma);
}

/// Passes over the rest of a query; its comma, or the end.
CssToken rest_of_query(CssTokenizer& tokens, CssToken token) {
  while (!is_end(token)) {
    skip_component(tokens, token);
    token = next_solid(tokens);
  }
  return token;
}

CssMedia negated(CssMedia media) {
  if (media == CssMedia::unknown) return media;
  return media == CssMedia::matches ? CssMedia::differs : CssMedia::matches;
}

/// A type with what is asked besides. `token`: the type; then what ends the query.
CssMedia type_query(CssTokenizer& tokens, CssToken& token) {
  for (const std::string_view reserved : {"not", "only", "and", "or", "layer"}) {
    if (is_word(token, reserved)) return CssMedia::differs;
  }
  const bool fits = is_word(token, "screen") || is_word(token, "all");
  token = next_solid(tokens);
  if (is_end(token)) return fits ? CssMedia::matches : CssMedia::differs;
  return fits && is_word(token, "and") ? CssMedia::unknown : CssMedia::differs;
}

/// One query. `token`: its first; then some token in it or the one that ends it.
CssMedia query(CssTokenizer& tokens, CssToken& token) {
  if (token.is(open_paren)) return CssMedia::unknown;
  const bool is_negated = is_word(token, "not");
  if (is_negated || is_word(token, "only")) {
    token = next_solid(tokens);
    if (is_negated && token.is(open_paren)) return CssMedia::unknown;
  }
  if (!token.is(ident)) return CssMedia::differs;
  const bool is_type = !is_word(token, "and") && !is_word(token, "or");
  const CssMedia media = type_query(tokens, token);
  const bool is_whole = is_end(token) || is_word(token, "and");
  return is_negated && is_type && is_whole ? negated(media) : media;
}

}  // namespace

CssMedia css_media(std::string_view queries, TextPoll& poll) {
  CssTokenizer tokens(queries, poll);
  CssToken token = next_solid(tokens);
  if (token.is(end)) return CssMedia::matches;
  CssMedia media = CssMedia::differs;
  for (;; token = next_solid(tokens)) {
    const CssMedia one = query(tokens, token);
    if (one == CssMedia::matches) return one;
    if (one == CssMedia::unknown) media = one;
    token = rest_of_query(tokens, token);
    if (token.is(end)) return media;
  }
}

}  // namespace sfumato
