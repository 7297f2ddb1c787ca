#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

/// Runs of characters of one kind (is_kind(c)). Long runs are read a block at a time, without a
/// branch for each character. Even a run as long as the largest input thus takes less time than the
/// longest interval between polls of the cancel flag.
namespace sfumato {

inline constexpr std::size_t kRunBlock = 64;

template <class IsKind>
bool all_are(std::string_view block, IsKind is_kind) {
  std::uint8_t others = 0;
  for (const char c : block.substr(0, kRunBlock)) {
    others = static_cast<std::uint8_t>(others + !is_kind(c));
  }
  return others == 0;
}

/// Returns the end of the run that begins at `begin`; `begin` if there is none.
template <class IsKind>
std::size_t run_end(std::string_view text, std::size_t begin, IsKind is_kind) {
  const std::size_t near = std::min(text.size(), begin + kRunBlock);
  std::size_t end = begin;
  while (end < near && is_kind(text[end])) ++end;
  if (end < near) return end;
  while (end + kRunBlock <= text.size() && all_are(text.substr(end, kRunBlock), is_kind)) {
    end += kRunBlock;
  }
  while (end < text.size() && is_kind(text[end])) ++end;
  return end;
}

/// Returns the begin of the run at the end of the text; the text's size if there is none.
template <class IsKind>
std::size_t run_begin(std::string_view text, IsKind is_kind) {
  std::size_t begin = text.size();
  const auto ends_in_one = [&] { return begin > 0 && is_kind(text[begin - 1]); };
  const std::size_t near = begin - std::min(begin, kRunBlock);
  while (begin > near && ends_in_one()) --begin;
  if (begin > near) return begin;
  while (begin >= kRunBlock && all_are(text.substr(begin - kRunBlock, kRunBlock), is_kind)) {
    begin -= kRunBlock;
  }
  while (ends_in_one()) --begin;
  return begin;
}

}  // namespace sfumato
