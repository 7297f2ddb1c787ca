#include "formats/css/color_functions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "base/text/ascii.hpp"
#include "base/try.hpp"
#include "color/gamut_map.hpp"
#include "color/hue.hpp"
#include "color/space.hpp"
#include "formats/css/value.hpp"
#include "formats/text/suggestion.hpp"

namespace sfumato::css {
namespace {

using enum TokenType;
using color::Space;
using color::SrgbColor;
using color::Triple;

/// Components beyond this are clamped: CSS leaves the range to implementations.
constexpr double kLargestComponent = 1000;

constexpr std::array<std::pair<std::string_view, Space>, 10> kColorSpaces{
    {{"srgb", Space::srgb},
     {"srgb-linear", Space::srgb_linear},
     {"display-p3", Space::display_p3},
     {"display-p3-linear", Space::display_p3_linear},
     {"a98-rgb", Space::a98_rgb},
     {"prophoto-rgb", Space::prophoto_rgb},
     {"rec2020", Space::rec2020},
     {"xyz", Space::xyz_d65},
     {"xyz-d50", Space::xyz_d50},
     {"xyz-d65", Space::xyz_d65}}};

Status bad(std::string why) {
  return make_error(StatusCode::bad_input, std::move(why));
}

/// The components of a function, and its alpha.
struct Arguments {
  std::array<Token, 4> value{};  ///< the last is alpha
  bool has_alpha = false;
  bool has_commas = false;  ///< the legacy syntax: no `none`, and one kind of numbers
};

/// Three components as numbers. The first that is wrong is remembered, and is 0.
class Components {
 public:
  explicit Components(const Arguments& arguments) : arguments_(arguments) {}

  /// Returns a number divided by `whole`, or a percentage; clamped to 0 to 1.
  double share(std::size_t i, double whole);
  /// Returns a number, or a percentage of `whole`; clamped only to the range of computation.
  double number(std::size_t i, double whole);
  /// In turns, 0 up to 1.
  double hue(std::size_t i);
  double hue_degrees(std::size_t i) { return 360 * hue(i); }
  double alpha() { return arguments_.has_alpha ? share(3, 1) : 1; }
  const Status& status() const { return status_; }

 private:
  bool is_none(const Token& token) const;
  std::optional<double> amount(const Token& token);
  void fail(const Token& token, const char* expected);

