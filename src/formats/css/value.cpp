#include "formats/css/value.hpp"

#include <algorithm>
#include <array>

#include "base/ascii.hpp"
#include "base/number.hpp"

namespace sfumato::css {
namespace {

using enum TokenType;

/// What is longer is no reference within a document.
constexpr std::size_t kLongestUrl = std::size_t{1} << 16;

/// Escapes included.
constexpr std::size_t kLongestKeyword = 256;

std::optional<std::string> unescaped_url(std::string_view raw) {
  if (raw.size() > kLongestUrl) return std::nullopt;
  return unescaped(raw);
}

}  // namespace

Token next_solid(Tokenizer& tokens) {
  Token token = tokens.next();
  while (token.is(whitespace)) token = tokens.next();
  return token;
}

std::optional<Token> only_token(std::string_view text, TextPoll& poll) {
  Tokenizer tokens(text, poll);
  const Token token = next_solid(tokens);
  if (token.is(end) || !next_solid(tokens).is(end)) return std::nullopt;
  return token;
}

std::optional<double> number_of(const Token& token) {
  return parse_number(token.value);
}

std::optional<std::string> keyword_of(std::string_view text, TextPoll& poll) {
  const auto token = only_token(text, poll);
  if (!token || !token->is(ident) || token->value.size() > kLongestKeyword) return std::nullopt;
  return ascii_lower(unescaped(token->value));
}

std::optional<double> share_of(std::string_view text, TextPoll& poll) {
  const auto token = only_token(text, poll);
  if (!token || !(token->is(number) || token->is(percentage))) return std::nullopt;
  const auto value = number_of(*token);
  if (!value) return std::nullopt;
  return std::clamp(token->is(percentage) ? *value / 100 : *value, 0.0, 1.0);
}

std::optional<PaintOrder> paint_order_of(std::string_view text, TextPoll& poll) {
  if (keyword_of(text, poll) == "normal") return PaintOrder::fill_first;
  // Each at most once; those that are left out follow in this order.
  constexpr std::array<std::string_view, 3> kParts{"fill", "stroke", "markers"};
  std::array<std::size_t, kParts.size()> place{};  // from 1; 0: left out
  Tokenizer tokens(text, poll);
  std::size_t count = 0;
  for (Token token = next_solid(tokens); !token.is(end); token = next_solid(tokens)) {
    const auto is_token = [&](std::string_view part) { return is_named(token.value, part); };
    const auto part =
        static_cast<std::size_t>(std::ranges::find_if(kParts, is_token) - kParts.begin());
    if (!token.is(ident) || part == kParts.size() || place[part] > 0) return std::nullopt;
    place[part] = ++count;
  }
  if (count == 0) return std::nullopt;
  const bool stroke_first = place[1] > 0 && (place[0] == 0 || place[1] < place[0]);
  return stroke_first ? PaintOrder::stroke_first : PaintOrder::fill_first;
}

std::optional<std::string> take_url(Tokenizer& tokens, const Token& first) {
  if (first.is(url)) return unescaped_url(first.value);
  if (!first.is(function) || !is_named(first.value, "url")) return std::nullopt;
  const Token held = next_solid(tokens);
  if (!held.is(string)) return std::nullopt;
  const Token last = next_solid(tokens);
  if (!last.is(close_paren) && !last.is(end)) return std::nullopt;
  return unescaped_url(held.value);
}

std::optional<std::string> url_of(std::string_view text, TextPoll& poll) {
  Tokenizer tokens(text, poll);
  std::optional<std::string> held = take_url(tokens, next_solid(tokens));
  if (!held || !next_solid(tokens).is(end)) return std::nullopt;
  return held;
}

}  // namespace sfumato::css
