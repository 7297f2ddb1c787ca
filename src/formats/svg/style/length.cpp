#include "formats/svg/style/length.hpp"

#include <cmath>
#include <string>

#include "base/text/ascii.hpp"
#include "base/try.hpp"
#include "formats/svg/read/scanner.hpp"
#include "formats/text/suggestion.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato::svg {
namespace {

Status unknown_unit(std::string_view text, std::string_view units) {
  return make_error(StatusCode::bad_input,
                    text::quoted(text) + " has an unknown unit; use " + std::string(units));
}

/// units   the units that the message names
Result<css::Length> scan_length(std::string_view text, std::string_view units) {
  Scanner scanner(ascii_trimmed(text));
  css::Length length;
  SFUMATO_TRY(scanner.take_number(length.value));
  const auto unit = css::unit_of(scanner.rest());
  if (!unit) return unknown_unit(text, units);
  length.unit = *unit;
  return length;
}

}  // namespace

double extent(const Box& viewport, Axis axis) {
  switch (axis) {
    case Axis::x:
      return viewport.width();
    case Axis::y:
      return viewport.height();
    case Axis::diagonal:
      return length({viewport.width(), viewport.height()}) / std::sqrt(2.0);
  }
  return 0;
}

Result<css::Length> read_length(std::string_view text) {
  return scan_length(text, "px, em, % or another unit of CSS");
}

Result<double> user_length(const css::Length& length, const css::UnitSizes& sizes,
                           const Box& viewport, Axis axis, std::string_view text) {
  const double value = css::in_pixels(length, sizes, extent(viewport, axis));
  if (std::abs(value) <= limits::kCoordinate || length.unit == css::Unit::percent) return value;
  return make_error(StatusCode::bad_input,
                    text::quoted(text) + " is too long; use a magnitude of at most " +
                        std::to_string(static_cast<long>(limits::kCoordinate)) + " px");
}

Result<double> parse_length(std::string_view text, const Box& viewport, Axis axis) {
  constexpr std::string_view kUnits = "px, pt, pc, mm, cm, in or %";
  SFUMATO_TRY_ASSIGN(const css::Length& length, scan_length(text, kUnits));
  if (css::is_relative(length.unit)) return unknown_unit(text, kUnits);
  return user_length(length, {}, viewport, axis, text);
}

}  // namespace sfumato::svg
