#include "formats/css/length.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "formats/css/value.hpp"

namespace sfumato::css {
namespace {

using enum TokenType;

/// In the order of Unit.
constexpr std::array<std::string_view, 17> kUnits{"",    "%",  "px", "pt",   "pc",  "mm",
                                                  "cm",  "in", "q",  "em",   "ex",  "ch",
                                                  "rem", "vw", "vh", "vmin", "vmax"};

struct SizeWord {
  std::string_view name;
  double pixels;
};

/// CSS Fonts 4, section 2.5, for a medium size of 16 px.
constexpr std::array<SizeWord, 8> kSizeWords{{{"xx-small", 9},
                                              {"x-small", 10},
                                              {"small", 13},
                                              {"medium", 16},
                                              {"large", 18},
                                              {"x-large", 24},
                                              {"xx-large", 32},
                                              {"xxx-large", 48}}};
/// Factor of `larger`; `smaller` divides by it.
constexpr double kSizeStep = 1.2;

}  // namespace

std::optional<Unit> unit_of(std::string_view name) {
  for (std::size_t i = 0; i < kUnits.size(); ++i) {
    if (is_named(name, kUnits[i])) return static_cast<Unit>(i);
  }
  return std::nullopt;
}

std::optional<Length> length_of(const Token& token) {
  if (!token.is(number) && !token.is(percentage) && !token.is(dimension)) return std::nullopt;
  const auto value = number_of(token);
  const auto unit = token.is(percentage) ? Unit::percent : unit_of(token.unit);
  if (!value || !unit) return std::nullopt;
  return Length{*value, *unit};
}

double in_pixels(const Length& length, const UnitSizes& sizes, double whole) {
  const auto [value, unit] = length;
  switch (unit) {
    case Unit::number:
    case Unit::px:
      return value;
    case Unit::percent:
      return value / 100 * whole;
    case Unit::pt:
      return value * (96.0 / 72);
    case Unit::pc:
      return value * 16;
    case Unit::mm:
      return value * (96 / 25.4);
    case Unit::cm:
      return value * (96 / 2.54);
    case Unit::in:
      return value * 96;
    case Unit::q:
      return value * (96 / 101.6);
    case Unit::em:
      return value * sizes.em;
    case Unit::ex:
    case Unit::ch:
      return value * sizes.em / 2;
    case Unit::rem:
      return value * sizes.rem;
    case Unit::vw:
      return value / 100 * sizes.viewport.x;
    case Unit::vh:
      return value / 100 * sizes.viewport.y;
    case Unit::vmin:
      return value / 100 * std::min(sizes.viewport.x, sizes.viewport.y);
    case Unit::vmax:
      return value / 100 * std::max(sizes.viewport.x, sizes.viewport.y);
  }
  return value;
}

std::optional<double> font_size_of(std::string_view text, const UnitSizes& outer, bool needs_unit,
                                   TextPoll& poll) {
  const auto token = only_token(text, poll);
  if (!token) return std::nullopt;
  if (token->is(ident)) {
    if (const SizeWord* word = find_named(kSizeWords, token->value)) return word->pixels;
    if (is_named(token->value, "larger")) return outer.em * kSizeStep;
    if (is_named(token->value, "smaller")) return outer.em / kSizeStep;
    return std::nullopt;
  }
  const auto length = length_of(*token);
  if (!length || length->value < 0) return std::nullopt;
  if (needs_unit && length->unit == Unit::number && length->value != 0) return std::nullopt;
  return in_pixels(*length, outer, outer.em);
}

}  // namespace sfumato::css
