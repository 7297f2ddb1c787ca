#include "base/text/json.hpp"

#include <cmath>

#include "base/text/ascii.hpp"
#include "base/text/number_text.hpp"
#include "base/text/utf8.hpp"

namespace sfumato {
namespace {

/// Writes control characters as escapes, so that a terminal can show the text.
std::string quoted(std::string_view text) {
  std::string out = "\"";
  while (!text.empty()) {
    const char32_t c = take_code_point(text);
    if (c == '"' || c == '\\') {
      out += {'\\', static_cast<char>(c)};
    } else if (is_control(c)) {
      out += "\\u";
      for (const int shift : {12, 8, 4, 0}) out += kHexDigits[(c >> shift) % 16];
    } else {
      append_utf8(out, c);
    }
  }
  return out + '"';
}

}  // namespace

JsonWriter& JsonWriter::key(std::string_view name) {
  separate();
  text_ += quoted(name) + ':';
  first_ = true;
  return *this;
}

JsonWriter& JsonWriter::value(std::string_view text) {
  return raw(quoted(text));
}

JsonWriter& JsonWriter::value(double number) {
  return raw(std::isfinite(number) ? number_text(number) : "null");
}

JsonWriter& JsonWriter::open(char bracket) {
  separate();
  text_ += bracket;
  first_ = true;
  return *this;
}

JsonWriter& JsonWriter::close(char bracket) {
  text_ += bracket;
  first_ = false;
  return *this;
}

JsonWriter& JsonWriter::raw(std::string_view token) {
  separate();
  text_ += token;
  return *this;
}

void JsonWriter::separate() {
  if (!first_) text_ += ',';
  first_ = false;
}

}  // namespace sfumato
