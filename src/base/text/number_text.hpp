#pragma once

#include <string>

#include "sfumato/base/affine.hpp"
#include "sfumato/base/color.hpp"

/// Numbers, colours and maps as text: the shortest decimals that read back as the same value,
/// independent of the locale. Values are finite.
namespace sfumato {

/// Returns "0.1", "-12", "1e-7"; zero has no sign.
std::string number_text(double value);

/// Returns the shortest decimal for which float(double(text)) is the value.
std::string number_text(float value);

/// Returns the value rounded to `digits` significant digits, 1 to 17.
std::string rounded_number_text(double value, int digits);

/// Returns a length for a message: three digits from 1e9 on. Infinity counts as the largest double.
std::string length_text(double length);

/// Returns the value, of up to 1e40, rounded to `places` decimals, 0 to 18, all of them written:
/// "-0.50".
std::string fixed_number_text(double value, int places);

/// Returns a percentage p, without the percent sign, such that double(p) / 100 is `fraction` or, if
/// there is no such double, the nearest such quotient. That quotient gives the same text again.
std::string percent_text(double fraction);

/// Returns "#rrggbb" where every channel is k / 255 to the bit, else "rgb(r% g% b%)" with
/// float(double(r) / 100) == color.r, and so on.
std::string color_text(const Rgb& color);

/// Returns "translate(x y)" or "matrix(a b c d e f)", as in SVG and CSS.
std::string transform_text(const Affine& map);

}  // namespace sfumato
