#include "codecs/base64.hpp"

#include <algorithm>
#include <cstddef>

#include "base/poll.hpp"
#include "base/text/ascii.hpp"
#include "base/try.hpp"

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

Status bad(std::string message) {
  return make_error(StatusCode::bad_input, std::move(message));
}

/// Returns the first byte of a text that is not empty, decoded if it begins with a code such as
/// %41.
std::uint8_t take_percent_coded(std::string_view& text) {
  const char c = text.front();
  const int high = c == '%' && text.size() > 2 ? hex_value(text[1]) : kNoHexDigit;
  const int low = high != kNoHexDigit ? hex_value(text[2]) : kNoHexDigit;
  text.remove_prefix(low != kNoHexDigit ? 3 : 1);
  return static_cast<std::uint8_t>(low != kNoHexDigit ? 16 * high + low : c);
}

/// Bytes of one part: a multiple of three, except at the end.
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

/// Calls take(text) with the base64 of one part after another, and polls the cancel flag before
/// each.
template <class Take>
Status for_each_part(const Context& context, std::span<const std::uint8_t> bytes, Take take) {
  constexpr std::size_t kPart = std::size_t{3} << 14;
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += kPart) {
    if (context.cancelled()) return context.cancel_status();
    text.clear();
    append_part(bytes.subspan(i, std::min(kPart, bytes.size() - i)), text);
    take(text);
  }
  return ok_status();
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
  const std::size_t length = base64_length(bytes.size());
  text.reserve(length + length / 8);  // so that later bytes need not move all of it
  text.fail(for_each_part(context, bytes, [&](std::string_view part) { text += part; }));
}

Status append_base64(const Context& context, std::span<const std::uint8_t> bytes,
                     TableMemory& memory, std::string& text) {
  SFUMATO_TRY(memory.make_room(context, text, base64_length(bytes.size())));
  return for_each_part(context, bytes, [&](std::string_view part) { text += part; });
}

Status decode_base64(const Context& context, std::string_view text, TableMemory& memory,
                     std::vector<std::uint8_t>& bytes) {
  SFUMATO_TRY(memory.reserve(context, bytes, text.size() / 4 * 3 + 3));
  RarePoll<65536> poll(context);
  std::uint32_t bits = 0;
  int bit_count = 0;
  bool has_ended = false;
  std::size_t digit_count = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (poll.cancelled()) return context.cancel_status();
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
  return ok_status();
}

std::vector<std::uint8_t> decode_percent(std::string_view text) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(text.size());
  while (!text.empty()) bytes.push_back(take_percent_coded(text));
  return bytes;
}

Status decode_data_uri(const Context& context, std::string_view uri, TableMemory& memory,
                       std::vector<std::uint8_t>& bytes) {
  constexpr std::string_view kBase64 = ";base64";
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos) return bad("the data: URI has no comma before its data");
  const std::string_view header = ascii_trimmed(uri.substr(0, comma));
  const std::string_view end =
      header.substr(header.size() - std::min(header.size(), kBase64.size()));
  std::string_view data = uri.substr(comma + 1);
  const bool is_base64 = ascii_lower(end) == kBase64;
  if (is_base64 && data.find('%') == std::string_view::npos) {
    return decode_base64(context, data, memory, bytes);
  }
  TableMemory text_memory("a data: URI");
  std::vector<std::uint8_t> text;
  std::vector<std::uint8_t>& decoded = is_base64 ? text : bytes;
  Status status = (is_base64 ? text_memory : memory).reserve(context, decoded, data.size());
  RarePoll<65536> poll(context);
  while (status && !data.empty()) {
    if (poll.cancelled()) return context.cancel_status();
    decoded.push_back(take_percent_coded(data));
  }
  if (!status || !is_base64) return status;
  const auto* characters = reinterpret_cast<const char*>(text.data());
  return decode_base64(context, {characters, text.size()}, memory, bytes);
}

}  // namespace sfumato::codecs
