#include "formats/svg/shapes/transform.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "base/angle.hpp"
#include "base/try.hpp"
#include "formats/css/tokenizer.hpp"
#include "formats/svg/read/scanner.hpp"
#include "formats/text/suggestion.hpp"

namespace sfumato::svg {
namespace {

constexpr std::array<std::string_view, 6> kFunctions{"matrix", "translate", "scale",
                                                     "rotate", "skewX",     "skewY"};

struct Arguments {
  std::array<double, 6> value{};
  std::size_t count = 0;
};

Status read_arguments(Scanner& scanner, Arguments& arguments) {
  scanner.skip_blanks();
  if (!scanner.take('(')) return scanner.error("'('");
  scanner.skip_blanks();
  while (!scanner.take(')')) {
    if (arguments.count == arguments.value.size()) return scanner.error("')'");
    if (Status status = scanner.take_number(arguments.value[arguments.count]); !status) {
      return status;
    }
    ++arguments.count;
    scanner.skip_separator();
  }
  return ok_status();
}

Affine rotation(const Arguments& arguments) {
  const auto [angle, x, y, unused1, unused2, unused3] = arguments.value;
  const SinCos turn = sin_cos_degrees(angle);
  const Affine rotate{turn.cos, turn.sin, -turn.sin, turn.cos, 0, 0};
  return Affine{1, 0, 0, 1, x, y} * rotate * Affine{1, 0, 0, 1, -x, -y};
}

double tangent(double degrees) {
  const SinCos angle = sin_cos_degrees(degrees);
  return angle.sin / angle.cos;
}

/// False where the function takes another number of arguments.
bool to_affine(std::string_view function, const Arguments& arguments, Affine& affine) {
  const std::array<double, 6>& v = arguments.value;
  const std::size_t count = arguments.count;
  if (function == "matrix") {
    affine = {v[0], v[1], v[2], v[3], v[4], v[5]};
    return count == 6;
  }
  if (function == "translate") {
    affine = {1, 0, 0, 1, v[0], v[1]};
    return count == 1 || count == 2;
  }
  if (function == "scale") {
    affine = {v[0], 0, 0, count == 1 ? v[0] : v[1], 0, 0};
    return count == 1 || count == 2;
  }
  if (function == "rotate") {
    affine = rotation(arguments);
    return count == 1 || count == 3;
  }
  const double slope = tangent(v[0]);
  affine = function == "skewX" ? Affine{1, 0, slope, 1, 0, 0} : Affine{1, slope, 0, 1, 0, 0};
  return count == 1;
}

}  // namespace

Result<Affine> parse_transform(const Context& context, std::string_view text) {
  Scanner scanner(text);
  css::TextPoll poll(context);
  Affine product;
  for (scanner.skip_blanks(); !scanner.at_end(); scanner.skip_separator()) {
    const Scanner before = scanner;
    const std::string_view function = scanner.take_word();
    if (std::ranges::find(kFunctions, function) == kFunctions.end()) {
      return before.error("matrix, translate, scale, rotate, skewX or skewY" +
                          text::did_you_mean(function, kFunctions));
    }
    Arguments arguments;
    SFUMATO_TRY(read_arguments(scanner, arguments));
    Affine affine;
    if (!to_affine(function, arguments, affine)) {
      return before.error("another number of arguments than " + std::to_string(arguments.count));
    }
    product = product * affine;
    if (!poll.go_on(scanner.position() - before.position())) return context.cancel_status();
  }
  const double magnitude = std::abs(product.a) + std::abs(product.b) + std::abs(product.c) +
                           std::abs(product.d) + std::abs(product.e) + std::abs(product.f);
  if (!std::isfinite(magnitude)) {
    return make_error(StatusCode::bad_input, "the product is too large; use smaller numbers");
  }
  return product;
}

}  // namespace sfumato::svg
