#pragma once

#include <string>
#include <string_view>

/// Prepares text from inputs and file names for output: valid UTF-8, without characters that
/// control a terminal.
namespace sfumato {

/// Stands for bytes that are not UTF-8.
inline constexpr char32_t kReplacement = 0xFFFD;

/// Removes the first character from `text`, which must not be empty, and returns it. A byte that
/// begins no well-formed sequence (cut short, overlong, a surrogate, above U+10FFFF) is removed
/// alone and gives kReplacement.
char32_t take_code_point(std::string_view& text);

/// Returns whether a number is a character: at most U+10FFFF and not a surrogate.
bool is_scalar_value(char32_t code_point);

/// Appends a character, which must be a scalar value.
void append_utf8(std::string& text, char32_t code_point);

/// Returns the text, with kReplacement for every byte that is not UTF-8.
std::string valid_utf8(std::string_view text);

/// Returns whether it is a control character: C0, DEL, C1, line and paragraph separators, and
/// characters that change the direction of text.
bool is_control(char32_t code_point);

/// Does valid_utf8(), with '?' for every control character except the ASCII ones in `kept`.
std::string printable(std::string_view text, std::string_view kept = {});

}  // namespace sfumato
