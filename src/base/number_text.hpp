#pragma once

#include <string>

#include "sfumato/base/affine.hpp"
#include "sfumato/base/color.hpp"

/// Numbers, colours and maps as text: the shortest decimals that read back as the same value,
/// whatever the locale. Values are finite.
namespace sfumato {

/// "0.1", "-12", "1e-7"; zero has no sign.
std::string number_text(double value);

/// The shortest decimal that float(double(text)) turns into the value.
std::string number_text(float value);

/// The value rounded to so many significant digits, 1 to 17.
std::string rounded_number_text(double value, int digits);

/// A percentage p, without its sign: double(p) / 100 is `fraction` or, where no double is such a p,
/// the quotient next to it. Written again, that one gives the same text.
std::string percent_text(double fraction);

/// "#rrggbb" where every channel is k / 255 to the bit, else "rgb(r% g% b%)" with
/// float(double(r) / 100) == color.r, and so on.
std::string color_text(const Rgb& color);

/// "translate(x y)" or "matrix(a b c d e f)", as SVG and CSS have it.
std::string transform_text(const Affine& map);

}  // namespace sfumato
