#pragma once

#include <string>
#include <string_view>

#include "sfumato/base/limits.hpp"

namespace sfumato::options {

/// All names of limits, and which of them was probably meant: "curves, stops; did you mean stops?".
std::string expected_limits(std::string_view given);

/// Sets the limit of this name from text as "300k". Returns what was expected instead; empty:
/// nothing, and the limit is set.
std::string set_limit(std::string_view name, std::string_view digits, Limits& limits);

}  // namespace sfumato::options
