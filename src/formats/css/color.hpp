#pragma once

#include <string>
#include <string_view>

#include "formats/css/tokenizer.hpp"
#include "sfumato/base/color.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::css {

struct Color {
  Rgb color;
  float alpha = 1;
  bool is_mapped =
      false;  ///< the written colour lies outside sRGB, and `color` is the nearest one in it
};

/// Reads a colour of CSS Color 4: a name, `transparent`, #rgb, #rgba, #rrggbb, #rrggbbaa, rgb(),
/// rgba(), hsl(), hsla(), hwb(), lab(), lch(), oklab(), oklch(), color(); components are separated
/// by blanks, for rgb and hsl also by commas; they are numbers, percentages or `none`, which is 0.
/// Components of rgb, hsl and hwb are clamped to their range. A colour outside sRGB is mapped into
/// it. Escapes and comments work as in CSS; calc(), color-mix() and relative colours are not
/// supported. Errors: bad_input, without a place; as the poll.
Result<Color> parse_color(std::string_view text, TextPoll& poll);
Result<Color> parse_color(std::string_view text);

/// "; did you mean orange?", or nothing if no colour name is similar.
std::string did_you_mean_color(std::string_view name);

}  // namespace sfumato::css
