#include "formats/svg/length.hpp"

#include <array>
#include <cmath>
#include <string>

#include "base/ascii.hpp"
#include "formats/svg/scanner.hpp"
#include "formats/text/suggestion.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato::svg {
namespace {

struct Unit {
  std::string_view name;
  double pixels;
};

constexpr std::array<Unit, 7> kUnits{{{"", 1},
                                      {"px", 1},
                                      {"pt", 96.0 / 72},
                                      {"pc", 16},
                                      {"mm", 96 / 25.4},
                                      {"cm", 96 / 2.54},
                                      {"in", 96}}};

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

Result<double> parse_length(std::string_view text, const Box& viewport, Axis axis) {
  Scanner scanner(ascii_trimmed(text));
  double number = 0;
  if (Status status = scanner.take_number(number); !status) return status;
  const std::string unit_name = ascii_lower(scanner.rest());
  if (unit_name == "%") return number / 100 * extent(viewport, axis);
  for (const Unit& unit : kUnits) {
    if (unit.name != unit_name) continue;
    const double value = number * unit.pixels;
    if (std::abs(value) <= limits::kCoordinate) return value;
    return make_error(StatusCode::bad_input,
                      text::quoted(text) + " is too long; expected a magnitude of at most " +
                          std::to_string(static_cast<long>(limits::kCoordinate)) + " px");
  }
  return make_error(
      StatusCode::bad_input,
      text::quoted(text) + " has an unknown unit; expected px, pt, pc, mm, cm, in or %");
}

}  // namespace sfumato::svg
