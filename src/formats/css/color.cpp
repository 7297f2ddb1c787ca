#include "formats/css/color.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/ascii.hpp"
#include "formats/css/color_names.hpp"
#include "formats/css/value.hpp"
#include "formats/text/suggestion.hpp"

namespace sfumato::css {
namespace {

using enum TokenType;

/// No name is as long as this, escapes included: what is longer need not be copied.
constexpr std::size_t kLongestColor = 256;

Status no_color(std::string_view text, std::string_view hint = {}) {
  return make_error(StatusCode::bad_input,
                    text::quoted(text) +
                        " is no colour; expected a CSS name, #rgb, #rrggbb, rgb(), "
                        "hsl() or hwb()" +
                        std::string(hint));
}

std::optional<unsigned> hex_digit(char c) {
  if (c >= '0' && c <= '9') return static_cast<unsigned>(c - '0');
  if (c >= 'a' && c <= 'f') return static_cast<unsigned>(c - 'a' + 10);
  if (c >= 'A' && c <= 'F') return static_cast<unsigned>(c - 'A' + 10);
  return std::nullopt;
}

/// The digits behind '#'.
std::optional<Color> from_hex(std::string_view digits) {
  const std::size_t count = digits.size();
  if (count != 3 && count != 4 && count != 6 && count != 8) return std::nullopt;
  const std::size_t digits_each = count < 6 ? 1 : 2;
  float channel[4] = {0, 0, 0, 1};
  for (std::size_t i = 0; i * digits_each < count; ++i) {
    const auto high = hex_digit(digits[i * digits_each]);
    const auto low = hex_digit(digits[i * digits_each + digits_each - 1]);
    if (!high || !low) return std::nullopt;
    channel[i] = static_cast<float>(16 * *high + *low) / 255;
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

/// A number, `whole` of which is 1, a percentage, or none; clamped to 0 to 1.
std::optional<double> share_of(const Token& token, double whole) {
  if (token.is(ident)) return 0;
  if (!token.is(number) && !token.is(percentage)) return std::nullopt;
  const auto value = number_of(token);
  if (!value) return std::nullopt;
  return std::clamp(*value / (token.is(percentage) ? 100 : whole), 0.0, 1.0);
}

/// In turns, 0 up to 1.
std::optional<double> hue(const Token& token) {
  static constexpr std::pair<std::string_view, double> kUnits[] = {
      {"deg", 360}, {"grad", 400}, {"rad", 2 * std::numbers::pi}, {"turn", 1}};
  if (token.is(ident)) return 0;
  double turn = token.is(number) ? 360 : 0;
  for (const auto& [name, units] : kUnits) {
    if (token.is(dimension) && is_named(token.unit, name)) turn = units;
  }
  const auto value = turn > 0 ? number_of(token) : std::nullopt;
  if (!value) return std::nullopt;
  const double fraction = std::fmod(*value / turn, 1.0);
  return fraction < 0 ? fraction + 1 : fraction;
}

/// One channel of the pure hue; CSS Color 4, section 7.1. `n`: 0 for red, 8 green, 4 blue.
double hsl_channel(double n, double turns, double saturation, double lightness) {
  const double k = std::fmod(n + turns * 12, 12.0);
  const double a = saturation * std::min(lightness, 1 - lightness);
  return lightness - a * std::max(-1.0, std::min({k - 3, 9 - k, 1.0}));
}

Rgb from_hsl(double turns, double saturation, double lightness) {
  const auto channel = [&](double n) {
    return static_cast<float>(std::clamp(hsl_channel(n, turns, saturation, lightness), 0.0, 1.0));
  };
  return {channel(0), channel(8), channel(4)};
}

Rgb from_hwb(double turns, double white, double black) {
  if (white + black >= 1) {
    const auto gray = static_cast<float>(white / (white + black));
    return {gray, gray, gray};
  }
  const auto channel = [&](double n) {
    return static_cast<float>(hsl_channel(n, turns, 1, 0.5) * (1 - white - black) + white);
  };
  return {channel(0), channel(8), channel(4)};
}

/// The arguments of a function of colour.
struct Arguments {
  std::array<Token, 4> value{};  ///< the last is alpha
  bool has_alpha = false;
  bool has_commas = false;  ///< as CSS had it first: no `none`, and one kind of numbers
};

/// Reads what stands between the parentheses, and the one that closes. Three values, and alpha,
/// behind a comma where the others have commas, else behind '/'.
std::optional<Arguments> take_arguments(Tokenizer& tokens) {
  std::array<Token, 7> all{};
  std::size_t count = 0;
  for (Token token = next_solid(tokens); !token.is(close_paren) && !token.is(end);
       token = next_solid(tokens)) {
    if (count == all.size()) return std::nullopt;
    all[count++] = token;
  }
  Arguments arguments;
  arguments.has_commas = all[1].is(comma);
  const std::size_t step = arguments.has_commas ? 2 : 1;
  const std::size_t plain_count = 2 * step + 1;
  arguments.has_alpha = count == plain_count + 2;
  if (count != plain_count && !arguments.has_alpha) return std::nullopt;
  for (std::size_t i = 0; i < 3; ++i) arguments.value[i] = all[i * step];
  if (arguments.has_alpha) arguments.value[3] = all[plain_count + 1];
  if (arguments.has_commas && !all[3].is(comma)) return std::nullopt;
  if (!arguments.has_alpha) return arguments;
  const Token& before_alpha = all[plain_count];
  const bool fits = arguments.has_commas ? before_alpha.is(comma) : before_alpha.is_delim('/');
  return fits ? std::optional(arguments) : std::nullopt;
}

/// The only keyword is `none`, 0, and not among commas.
bool are_keywords_right(const Arguments& arguments) {
  return std::ranges::all_of(arguments.value, [&](const Token& token) {
    return !token.is(ident) || (!arguments.has_commas && is_named(token.value, "none"));
  });
}

std::optional<Rgb> rgb_of(const Arguments& arguments) {
  const auto& value = arguments.value;
  const bool is_mixed = value[0].type != value[1].type || value[0].type != value[2].type;
  if (arguments.has_commas && is_mixed) return std::nullopt;
  const auto r = share_of(value[0], 255), g = share_of(value[1], 255), b = share_of(value[2], 255);
  if (!r || !g || !b) return std::nullopt;
  return Rgb{static_cast<float>(*r), static_cast<float>(*g), static_cast<float>(*b)};
}

std::optional<Rgb> three_components(std::string_view name, const Arguments& arguments) {
  const auto& value = arguments.value;
  if (is_named(name, "rgb") || is_named(name, "rgba")) return rgb_of(arguments);
  const auto turns = hue(value[0]), second = share_of(value[1], 100),
             third = share_of(value[2], 100);
  if (!turns || !second || !third) return std::nullopt;
  const bool are_percentages = value[1].is(percentage) && value[2].is(percentage);
  if (arguments.has_commas && !are_percentages) return std::nullopt;
  if (is_named(name, "hsl") || is_named(name, "hsla")) {
    return from_hsl(*turns, *second, *third);
  }
  if (is_named(name, "hwb") && !arguments.has_commas) return from_hwb(*turns, *second, *third);
  return std::nullopt;
}

std::optional<Color> from_function(Tokenizer& tokens, std::string_view name) {
  const auto arguments = take_arguments(tokens);
  if (!arguments || !are_keywords_right(*arguments)) return std::nullopt;
  const auto color = three_components(name, *arguments);
  const auto alpha = arguments->has_alpha ? share_of(arguments->value[3], 1) : std::optional(1.0);
  if (!color || !alpha) return std::nullopt;
  return Color{*color, static_cast<float>(*alpha)};
}

/// The colour whose first token was taken.
std::optional<Color> take_color(Tokenizer& tokens, const Token& first) {
  if (first.is(function)) return from_function(tokens, first.value);
  if (first.value.size() > kLongestColor) return std::nullopt;
  const std::string name = ascii_lower(unescaped(first.value));
  if (first.is(hash)) return from_hex(name);
  return first.is(ident) ? from_name(name) : std::nullopt;
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
  // Most colours of most documents: without a look at tokens.
  if (text.starts_with('#')) {
    if (const auto color = from_hex(text.substr(1))) return *color;
  }
  Tokenizer tokens(text, poll);
  const Token first = next_solid(tokens);
  auto color = take_color(tokens, first);
  if (color && !next_solid(tokens).is(end)) color.reset();
  if (Status status = poll.status(); !status) return status;
  if (color) return *color;
  if (is_current_color(first) && next_solid(tokens).is(end)) {
    return make_error(StatusCode::bad_input,
                      "currentColor depends on where it stands; expected the colour itself");
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
