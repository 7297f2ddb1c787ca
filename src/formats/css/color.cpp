#include "formats/css/color.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/text/ascii.hpp"
#include "base/try.hpp"
#include "formats/css/color_functions.hpp"
#include "formats/css/names.hpp"
#include "formats/css/value.hpp"
#include "formats/text/suggestion.hpp"

namespace sfumato::css {
namespace {

using enum TokenType;

/// No name of a colour is as long as this, escapes included. Longer texts need not be copied.
constexpr std::size_t kLongestColor = 256;

Status no_color(std::string_view text, std::string_view hint = {}) {
  return make_error(StatusCode::bad_input,
                    text::quoted(text) +
                        " is not a colour; use a CSS name, #rgb, #rrggbb, rgb(), hsl(), hwb(), "
                        "lab(), lch(), oklab(), oklch() or color()" +
                        std::string(hint));
}

Status no_color_because(std::string_view text, const Status& cause) {
  return make_error(cause.code, text::quoted(text) + " is not a colour: " + cause.message);
}

/// Returns the colour of the digits behind '#'.
std::optional<Color> from_hex(std::string_view digits) {
  const std::size_t count = digits.size();
  if (count != 3 && count != 4 && count != 6 && count != 8) return std::nullopt;
  const std::size_t digits_each = count < 6 ? 1 : 2;
  float channel[4] = {0, 0, 0, 1};
  for (std::size_t i = 0; i * digits_each < count; ++i) {
    const int high = hex_value(digits[i * digits_each]);
    const int low = hex_value(digits[i * digits_each + digits_each - 1]);
    if (high == kNoHexDigit || low == kNoHexDigit) return std::nullopt;
    channel[i] = static_cast<float>(16 * high + low) / 255;
  }
  return Color{{channel[0], channel[1], channel[2]}, channel[3]};
}

std::optional<Color> from_name(std::string_view name) {
  if (name == "transparent") return Color{{0, 0, 0}, 0};
  const auto found = std::ranges::lower_bound(kNamedColors, name, {}, &NamedColor::name);
  if (found == kNamedColors.end() || found->name != name) return std::nullopt;
  const auto channel = [rgb = found->rgb](int shift) {
    return static_cast<float>(rgb >> shift & 0xFF) / 255;
  };
  return Color{{channel(16), channel(8), channel(0)}, 1};
}

/// Reads the colour after its first token. No value: the text is not a colour, and there is no
/// other error.
std::optional<Result<Color>> take_color(Tokenizer& tokens, const Token& first) {
  if (first.is(function)) return take_color_function(tokens, first.value);
  if (first.value.size() > kLongestColor) return std::nullopt;
  const std::string name = ascii_lower(unescaped(first.value));
  const auto color = first.is(hash)    ? from_hex(name)
                     : first.is(ident) ? from_name(name)
                                       : std::optional<Color>();
  if (!color) return std::nullopt;
  return Result<Color>(*color);
}

bool is_current_color(const Token& token) {
  return token.is(ident) && is_named(token.value, "currentcolor");
}

}  // namespace

std::string did_you_mean_color(std::string_view name) {
  std::vector<std::string_view> names;
  for (const NamedColor& color : kNamedColors) names.push_back(color.name);
  return text::did_you_mean(name, names);
}

Result<Color> parse_color(std::string_view text, TextPoll& poll) {
  // A fast path for most colours of most documents, without tokens.
  if (text.starts_with('#')) {
    if (const auto color = from_hex(text.substr(1))) return *color;
  }
  Tokenizer tokens(text, poll);
  const Token first = next_solid(tokens);
  auto color = take_color(tokens, first);
  const bool ends = next_solid(tokens).is(end);
  SFUMATO_TRY(poll.status());
  if (color && color->ok() && ends) return *color;
  if (color && !color->ok()) return no_color_because(ascii_trimmed(text), color->status());
  if (is_current_color(first) && ends) {
    return make_error(StatusCode::bad_input,
                      "currentColor depends on where it stands; use the colour itself");
  }
  const std::string_view written = ascii_trimmed(text);
  const bool is_name = first.is(ident) && first.text == written && written.size() <= kLongestColor;
  return no_color(written, is_name ? did_you_mean_color(ascii_lower(written)) : std::string());
}

Result<Color> parse_color(std::string_view text) {
  TextPoll poll;
  return parse_color(text, poll);
}

}  // namespace sfumato::css