  const Arguments& arguments_;
  Status status_ = ok_status();
};

/// `none` is 0, and no value of the legacy syntax.
bool Components::is_none(const Token& token) const {
  return !arguments_.has_commas && token.is(ident) && is_named(token.value, "none");
}

void Components::fail(const Token& token, const char* expected) {
  if (!status_) return;
  status_ = bad(text::quoted(token.text) + " is not valid here; use " + expected);
}

/// Returns the value of a number or a percentage.
std::optional<double> Components::amount(const Token& token) {
  const bool is_amount = token.is(TokenType::number) || token.is(percentage);
  const auto value = is_amount ? number_of(token) : std::nullopt;
  if (!value) fail(token, "a number or a percentage");
  return value;
}

double Components::number(std::size_t i, double whole) {
  const Token& token = arguments_.value[i];
  if (is_none(token)) return 0;
  const double value = amount(token).value_or(0);
  const double scaled = token.is(percentage) ? value / 100 * whole : value;
  return std::clamp(scaled, -kLargestComponent, kLargestComponent);
}

double Components::share(std::size_t i, double whole) {
  const Token& token = arguments_.value[i];
  if (is_none(token)) return 0;
  const double value = amount(token).value_or(0);
  return std::clamp(value / (token.is(percentage) ? 100 : whole), 0.0, 1.0);
}

double Components::hue(std::size_t i) {
  static constexpr std::pair<std::string_view, double> kUnits[] = {
      {"deg", 360}, {"grad", 400}, {"rad", 2 * std::numbers::pi}, {"turn", 1}};
  const Token& token = arguments_.value[i];
  if (is_none(token)) return 0;
  double turn = token.is(TokenType::number) ? 360 : 0;
  for (const auto& [name, units] : kUnits) {
    if (token.is(dimension) && is_named(token.unit, name)) turn = units;
  }
  const auto value = turn > 0 ? number_of(token) : std::nullopt;
  if (!value) {
    fail(token, "a hue: a number of degrees, or an angle in deg, grad, rad or turn");
    return 0;
  }
  const double fraction = std::fmod(*value / turn, 1.0);
  return fraction < 0 ? fraction + 1 : fraction;
}

SrgbColor read_rgb(Components& c) {
  const double r = c.share(0, 255), g = c.share(1, 255), b = c.share(2, 255);
  return {{static_cast<float>(r), static_cast<float>(g), static_cast<float>(b)}};
}

SrgbColor read_hsl(Components& c) {
  const double turns = c.hue(0), saturation = c.share(1, 100), lightness = c.share(2, 100);
  return {color::rgb_from_hsl(turns, saturation, lightness)};
}

SrgbColor read_hwb(Components& c) {
  const double turns = c.hue(0), white = c.share(1, 100), black = c.share(2, 100);
  return {color::rgb_from_hwb(turns, white, black)};
}

SrgbColor read_lab(Components& c) {
  const double lightness = 100 * c.share(0, 100), a = c.number(1, 125), b = c.number(2, 125);
  return map_to_srgb(color::xyz_from_lab({lightness, a, b}));
}

SrgbColor read_lch(Components& c) {
  const double lightness = 100 * c.share(0, 100), chroma = std::max(c.number(1, 150), 0.0);
  return map_to_srgb(color::xyz_from_lab(color::lab_from_lch(lightness, chroma, c.hue_degrees(2))));
}

SrgbColor read_oklab(Components& c) {
  const double lightness = c.share(0, 1), a = c.number(1, 0.4), b = c.number(2, 0.4);
  return map_to_srgb(color::xyz_from_oklab({lightness, a, b}));
}

SrgbColor read_oklch(Components& c) {
  const double lightness = c.share(0, 1), chroma = std::max(c.number(1, 0.4), 0.0);
  return map_to_srgb(
      color::xyz_from_oklab(color::lab_from_lch(lightness, chroma, c.hue_degrees(2))));
}

SrgbColor read_in_space(Components& c, Space space) {
  const Triple triple{c.number(0, 1), c.number(1, 1), c.number(2, 1)};
  const double least = std::min({triple.x, triple.y, triple.z});
  const double largest = std::max({triple.x, triple.y, triple.z});
  if (space != Space::srgb || least < 0 || largest > 1) {
    return map_to_srgb(color::xyz_from(space, triple));
  }
  return {
      {static_cast<float>(triple.x), static_cast<float>(triple.y), static_cast<float>(triple.z)}};
}

/// A function of colour.
struct FunctionInfo {
  std::string_view name;
  SrgbColor (*read)(Components&);
  std::string_view example;  ///< of components
  bool has_legacy_syntax = false;
  bool has_legacy_percentages = false;  ///< its legacy syntax wants two percentages after the hue
};

constexpr std::string_view kRgbExample = "255 128 0", kHslExample = "210 50% 40%";
constexpr std::array<FunctionInfo, 9> kFunctions{{{"rgb", read_rgb, kRgbExample, true},
                                                  {"rgba", read_rgb, kRgbExample, true},
                                                  {"hsl", read_hsl, kHslExample, true, true},
                                                  {"hsla", read_hsl, kHslExample, true, true},
                                                  {"hwb", read_hwb, "210 20% 40%"},
                                                  {"lab", read_lab, "50 40 -60"},
                                                  {"lch", read_lch, "60 60 130"},
                                                  {"oklab", read_oklab, "0.5 0.1 -0.1"},
                                                  {"oklch", read_oklch, "0.7 0.15 250"}}};

/// Its components follow the name of a space.
constexpr FunctionInfo kInSpace{"color", nullptr, "display-p3 0.2 0.6 0.3"};

Status bad_form(const FunctionInfo& info, const std::string& why) {
  const std::string begin = std::string(info.name) + "(" + std::string(info.example);
  return bad(why + "; use " + begin + "), or " + begin + " / 50%) with an alpha");
}

/// The tokens up to the closing parenthesis, without blanks.
struct Inside {
  std::array<Token, 7> token{};
  std::size_t count = 0;
};

Result<Inside> take_inside(Tokenizer& tokens, const FunctionInfo& info) {
  Inside inside;
  for (Token token = next_solid(tokens); !token.is(close_paren) && !token.is(end);
       token = next_solid(tokens)) {
    if (token.is(function)) {
      return bad_form(info,
                      text::quoted(std::string(token.text) + ")") + " is not read within a colour");
    }
    if (inside.count == 0 && token.is(ident) && is_named(token.value, "from")) {
      return bad_form(info, "a colour relative to another one is not read");
    }
    if (inside.count == inside.token.size()) return bad_form(info, "it has too many values");
    inside.token[inside.count++] = token;
  }
  return inside;
}

/// Reads the components and the closing parenthesis. Three values, and alpha, after a comma where
/// the others have commas, else after '/'.
Result<Arguments> take_arguments(Tokenizer& tokens, const FunctionInfo& info) {
  SFUMATO_TRY_ASSIGN(const Inside& inside, take_inside(tokens, info));
  const auto& token = inside.token;
  Arguments arguments;
  arguments.has_commas = token[1].is(comma);
  const std::size_t step = arguments.has_commas ? 2 : 1;
  const std::size_t plain_count = 2 * step + 1;
  arguments.has_alpha = inside.count == plain_count + 2;
  if (inside.count != plain_count && !arguments.has_alpha) {
    return bad_form(info, "it does not have 3 values, or 3 and an alpha");
  }
  for (std::size_t i = 0; i < 3; ++i) arguments.value[i] = token[i * step];
  if (arguments.has_alpha) arguments.value[3] = token[plain_count + 1];
  const Token& mark = token[plain_count];
  const bool has_mark = arguments.has_commas ? mark.is(comma) : mark.is_delim('/');
  if (arguments.has_alpha && !has_mark) {
    return bad_form(info, arguments.has_commas ? "a comma is missing before the alpha"
                                               : "a / is missing before the alpha");
  }
  if (!arguments.has_commas || token[3].is(comma)) return arguments;
  return bad_form(info, "a comma is missing between values");
}

Status check_legacy(const FunctionInfo& info, const Arguments& arguments) {
  if (!arguments.has_commas) return ok_status();
  const std::string name = std::string(info.name) + "()";
  if (!info.has_legacy_syntax) return bad_form(info, name + " takes no commas");
  const auto& value = arguments.value;
  if (info.has_legacy_percentages) {
    if (value[1].is(percentage) && value[2].is(percentage)) return ok_status();
    return bad_form(info, name + " with commas takes percentages after the hue");
  }
  if (value[0].type == value[1].type && value[0].type == value[2].type) return ok_status();
  return bad_form(info, name + " with commas takes only numbers or only percentages");
}

template <class Read>
Result<Color> take_components(Tokenizer& tokens, const FunctionInfo& info, Read read) {
  SFUMATO_TRY_ASSIGN(const Arguments& arguments, take_arguments(tokens, info));
  SFUMATO_TRY(check_legacy(info, arguments));
  Components components(arguments);
  const SrgbColor srgb = read(components);
  const double alpha = components.alpha();
  if (!components.status()) return components.status();
  return Color{srgb.color, static_cast<float>(alpha), srgb.is_mapped};
}

Status unknown_space(const Token& named) {
  std::array<std::string_view, kColorSpaces.size()> names;
  std::ranges::transform(kColorSpaces, names.begin(),
                         [](const auto& space) { return space.first; });
  std::string list;
  for (const std::string_view name : names) list.append(list.empty() ? "" : ", ").append(name);
  if (!named.is(ident)) return bad("color() names no space first; use one of " + list);
  return bad(text::quoted(named.text) + " is not a colour space; use one of " + list +
             text::did_you_mean(ascii_lower(named.value.substr(0, 64)), names));
}

/// The rest of color().
Result<Color> take_in_space(Tokenizer& tokens) {
  const Token named = next_solid(tokens);
  const auto has_name = [&](const auto& space) {
    return named.is(ident) && is_named(named.value, space.first);
  };
  const auto found = std::ranges::find_if(kColorSpaces, has_name);
  if (found == kColorSpaces.end()) return unknown_space(named);
  return take_components(tokens, kInSpace,
                         [&](Components& c) { return read_in_space(c, found->second); });
}

}  // namespace

std::optional<Result<Color>> take_color_function(Tokenizer& tokens, std::string_view name) {
  if (is_named(name, kInSpace.name)) return take_in_space(tokens);
  const FunctionInfo* info = find_named(kFunctions, name);
  if (!info) return std::nullopt;
  return take_components(tokens, *info, info->read);
}

}  // namespace sfumato::css
