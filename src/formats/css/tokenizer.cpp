#include "formats/css/tokenizer.hpp"

#include <algorithm>
#include <array>

#include "base/text/ascii.hpp"
#include "base/text/number.hpp"
#include "base/text/utf8.hpp"

namespace sfumato::css {
namespace {

using enum TokenType;

/// The deepest nesting of brackets.
constexpr std::size_t kMostBrackets = 1000;

bool is_hex(char c) {
  return hex_value(c) != kNoHexDigit;
}

bool is_name_start(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
         (static_cast<unsigned char>(c) & 0x80) != 0;
}

bool is_name(char c) {
  return is_name_start(c) || is_digit(c) || c == '-';
}

bool is_newline(char c) {
  return c == '\n' || c == '\r' || c == '\f';
}

std::size_t newline_length(std::string_view text, std::size_t at) {
  if (at >= text.size() || !is_newline(text[at])) return 0;
  return text.substr(at, 2) == "\r\n" ? 2 : 1;
}

/// Where the escape ends whose backslash stands at `at`; six digits at most, then one blank.
std::size_t escape_end(std::string_view text, std::size_t at) {
  std::size_t i = at + 1;
  while (i < text.size() && i < at + 7 && is_hex(text[i])) ++i;
  if (i == at + 1) return std::min(i + 1, text.size());
  if (const std::size_t newline = newline_length(text, i)) return i + newline;
  return i < text.size() && is_ascii_blank(text[i]) ? i + 1 : i;
}

/// Returns the bracket that closes the block that a token opens; 0 if it opens none.
char closing(TokenType type) {
  if (type == function || type == open_paren) return ')';
  if (type == open_square) return ']';
  return type == open_curly ? '}' : '\0';
}

}  // namespace

Tokenizer::Tokenizer(std::string_view text, TextPoll& poll) : text_(text), poll_(poll) {
  if (!poll_.go_on(std::min(text.size(), TextPoll::kBytes))) at_ = text_.size();
}

/// Polls for each part of the text that was read. If the work stops, moves to the end.
void Tokenizer::pace() {
  if (at_ - told_ < TextPoll::kBytes) return;
  const bool goes_on = poll_.go_on(at_ - told_);
  told_ = at_;
  if (!goes_on) at_ = text_.size();
}

template <class IsWanted>
void Tokenizer::skip_while(IsWanted is_wanted) {
  do {
    const std::size_t end = std::min(at_ + TextPoll::kBytes, text_.size());
    while (at_ < end && is_wanted(text_[at_])) ++at_;
    if (at_ < end) return;
    pace();
  } while (at_ < text_.size());
}

/// Behind the next `end`, or to the end of all.
void Tokenizer::skip_to(std::string_view end) {
  do {
    const std::size_t count = TextPoll::kBytes + end.size() - 1;
    const std::size_t found = text_.substr(at_, count).find(end);
    if (found != std::string_view::npos) {
      at_ += found + end.size();
      return;
    }
    at_ = std::min(at_ + TextPoll::kBytes, text_.size());
    pace();
  } while (at_ < text_.size());
}

void Tokenizer::skip_comments() {
  while (peek() == '/' && peek(1) == '*') {
    at_ += 2;
    skip_to("*/");
    pace();
  }
}

bool Tokenizer::starts_escape(std::size_t ahead) const {
  return peek(ahead) == '\\' && at_ + ahead + 1 < text_.size() && !is_newline(peek(ahead + 1));
}

bool Tokenizer::starts_name(std::size_t ahead) const {
  if (peek(ahead) == '-') {
    return is_name_start(peek(ahead + 1)) || peek(ahead + 1) == '-' || starts_escape(ahead + 1);
  }
  return is_name_start(peek(ahead)) || starts_escape(ahead);
}

bool Tokenizer::starts_number() const {
  const std::size_t sign = peek() == '+' || peek() == '-' ? 1 : 0;
  return is_digit(peek(sign)) || (peek(sign) == '.' && is_digit(peek(sign + 1)));
}

void Tokenizer::skip_escape() {
  at_ = escape_end(text_, at_);
}

void Tokenizer::skip_name() {
  for (;;) {
    skip_while(is_name);
    if (!starts_escape(0)) return;
    skip_escape();
    pace();
  }
}

void Tokenizer::skip_number() {
  if (peek() == '+' || peek() == '-') ++at_;
  skip_while(is_digit);
  if (peek() == '.' && is_digit(peek(1))) {
    ++at_;
    skip_while(is_digit);
  }
  if ((peek() | 0x20) != 'e') return;
  const std::size_t sign = peek(1) == '+' || peek(1) == '-' ? 2 : 1;
  if (!is_digit(peek(sign))) return;
  at_ += sign;
  skip_while(is_digit);
}

Token Tokenizer::simple(TokenType type, std::size_t length) {
  const std::size_t begin = at_;
  at_ += length;
  return {type, since(begin)};
}

Token Tokenizer::take_string() {
  const std::size_t begin = at_;
  const char quote = text_[at_++];
  for (;;) {
    skip_while([quote](char c) { return c != quote && c != '\\' && !is_newline(c); });
    if (at_ >= text_.size()) return {string, since(begin), since(begin + 1)};
    if (text_[at_] == quote) {
      const std::string_view inside = since(begin + 1);
      ++at_;
      return {string, since(begin), inside};
    }
    if (is_newline(text_[at_])) return {bad_string, since(begin)};
    // An escape, a newline that is left out, or a backslash at the end of all.
    const std::size_t newline = newline_length(text_, at_ + 1);
    at_ = newline > 0 ? at_ + 1 + newline : escape_end(text_, at_);
    pace();
  }
}

Token Tokenizer::take_hash() {
  if (!is_name(peek(1)) && !starts_escape(1)) return simple(delim, 1);
  const std::size_t begin = at_;
  const bool is_id = starts_name(1);
  ++at_;
  skip_name();
  return {hash, since(begin), since(begin + 1), {}, is_id};
}

Token Tokenizer::take_at() {
  if (!starts_name(1)) return simple(delim, 1);
  const std::size_t begin = at_++;
  skip_name();
  return {at_keyword, since(begin), since(begin + 1)};
}

Token Tokenizer::take_numeric() {
  const std::size_t begin = at_;
  skip_number();
  const std::string_view digits = since(begin);
  if (peek() == '%') {
    ++at_;
    return {percentage, since(begin), digits};
  }
  if (!starts_name(0)) return {number, digits, digits};
  const std::size_t unit = at_;
  skip_name();
  return {dimension, since(begin), digits, since(unit)};
}

Token Tokenizer::take_ident_like() {
  const std::size_t begin = at_;
  skip_name();
  const std::string_view name = since(begin);
  if (peek() != '(') return {ident, name, name};
  ++at_;
  if (!is_named(name, "url")) return {function, since(begin), name};
  const std::size_t inside = at_;
  skip_while(is_ascii_blank);
  if (peek() != '"' && peek() != '\'') return take_url(begin);
  at_ = inside;
  return {function, since(begin), name};
}

/// From behind "url(" and blanks.
Token Tokenizer::take_url(std::size_t begin) {
  const std::size_t inside = at_;
  for (;;) {
    skip_while([](char c) {
      return c != ')' && c != '\\' && c != '"' && c != '\'' && c != '(' && c != 0x7F &&
             (static_cast<unsigned char>(c) > 0x20);
    });
    const std::string_view held = since(inside);
    skip_while(is_ascii_blank);
    if (at_ >= text_.size()) return {url, since(begin), held};
    if (text_[at_] == ')') {
      ++at_;
      return {url, since(begin), held};
    }
    if (held.size() < at_ - inside || !starts_escape(0)) return rest_of_bad_url(begin);
    skip_escape();
    pace();
  }
}

Token Tokenizer::rest_of_bad_url(std::size_t begin) {
  for (;;) {
    skip_while([](char c) { return c != ')' && c != '\\'; });
    if (at_ >= text_.size()) break;
    if (text_[at_] == ')') {
      ++at_;
      break;
    }
    at_ = starts_escape(0) ? escape_end(text_, at_) : at_ + 1;
    pace();
  }
  return {bad_url, since(begin)};
}

/// Reads brackets, signs, and other single characters.
Token Tokenizer::take_other() {
  static constexpr std::string_view kSigns = ":;,[](){}";
  static constexpr std::array kTypes{colon,      semicolon,   comma,      open_square, close_square,
                                     open_paren, close_paren, open_curly, close_curly};
  const std::size_t sign = kSigns.find(text_[at_]);
  if (sign != std::string_view::npos) return simple(kTypes[sign], 1);
  if (text_.substr(at_, 4) == "<!--") return simple(cdo, 4);
  return simple(delim, 1);
}

Token Tokenizer::next() {
  pace();
  skip_comments();
  if (at_ >= text_.size()) return {end, text_.substr(text_.size())};
  const char c = text_[at_];
  if (is_ascii_blank(c)) {
    const std::size_t begin = at_;
    skip_while(is_ascii_blank);
    return {whitespace, since(begin)};
  }
  if (c == '"' || c == '\'') return take_string();
  if (c == '#') return take_hash();
  if (c == '@') return take_at();
  if (starts_number()) return take_numeric();
  if (text_.substr(at_, 3) == "-->") return simple(cdc, 3);
  if (starts_name(0)) return take_ident_like();
  return take_other();
}

std::string unescaped(std::string_view raw) {
  if (raw.find('\\') == std::string_view::npos) return std::string(raw);
  std::string text;
  text.reserve(raw.size());
  for (std::size_t i = 0; i < raw.size();) {
    if (raw[i] != '\\') {
      text += raw[i++];
      continue;
    }
    const std::size_t newline = newline_length(raw, i + 1);
    const std::size_t next = newline > 0 ? i + 1 + newline : escape_end(raw, i);
    if (newline == 0 && i + 1 < raw.size()) {
      if (is_hex(raw[i + 1])) {
        char32_t code = 0;
        for (std::size_t k = i + 1; k < next && is_hex(raw[k]); ++k) {
          code = 16 * code + static_cast<char32_t>(hex_value(raw[k]));
        }
        append_utf8(text, code != 0 && is_scalar_value(code) ? code : kReplacement);
      } else {
        text += raw.substr(i + 1, next - i - 1);
      }
    }
    i = next;
  }
  return text;
}

bool is_named(std::string_view raw, std::string_view lower) {
  if (raw.size() == lower.size()) {
    return std::ranges::equal(raw, lower, [](char a, char b) {
      return a == b || (a >= 'A' && a <= 'Z' && static_cast<char>(a - 'A' + 'a') == b);
    });
  }
  // The longest has six digits and the two characters of a line's end.
  constexpr std::size_t kLongestEscape = 9;
  if (raw.size() < lower.size() || raw.size() > kLongestEscape * lower.size()) return false;
  if (raw.find('\\') == std::string_view::npos) return false;
  return ascii_lower(unescaped(raw)) == lower;
}

void skip_component(Tokenizer& tokens, const Token& first) {
  std::array<char, kMostBrackets> open{};
  std::size_t depth = 0;
  if (const char last = closing(first.type)) open[depth++] = last;
  while (depth > 0) {
    const Token token = tokens.next();
    if (token.is(end)) return;
    if (const char last = closing(token.type)) {
      if (depth == kMostBrackets) {
        tokens.rewind(tokens.text().size());
        return;
      }
      open[depth++] = last;
    } else if (token.type >= open_square && token.text.front() == open[depth - 1]) {
      --depth;
    }
  }
}

}  // namespace sfumato::css
