#pragma once

#include <string>
#include <string_view>

/// Text of inputs and names of files on its way out: as UTF-8 that every reader takes, and without
/// what a terminal would obey.
namespace sfumato {

/// Stands for bytes that are no UTF-8.
inline constexpr char32_t kReplacement = 0xFFFD;

/// Takes the first character off `text`, which is not empty. A byte that begins no well-formed
/// sequence (cut short, overlong, a surrogate, above U+10FFFF) is taken alone: kReplacement.
char32_t take_code_point(std::string_view& text);

void append_utf8(std::string& text, char32_t code_point);

/// The text, with kReplacement for every byte that is no UTF-8.
std::string valid_utf8(std::string_view text);

/// C0, DEL and C1, line and paragraph separators, and what changes the direction of text.
bool is_control(char32_t code_point);

/// As valid_utf8, with '?' for every control but those of `kept`, which are ASCII.
std::string printable(std::string_view text, std::string_view kept = {});

}  // namespace sfumato
