#pragma once

#include <span>
#include <string>
#include <string_view>

namespace sfumato::text {

/// The candidate that `word` was probably meant to be: the one of the smallest edit distance, if
/// that is at most a third of the word's length and 1 at least; else nothing.
std::string_view nearest(std::string_view word, std::span<const std::string_view> candidates);

/// "; did you mean X?", or nothing where no candidate is near.
std::string did_you_mean(std::string_view word, std::span<const std::string_view> candidates);

/// The text in quotes for a message, cut where it is long.
std::string quoted(std::string_view text);

}  // namespace sfumato::text
