#include "formats/svg_write_ids.hpp"

#include <cstdint>

namespace sfumato::svg_write {
namespace {

bool is_letter(unsigned char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

bool is_name_byte(unsigned char c) {
  return is_letter(c) || (c >= '0' && c <= '9') || c == '-' || c == '.';
}

/// Bytes of the UTF-8 sequence at the start of `text`, which is no ASCII; 0 where it is none or its
/// character is none of XML's names.
std::size_t name_character_length(std::string_view text) {
  const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::size_t length = byte(0) >= 0xf0 ? 4 : byte(0) >= 0xe0 ? 3 : 2;
  if (byte(0) < 0xc2 || byte(0) > 0xf4 || text.size() < length) return 0;
  std::uint32_t code = byte(0) & (0x7fu >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return 0;
    code = code << 6 | (byte(i) & 0x3f);
  }
  // NameStartChar of XML 1.0, fifth edition, from U+00C0 on.
  struct Range {
    std::uint32_t first, last;
  };
  constexpr Range kRanges[] = {
      {0xc0, 0xd6},     {0xd8, 0xf6},     {0xf8, 0x2ff},     {0x370, 0x37d},   {0x37f, 0x7ff},
      {0x800, 0x1fff},  {0x200c, 0x200d}, {0x2070, 0x218f},  {0x2c00, 0x2fef}, {0x3001, 0xd7ff},
      {0xf900, 0xfdcf}, {0xfdf0, 0xfffd}, {0x10000, 0xeffff}};
  const std::uint32_t shortest_form = length == 2 ? 0x80 : length == 3 ? 0x800 : 0x10000;
  if (code < shortest_form) return 0;
  for (const Range& range : kRanges) {
    if (code >= range.first && code <= range.last) return length;
  }
  return 0;
}

std::string as_name(std::string_view text) {
  std::string name;
  while (!text.empty()) {
    const auto first = static_cast<unsigned char>(text.front());
    std::size_t length = 1;
    if (first < 0x80) {
      name += is_name_byte(first) ? text.front() : '_';
    } else if (const std::size_t sequence = name_character_length(text); sequence > 0) {
      name += text.substr(0, sequence);
      length = sequence;
    } else {
      name += '_';
    }
    text.remove_prefix(length);
  }
  const auto begin = static_cast<unsigned char>(name.front());
  return begin < 0x80 && !is_letter(begin) ? '_' + name : name;
}

}  // namespace

std::string IdPool::numbered(const std::string& base, std::size_t first) {
  std::size_t& number = next_number_.try_emplace(base, first).first->second;
  for (;;) {
    std::string id = base + '-' + std::to_string(number++);
    if (taken_.insert(id).second) return id;
  }
}

std::string IdPool::claim(std::string_view wanted) {
  std::string name = as_name(wanted);
  if (taken_.insert(name).second) return name;
  return numbered(name, 2);
}

std::string IdPool::claim_or_make(std::string_view wanted, std::string_view kind) {
  return wanted.empty() ? numbered(std::string(kind), 1) : claim(wanted);
}

}  // namespace sfumato::svg_write
