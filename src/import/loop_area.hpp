#pragma once

#include <vector>

#include "sfumato/base/vec2.hpp"

namespace sfumato::svg_import {

/// Returns the signed area within a closed chain of curves: positive if the inside is on its right
/// (the y axis points down).
double signed_area(const std::vector<Vec2>& chain);

/// Returns whether a loop is too thin to be seen: a part of about 4 tolerances, a hole of 2. Such
/// loops remain where contours nearly touch.
bool is_sliver(const std::vector<Vec2>& loop, double tolerance);

}  // namespace sfumato::svg_import
