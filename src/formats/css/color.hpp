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
/// `none`, clamped to their range as CSS says; escapes and comments as CSS has them.
/// Errors: bad_input, without a place; what the poll says.
Result<Color> parse_color(std::string_view text, TextPoll& poll);
Result<Color> parse_color(std::string_view text);

/// "; did you mean orange?", or nothing where no name of a colour is near.
std::string did_you_mean_color(std::string_view name);

}  // namespace sfumato::css
