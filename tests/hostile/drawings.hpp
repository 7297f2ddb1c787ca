#pragma once

#include <cstddef>
#include <string>

/// Drawings of many curves or stops within 100 by 50 units.
namespace sfumato::hostile {

/// A number as text, nine digits.
std::string decimal(double value);

/// So many colours, no two neighbours the same.
std::string colours(std::size_t count);

/// One curve with this path data, so many colours above and none below.
std::string open_below(const std::string& data, std::size_t stops);

/// Circles about the middle, evenly spaced; `attributes` of each.
std::string concentric_circles(std::size_t count, const std::string& attributes);

/// Horizontal lines, evenly spaced over so many units of height; `attributes` of each.
std::string parallel_lines(std::size_t count, double height, const std::string& attributes);

/// So many short curves, spread evenly; without a layer around them.
std::string dust_curves(std::size_t count, const std::string& attributes);

/// A layer of them.
std::string dust(std::size_t count, const std::string& attributes = "sf:left='red'");

}  // namespace sfumato::hostile
