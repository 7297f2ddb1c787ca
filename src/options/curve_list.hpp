#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "sfumato/trace/trace.hpp"

namespace sfumato::options {

/// What parse_curves() reads, for messages.
inline constexpr const char* kCurveList = "LAYER:CURVE, and so on, with commas between";

/// Curves that a text of this length names at most.
std::size_t most_curves(std::string_view text);

/// Reads "layer:curve,layer:curve", numbers from 0, and appends them. False: the text is no such
/// list, or names none.
[[nodiscard]] bool parse_curves(std::string_view text, std::vector<CurveOfLayer>& curves);

}  // namespace sfumato::options
