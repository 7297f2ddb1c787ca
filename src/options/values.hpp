#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "base/pixel_rect.hpp"
#include "sfumato/base/box.hpp"

/// Values of options from text. The whole text must be the value, without white space, infinity or
/// NaN, and independent of the locale; otherwise the result is empty.
namespace sfumato::options {

/// Reads a finite decimal number: "12", "-0.5", "1e-3".
std::optional<double> parse_number(std::string_view text);

/// Reads a number above 0.
std::optional<double> parse_positive(std::string_view text);

/// Reads a decimal whole number in [lowest, highest].
std::optional<std::uint64_t> parse_whole(std::string_view text, std::uint64_t lowest,
                                         std::uint64_t highest);

/// Reads a whole number from 0 to `highest`, with an optional suffix k, M or G (powers of 1000), or
/// KiB, MiB or GiB (powers of 1024): "300k".
std::optional<std::uint64_t> parse_count(std::string_view text, std::uint64_t highest);

/// Reads a fraction above 0 and at most 1: "0.04" or "4%".
std::optional<double> parse_fraction(std::string_view text);

/// Reads "x,y,width,height" in user units: within limits::kCoordinate, width and height above 0.
std::optional<Box> parse_viewport(std::string_view text);

/// Reads "x,y,width,height" in whole pixels: x and y from 0, width and height from 1, within
/// RasterWindow::kLargestSide.
std::optional<PixelRect> parse_window(std::string_view text);

}  // namespace sfumato::options
