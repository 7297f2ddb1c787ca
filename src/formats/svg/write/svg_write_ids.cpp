#include "formats/svg/write/svg_write_ids.hpp"

#include <algorithm>

#include "base/table_memory.hpp"
#include "base/text/utf8.hpp"

namespace sfumato::svg {
namespace {

/// The memory of a node in a set or a map besides the item: three links and a colour.
constexpr std::size_t kNodeBytes = 4 * sizeof(void*);

bool is_letter(unsigned char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

bool is_name_byte(unsigned char c) {
  return is_letter(c) || (c >= '0' && c <= '9') || c == '-' || c == '.';
}

/// Returns whether a character beyond ASCII may stand in a name of XML: NameStartChar of XML 1.0,
/// fifth edition, from U+00C0 on.
bool is_name_character(char32_t c) {
  struct Range {
    char32_t first, last;
  };
  constexpr Range kRanges[] = {
      {0xc0, 0xd6},     {0xd8, 0xf6},     {0xf8, 0x2ff},     {0x370, 0x37d},   {0x37f, 0x7ff},
      {0x800, 0x1fff},  {0x200c, 0x200d}, {0x2070, 0x218f},  {0x2c00, 0x2fef}, {0x3001, 0xd7ff},
      {0xf900, 0xfdcf}, {0xfdf0, 0xfffc}, {0x10000, 0xeffff}};
  const auto holds = [c](const Range& range) { return c >= range.first && c <= range.last; };
  return std::ranges::any_of(kRanges, holds) && !is_control(c);
}

std::string as_name(std::string_view text) {
  std::string name;
  while (!text.empty()) {
    const char32_t c = take_code_point(text);
    const bool fits = c < 0x80 ? is_name_byte(static_cast<unsigned char>(c)) : is_name_character(c);
    append_utf8(name, fits ? c : U'_');
  }
  const auto begin = static_cast<unsigned char>(name.front());
  return begin < 0x80 && !is_letter(begin) ? '_' + name : name;
}

}  // namespace

/// False where it is taken already.
bool IdPool::take(const std::string& id) {
  const auto [entry, is_new] = taken_.insert(id);
  if (is_new) bytes_ += kNodeBytes + sizeof(std::string) + capacity_bytes(*entry);
  return is_new;
}

std::string IdPool::numbered(const std::string& base, std::size_t first) {
  const auto [entry, is_new] = next_number_.try_emplace(base, first);
  if (is_new) bytes_ += kNodeBytes + sizeof(*entry) + capacity_bytes(entry->first);
  std::size_t& number = entry->second;
  for (;;) {
    std::string id = base + '-' + std::to_string(number++);
    if (take(id)) return id;
  }
}

std::string IdPool::claim(std::string_view wanted) {
  std::string name = as_name(wanted);
  if (take(name)) return name;
  return numbered(name, 2);
}

std::string IdPool::claim_or_make(std::string_view wanted, std::string_view kind) {
  return wanted.empty() ? numbered(std::string(kind), 1) : claim(wanted);
}

}  // namespace sfumato::svg
