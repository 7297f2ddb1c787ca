#include "formats/svg/read/scanner.hpp"

#include <algorithm>
#include <cmath>

#include "base/text/ascii.hpp"
#include "base/text/character_run.hpp"
#include "base/text/number.hpp"
#include "formats/text/suggestion.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato::svg {
namespace {

/// The most bytes to quote after a mistake.
constexpr std::size_t kShownBytes = 12;

bool is_in_word(char c) {
  return ((c >= 'a') & (c <= 'z')) | ((c >= 'A') & (c <= 'Z')) | is_digit(c);
}

std::size_t count_characters(std::string_view text) {
  std::size_t count = 0;
  for (const char c : text) count += (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  return count;
}

/// Returns the following text, cut at the end of a character.
std::string_view shown_part(std::string_view rest) {
  std::size_t end = std::min(rest.size(), kShownBytes);
  while (end < rest.size() && (static_cast<unsigned char>(rest[end]) & 0xC0) == 0x80) ++end;
  return rest.substr(0, end);
}

}  // namespace

void Scanner::skip_blanks() {
  at_ = run_end(text_, at_, is_ascii_blank);
}

void Scanner::skip_separator() {
  skip_blanks();
  if (take(',')) skip_blanks();
}

bool Scanner::take(char c) {
  if (at_end() || text_[at_] != c) return false;
  ++at_;
  return true;
}

std::string_view Scanner::take_word() {
  const std::size_t begin = at_;
  at_ = run_end(text_, at_, is_in_word);
  return text_.substr(begin, at_ - begin);
}

Status Scanner::take_flag(bool& flag) {
  if (peek() != '0' && peek() != '1') return error("a flag, 0 or 1");
  flag = text_[at_++] == '1';
  return ok_status();
}

/// Returns the end of the number at this place; the place itself if there is no number.
std::size_t Scanner::number_end() const {
  const auto skip_digits = [this](std::size_t i) { return run_end(text_, i, is_digit); };
  const auto skip_sign = [this](std::size_t i) {
    return i < text_.size() && (text_[i] == '+' || text_[i] == '-') ? i + 1 : i;
  };
  const std::size_t begin = skip_sign(at_);
  std::size_t end = skip_digits(begin);
  std::size_t digits = end - begin;
  if (end < text_.size() && text_[end] == '.') {
    const std::size_t fraction_end = skip_digits(end + 1);
    digits += fraction_end - end - 1;
    if (digits > 0) end = fraction_end;
  }
  if (digits == 0) return at_;
  if (end < text_.size() && (text_[end] == 'e' || text_[end] == 'E')) {
    const std::size_t exponent = skip_sign(end + 1);
    if (skip_digits(exponent) > exponent) return skip_digits(exponent);
  }
  return end;
}

Status Scanner::take_number(double& number) {
  const std::size_t end = number_end();
  if (end == at_) return error("a number");
  const std::optional<double> value = parse_number(text_.substr(at_, end - at_));
  if (!value || std::abs(*value) > limits::kCoordinate) {
    return error("a number of at most " + std::to_string(static_cast<long>(limits::kCoordinate)) +
                 " in magnitude");
  }
  number = *value;
  at_ = end;
  return ok_status();
}

Status Scanner::error(std::string_view expected) const {
  std::string message;
  if (at_end()) {
    message = "ends too early";
  } else {
    message = "at character " + std::to_string(count_characters(text_.substr(0, at_)) + 1) +
              ", before " + text::quoted(shown_part(rest()));
  }
  return make_error(StatusCode::bad_input, message + ": expected " + std::string(expected));
}

}  // namespace sfumato::svg
