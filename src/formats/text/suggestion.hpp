#pragma once

#include <span>
#include <string>
#include <string_view>

namespace sfumato::text {

/// Returns the candidate that was probably meant by `word`: the one with the smallest edit
/// distance, if this is at most max(1, a third of the word's length); else empty.
std::string_view nearest(std::string_view word, std::span<const std::string_view> candidates);

/// "; did you mean X?", or nothing if no candidate is similar.
std::string did_you_mean(std::string_view word, std::span<const std::string_view> candidates);

/// Returns the text in quotes for a message, shortened if it is long.
std::string quoted(std::string_view text);

}  // namespace sfumato::text
