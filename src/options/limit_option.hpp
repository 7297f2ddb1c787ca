#pragma once

#include <string>
#include <string_view>

#include "sfumato/base/limits.hpp"

namespace sfumato::options {

/// Returns all names of limits and the one that was probably meant: "curves, stops; did you mean
/// stops?".
std::string expected_limits(std::string_view given);

/// Sets the limit of this name from a text such as "300k". Returns what to use instead if the text
/// is wrong; empty if the limit is set.
std::string set_limit(std::string_view name, std::string_view digits, Limits& limits);

}  // namespace sfumato::options
