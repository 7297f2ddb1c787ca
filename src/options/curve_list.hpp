#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "sfumato/trace/trace.hpp"

namespace sfumato::options {

/// The form that parse_curves() reads, for messages.
inline constexpr const char* kCurveList = "LAYER:CURVE, and so on, with commas between";

/// Returns the largest number of curves that a text of this length can name.
std::size_t most_curves(std::string_view text);

/// Reads "layer:curve,layer:curve", numbers from 0, and appends the curves. Returns false if the
/// text is not such a list or names no curve.
[[nodiscard]] bool parse_curves(std::string_view text, std::vector<CurveOfLayer>& curves);

}  // namespace sfumato::options
