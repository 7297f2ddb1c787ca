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
};

/// Reads a colour of CSS Color 4: a name, `transparent`, #rgb, #rgba, #rrggbb, #rrggbbaa, rgb(),
/// rgba(), hsl(), hsla(), hwb(); components with commas or blanks, as numbers or percentages or
/// `none`, clamped to their range as in CSS; escapes and comments as in CSS.
/// Errors: bad_input, without a place; those of the poll.
Result<Color> parse_color(std::string_view text, TextPoll& poll);
Result<Color> parse_color(std::string_view text);

/// "; did you mean orange?", or nothing if no colour name is similar.
std::string did_you_mean_color(std::string_view name);

}  // namespace sfumato::css
