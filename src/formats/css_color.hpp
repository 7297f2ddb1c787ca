#pragma once

#include <string_view>

#include "base/color.hpp"
#include "base/status.hpp"

namespace sfumato {

struct CssColor {
  Rgb color;
  float alpha = 1;
};

/// Reads a colour of CSS: a name, `transparent`, #rgb, #rgba, #rrggbb, #rrggbbaa, rgb(), rgba(),
/// hsl(), hsla(), hwb(); components with commas or blanks, as numbers or percentages, clamped to
/// their range as CSS says. Errors: bad_input, without a place.
Result<CssColor> parse_css_color(std::string_view text);

}  // namespace sfumato
