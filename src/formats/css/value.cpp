#include "formats/css/value.hpp"

#include <algorithm>
#include <array>
#include <numbers>

#include "base/text/ascii.hpp"
#include "base/text/number.hpp"

namespace sfumato::css {
namespace {

using enum TokenType;

/// A longer text is not a reference within a document.
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

std::optional<double> degrees_of(const Token& token) {
  const auto value = number_of(token);
  if (!value || token.is(number)) return token.is(number) ? value : std::nullopt;
  if (!token.is(dimension)) return std::nullopt;
  if (is_named(token.unit, "deg")) return value;
  if (is_named(token.unit, "grad")) return *value * 0.9;
  if (is_named(token.unit, "rad")) return *value * (180 / std::numbers::pi);
  if (is_named(token.unit, "turn")) return *value * 360;
  return std::nullopt;
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
  if (keyword_of(text, poll) == "normal") return kNormalPaintOrder;
  // Each occurs at most once; missing ones follow in this order.
  constexpr std::array<std::string_view, 3> kParts{"fill", "stroke", "markers"};
  PaintOrder order = kNormalPaintOrder;
  auto named = order.begin();
  Tokenizer tokens(text, poll);
  for (Token token = next_solid(tokens); !token.is(end); token = next_solid(tokens)) {
    const auto is_token = [&](PaintPart part) {
      return is_named(token.value, kParts[static_cast<std::size_t>(part)]);
    };
    const auto part = std::find_if(named, order.end(), is_token);
    if (!token.is(ident) || part == order.end()) return std::nullopt;
    std::rotate(named, part, part + 1);
    ++named;
  }
  if (named == order.begin()) return std::nullopt;
  return order;
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
