#include "base/text/utf8.hpp"

#include <cstddef>

namespace sfumato {
namespace {

constexpr char32_t kSmallest[] = {0, 0, 0x80, 0x800, 0x10000};  // by the length of its sequence
constexpr char32_t kLargest = 0x10FFFF;

std::size_t sequence_length(unsigned char lead) {
  return lead < 0x80   ? 1
         : lead < 0xC2 ? 0
         : lead < 0xE0 ? 2
         : lead < 0xF0 ? 3
         : lead < 0xF5 ? 4
                       : 0;
}

}  // namespace

bool is_scalar_value(char32_t code_point) {
  const bool is_surrogate = code_point >= 0xD800 && code_point < 0xE000;
  return code_point <= kLargest && !is_surrogate;
}

char32_t take_code_point(std::string_view& text) {
  const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::size_t length = sequence_length(byte(0));
  char32_t code_point = length == 1 ? byte(0) : byte(0) & (0x7Fu >> length);
  bool is_good = length > 0 && text.size() >= length;
  for (std::size_t i = 1; is_good && i < length; ++i) {
    is_good = (byte(i) & 0xC0) == 0x80;
    code_point = code_point << 6 | (byte(i) & 0x3F);
  }
  is_good = is_good && code_point >= kSmallest[length] && is_scalar_value(code_point);
  text.remove_prefix(is_good ? length : 1);
  return is_good ? code_point : kReplacement;
}

void append_utf8(std::string& text, char32_t code_point) {
  const auto rest = [&](int shift) {
    text += static_cast<char>(0x80 | (code_point >> shift & 0x3F));
  };
  if (code_point < 0x80) {
    text += static_cast<char>(code_point);
  } else if (code_point < 0x800) {
    text += static_cast<char>(0xC0 | code_point >> 6);
    rest(0);
  } else if (code_point < 0x10000) {
    text += static_cast<char>(0xE0 | code_point >> 12);
    rest(6);
    rest(0);
  } else {
    text += static_cast<char>(0xF0 | code_point >> 18);
    rest(12);
    rest(6);
    rest(0);
  }
}

std::string valid_utf8(std::string_view text) {
  std::string valid;
  while (!text.empty()) append_utf8(valid, take_code_point(text));
  return valid;
}

bool is_control(char32_t c) {
  return c < 0x20 || (c >= 0x7F && c < 0xA0) || c == 0x61C || c == 0x200E || c == 0x200F ||
         (c >= 0x2028 && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069);
}

std::string printable(std::string_view text, std::string_view kept) {
  std::string shown;
  while (!text.empty()) {
    const char32_t c = take_code_point(text);
    const bool is_kept = c < 0x80 && kept.find(static_cast<char>(c)) != std::string_view::npos;
    append_utf8(shown, is_control(c) && !is_kept ? U'?' : c);
  }
  return shown;
}

}  // namespace sfumato
