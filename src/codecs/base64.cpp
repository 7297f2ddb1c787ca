#include "codecs/base64.hpp"

#include <algorithm>
#include <cstddef>

#include "base/ascii.hpp"

namespace sfumato::codecs {
namespace {

constexpr int kNoDigit = -1;

int base64_digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  if (c == '+') return 62;
  if (c == '/') return 63;
  return kNoDigit;
}

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return kNoDigit;
}

Status bad(std::string message) {
  return make_error(StatusCode::bad_input, std::move(message));
}

/// Whole threes of bytes, but at the end of all.
void append_part(std::span<const std::uint8_t> bytes, std::string& text) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k) word = word << 8 | (k < count ? bytes[i + k] : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += k <= count ? kDigits[word >> (18 - 6 * k) & 63] : '=';
  }
}

}  // namespace

std::size_t base64_length(std::size_t byte_count) {
  return (byte_count + 2) / 3 * 4;
}

std::string encode_base64(std::span<const std::uint8_t> bytes) {
  std::string text;
  text.reserve(base64_length(bytes.size()));
  append_part(bytes, text);
  return text;
}

void append_base64(const Context& context, std::span<const std::uint8_t> bytes,
                   OutputBuffer& text) {
  constexpr std::size_t kPart = std::size_t{3} << 14;
  text.reserve(base64_length(bytes.size()));
  for (std::size_t i = 0; i < bytes.size() && text.status(); i += kPart) {
    if (context.cancelled()) return text.fail(context.cancel_status());
    text += encode_base64(bytes.subspan(i, std::min(kPart, bytes.size() - i)));
  }
}

Result<std::vector<std::uint8_t>> decode_base64(std::string_view text) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int bit_count = 0;
  bool has_ended = false;
  std::size_t digit_count = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (is_blank(c)) continue;
    const int digit = base64_digit(c);
    if (c == '=') {
      has_ended = true;
    } else if (digit == kNoDigit || has_ended) {
      return bad("the base64 is damaged at its character " + std::to_string(i + 1));
    } else {
      bits = bits << 6 | static_cast<std::uint32_t>(digit);
      bit_count += 6;
      ++digit_count;
    }
    if (bit_count >= 8) {
      bit_count -= 8;
      bytes.push_back(static_cast<std::uint8_t>(bits >> bit_count & 0xFF));
    }
  }
  if (digit_count % 4 == 1) return bad("the base64 is cut short");
  return bytes;
}

std::vector<std::uint8_t> decode_percent(std::string_view text) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '%' && i + 2 < text.size()) {
      const int high = hex_digit(text[i + 1]), low = hex_digit(text[i + 2]);
      if (high != kNoDigit && low != kNoDigit) {
        bytes.push_back(static_cast<std::uint8_t>(16 * high + low));
        i += 2;
        continue;
      }
    }
    bytes.push_back(static_cast<std::uint8_t>(text[i]));
  }
  return bytes;
}

Result<std::vector<std::uint8_t>> decode_data_uri(std::string_view uri) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos) return bad("the data: URI has no comma before its data");
  const std::string header = ascii_lower(ascii_trimmed(uri.substr(0, comma)));
  const std::string_view data = uri.substr(comma + 1);
  if (!header.ends_with(";base64")) return decode_percent(data);
  if (data.find('%') == std::string_view::npos) return decode_base64(data);
  const std::vector<std::uint8_t> decoded = decode_percent(data);
  return decode_base64({reinterpret_cast<const char*>(decoded.data()), decoded.size()});
}

}  // namespace sfumato::codecs
