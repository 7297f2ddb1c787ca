#pragma once

#include <string>

/// Doubles and floats as decimal text, computed with whole numbers only. They give the text of
/// std::to_chars without its tables of 130 kB. Values are finite and not 0. Cost: about a
/// microsecond for values near 1.
namespace sfumato {

/// Returns the shortest text that reads back as the value; where several are shortest, the nearest:
/// fixed from 1e-5 to below 1e9, else scientific ("1.5e20", "-1e-7").
std::string shortest_decimal(double value);
std::string shortest_decimal(float value);

/// Returns the value rounded to `digits` significant digits, halves to even, in scientific form.
std::string rounded_decimal(double value, int digits);

/// Returns the value, which may be 0, rounded to `places` decimals, halves to even: "-0.50".
std::string fixed_decimal(double value, int places);

}  // namespace sfumato
