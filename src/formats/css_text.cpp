#include "formats/css_text.hpp"

#include <algorithm>

namespace sfumato {
namespace {

constexpr std::string_view kBlanks = " \t\r\n\f";
constexpr std::string_view kImportant = "important";

std::string_view without_important(std::string_view value) {
  const std::size_t mark = value.rfind('!');
  if (mark == std::string_view::npos || css_trimmed(value.substr(mark + 1)) != kImportant) {
    return value;
  }
  return css_trimmed(value.substr(0, mark));
}

}  // namespace

std::string_view css_trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

std::string css_lower(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

std::string_view take_until(std::string_view& text, char separator) {
  std::size_t open = 0, i = 0;
  char quote = 0;
  for (; i < text.size(); ++i) {
    const char c = text[i];
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '(') {
      ++open;
    } else if (c == ')') {
      open -= open > 0;
    } else if (c == separator && open == 0) {
      break;
    }
  }
  const std::string_view taken = text.substr(0, i);
  text.remove_prefix(std::min(i + 1, text.size()));
  return taken;
}

std::optional<std::string_view> css_declaration(std::string_view declarations,
                                                std::string_view property) {
  std::optional<std::string_view> value;
  if (declarations.find(property) == std::string_view::npos) return value;
  while (!declarations.empty()) {
    std::string_view rest = take_until(declarations, ';');
    const std::string_view name = css_trimmed(take_until(rest, ':'));
    if (name == property) value = without_important(css_trimmed(rest));
  }
  return value;
}

std::optional<std::string_view> css_url(std::string_view text) {
  text = css_trimmed(text);
  if (!text.starts_with("url(") || !text.ends_with(')')) return std::nullopt;
  text = css_trimmed(text.substr(4, text.size() - 5));
  const bool has_quotes = text.size() >= 2 && text.front() == text.back() &&
                          (text.front() == '"' || text.front() == '\'');
  return has_quotes ? css_trimmed(text.substr(1, text.size() - 2)) : text;
}

}  // namespace sfumato
