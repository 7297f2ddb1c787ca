#include "options/option_string.hpp"

#include <algorithm>

#include "base/try.hpp"
#include "formats/text/suggestion.hpp"

namespace sfumato::options {
namespace {

constexpr std::string_view kBlanks = " \t\n\r\f";

/// Removes the part before the first of `ends` from the text and returns it.
std::string_view take_until(std::string_view& text, std::string_view ends) {
  const std::string_view taken = text.substr(0, text.find_first_of(ends));
  text.remove_prefix(taken.size());
  return taken;
}

Status complaint(std::string_view key, const char* what) {
  return make_error(StatusCode::bad_input, std::string(key) + ": " + what);
}

bool is_key(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '.';
  });
}

}  // namespace

/// Reads a quoted value. The text begins after the opening quote.
Result<std::string> OptionString::quoted_value(std::string_view key) {
  std::string value;
  while (!rest_.empty() && rest_.front() != '"') {
    const bool is_escape =
        rest_.size() > 1 && rest_.front() == '\\' && (rest_[1] == '"' || rest_[1] == '\\');
    value += rest_[is_escape ? 1 : 0];
    rest_.remove_prefix(is_escape ? 2 : 1);
  }
  if (rest_.empty()) return complaint(key, "a quote that is not closed; add the closing quote");
  rest_.remove_prefix(1);
  if (rest_.empty() || kBlanks.find(rest_.front()) != std::string_view::npos) return value;
  return complaint(key, "something follows a closing quote; put a blank between");
}

Result<Assignment> OptionString::next() {
  rest_.remove_prefix(std::min(rest_.find_first_not_of(kBlanks), rest_.size()));
  if (rest_.empty()) return Assignment{};
  const std::string_view key = take_until(rest_, " \t\n\r\f=");
  if (!is_key(key)) {
    return make_error(StatusCode::bad_input, "unknown option " + text::quoted(key));
  }
  Assignment found{std::string(key), std::nullopt};
  if (rest_.empty() || rest_.front() != '=') return found;
  rest_.remove_prefix(1);
  if (!rest_.empty() && rest_.front() == '"') {
    rest_.remove_prefix(1);
    SFUMATO_TRY_ASSIGN(found.value, quoted_value(key));
    return found;
  }
  const std::string_view value = take_until(rest_, kBlanks);
  if (value.find('"') != std::string_view::npos) {
    return complaint(key, "a quote within a value; put quotes around the whole value");
  }
  found.value = value;
  return found;
}

}  // namespace sfumato::options
