#include "formats/css_text.hpp"

#include <algorithm>
#include <cstddef>

namespace sfumato {
namespace {

/// Of a run of blanks that is looked at whole: long ones are, many at a time.
constexpr std::size_t kBlock = 64;

bool are_blanks(std::string_view block) {
  if (!is_css_blank(block.front()) || !is_css_blank(block.back())) return false;
  int others = 0;
  for (const char c : block) {
    others += !((c == ' ') | (c == '\t') | (c == '\n') | (c == '\r') | (c == '\f'));
  }
  return others == 0;
}

}  // namespace

std::string_view css_trimmed(std::string_view text) {
  while (text.size() >= kBlock && are_blanks(text.substr(0, kBlock))) text.remove_prefix(kBlock);
  while (!text.empty() && is_css_blank(text.front())) text.remove_prefix(1);
  while (text.size() >= kBlock && are_blanks(text.substr(text.size() - kBlock))) {
    text.remove_suffix(kBlock);
  }
  while (!text.empty() && is_css_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string css_lower(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

}  // namespace sfumato
