#pragma once

#include <string>

/// Doubles and floats as decimal text by whole numbers alone: what std::to_chars gives, without its
/// tables of 130 kB. Values are finite and not 0. Of a microsecond's order for values near 1.
namespace sfumato {

/// The shortest text that reads back as the value, of these the nearest: fixed from 1e-5 to below
/// 1e9, else scientific ("1.5e20", "-1e-7").
std::string shortest_decimal(double value);
std::string shortest_decimal(float value);

/// The value rounded to `digits` significant digits, halves to even, in scientific form.
std::string rounded_decimal(double value, int digits);

/// The value, which may be 0, rounded to `places` decimals, halves to even: "-0.50".
std::string fixed_decimal(double value, int places);

}  // namespace sfumato
