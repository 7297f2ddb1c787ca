#include "base/text/ascii.hpp"

#include "base/text/character_run.hpp"

namespace sfumato {

int hex_value(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return kNoHexDigit;
}

std::string_view ascii_trimmed(std::string_view text) {
  text.remove_prefix(run_end(text, 0, is_ascii_blank));
  return text.substr(0, run_begin(text, is_ascii_blank));
}

std::string ascii_lower(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

}  // namespace sfumato
