#pragma once

#include <cstddef>
#include <string>

/// Drawings of many curves or stops within 100 by 50 units.
namespace sfumato::hostile {

/// Returns a number as text with nine digits.
std::string decimal(double value);

/// Returns so many colours; neighbours differ.
std::string colours(std::size_t count);

/// Returns one curve with this path data, so many colours above and none below.
std::string open_below(const std::string& data, std::size_t stops);

/// Returns evenly spaced circles around the middle; each has the `attributes`.
std::string concentric_circles(std::size_t count, const std::string& attributes);

/// Returns evenly spaced horizontal lines over so many units of height; each has the `attributes`.
std::string parallel_lines(std::size_t count, double height, const std::string& attributes);

/// Returns so many short curves, evenly spread, without a layer around them.
std::string dust_curves(std::size_t count, const std::string& attributes);

/// Returns a layer of them.
std::string dust(std::size_t count, const std::string& attributes = "sf:left='red'");

}  // namespace sfumato::hostile
