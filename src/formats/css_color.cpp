#include "formats/css_color.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "formats/css_color_names.hpp"
#include "formats/css_text.hpp"
#include "formats/number.hpp"
#include "formats/suggestion.hpp"

namespace sfumato {
namespace {

Status no_color(std::string_view text, std::string_view hint = {}) {
  return make_error(StatusCode::bad_input,
                    quoted(text) +
                        " is no colour; expected a CSS name, #rgb, #rrggbb, rgb(), "
                        "hsl() or hwb()" +
                        std::string(hint));
}

std::optional<unsigned> hex_digit(char c) {
  if (c >= '0' && c <= '9') return static_cast<unsigned>(c - '0');
  if (c >= 'a' && c <= 'f') return static_cast<unsigned>(c - 'a' + 10);
  return std::nullopt;
}

/// The digits behind '#'.
std::optional<CssColor> from_hex(std::string_view digits) {
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
  return CssColor{{channel[0], channel[1], channel[2]}, channel[3]};
}

std::optional<CssColor> from_name(std::string_view name) {
  if (name == "transparent") return CssColor{{0, 0, 0}, 0};
  const auto found = std::ranges::lower_bound(kNamedColors, name, {}, &NamedColor::name);
  if (found == kNamedColors.end() || found->name != name) return std::nullopt;
  const auto channel = [rgb = found->rgb](int shift) {
    return static_cast<float>(rgb >> shift & 0xFF) / 255;
  };
  return CssColor{{channel(16), channel(8), channel(0)}, 1};
}

/// A number, `whole` of which is 1, or a percentage; clamped to 0 to 1.
std::optional<double> share(std::string_view text, double whole) {
  if (text.ends_with('%')) {
    text.remove_suffix(1);
    whole = 100;
  }
  const auto number = parse_number(text);
  return number ? std::optional(std::clamp(*number / whole, 0.0, 1.0)) : std::nullopt;
}

/// In turns, 0 up to 1.
std::optional<double> hue(std::string_view text) {
  double turn = 360;
  const auto unit = [&](std::string_view name, double units) {
    if (!text.ends_with(name)) return false;
    text.remove_suffix(name.size());
    turn = units;
    return true;
  };
  if (!unit("deg", 360) && !unit("grad", 400) && !unit("rad", 2 * std::numbers::pi)) {
    unit("turn", 1);
  }
  const auto number = parse_number(text);
  if (!number) return std::nullopt;
  const double fraction = std::fmod(*number / turn, 1.0);
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

/// The components between the parentheses: separated by commas, or by blanks with '/' before alpha.
std::vector<std::string_view> components(std::string_view inside) {
  std::vector<std::string_view> parts;
  while (!inside.empty()) {
    const std::size_t begin = inside.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos) break;
    inside.remove_prefix(begin);
    const std::size_t end = std::min(inside.find_first_of(" \t\r\n,/"), inside.size());
    parts.push_back(inside.substr(0, end));
    inside.remove_prefix(end);
    const std::size_t next = std::min(inside.find_first_not_of(" \t\r\n"), inside.size());
    inside.remove_prefix(next);
    if (!inside.empty() && (inside.front() == ',' || inside.front() == '/')) {
      inside.remove_prefix(1);
      if (inside.find_first_not_of(" \t\r\n") == std::string_view::npos) parts.emplace_back();
    }
    if (parts.size() > 4) break;
  }
  return parts;
}

std::optional<Rgb> three_components(std::string_view function,
                                    const std::vector<std::string_view>& parts) {
  if (function == "rgb" || function == "rgba") {
    const auto r = share(parts[0], 255), g = share(parts[1], 255), b = share(parts[2], 255);
    if (!r || !g || !b) return std::nullopt;
    return Rgb{static_cast<float>(*r), static_cast<float>(*g), static_cast<float>(*b)};
  }
  const auto turns = hue(parts[0]), second = share(parts[1], 100), third = share(parts[2], 100);
  if (!turns || !second || !third) return std::nullopt;
  if (function == "hsl" || function == "hsla") return from_hsl(*turns, *second, *third);
  if (function == "hwb") return from_hwb(*turns, *second, *third);
  return std::nullopt;
}

std::optional<CssColor> from_function(std::string_view text) {
  const std::size_t open = text.find('(');
  if (open == std::string_view::npos || text.back() != ')') return std::nullopt;
  const auto parts = components(text.substr(open + 1, text.size() - open - 2));
  if (parts.size() != 3 && parts.size() != 4) return std::nullopt;
  const auto color = three_components(text.substr(0, open), parts);
  const auto alpha = parts.size() == 4 ? share(parts[3], 1) : std::optional(1.0);
  if (!color || !alpha) return std::nullopt;
  return CssColor{*color, static_cast<float>(*alpha)};
}

std::string hint_for(std::string_view name) {
  std::vector<std::string_view> names;
  for (const NamedColor& color : kNamedColors) names.push_back(color.name);
  return did_you_mean(name, names);
}

}  // namespace

Result<CssColor> parse_css_color(std::string_view text) {
  const std::string_view written = css_trimmed(text);
  if (written.empty()) return no_color(written);
  const std::string lower = css_lower(written);
  if (lower == "currentcolor") {
    return make_error(StatusCode::bad_input,
                      "currentColor depends on where it stands; expected the colour itself");
  }
  const auto color = lower.front() == '#'  ? from_hex(std::string_view(lower).substr(1))
                     : lower.back() == ')' ? from_function(lower)
                                           : from_name(lower);
  if (!color) return no_color(written, hint_for(lower));
  return *color;
}

}  // namespace sfumato
