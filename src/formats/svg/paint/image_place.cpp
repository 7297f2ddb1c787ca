#include "formats/svg/paint/image_place.hpp"

#include <cmath>
#include <limits>

#include "base/try.hpp"
#include "formats/svg/shapes/shapes.hpp"

namespace sfumato::svg {

Result<Box> read_image_box(Input& input, const StyleScope& scope, const Box& viewport,
                           Vec2 natural) {
  constexpr double kAuto = std::numeric_limits<double>::quiet_NaN();
  const Result<double> x = length_of(input, scope, "x", viewport, Axis::x, 0);
  SFUMATO_TRY(x);
  const Result<double> y = length_of(input, scope, "y", viewport, Axis::y, 0);
  SFUMATO_TRY(y);
  SFUMATO_TRY_ASSIGN(const double width,
                     length_of(input, scope, "width", viewport, Axis::x, kAuto));
  SFUMATO_TRY_ASSIGN(const double height,
                     length_of(input, scope, "height", viewport, Axis::y, kAuto));
  Vec2 size{width, height};
  if (std::isnan(size.x)) {
    size.x = std::isnan(size.y) ? natural.x : size.y * natural.x / natural.y;
  }
  if (std::isnan(size.y)) size.y = size.x * natural.y / natural.x;
  return Box{{*x, *y}, Vec2{*x, *y} + size};
}

Result<AspectRatio> read_aspect_ratio(Input& input, Element bearer) {
  const auto text = bearer ? input.attribute(bearer, "preserveAspectRatio") : std::nullopt;
  if (!text) return AspectRatio{};
  Result<AspectRatio> ratio = parse_aspect_ratio(*text);
  if (!ratio) return input.in(bearer, "preserveAspectRatio", ratio.status());
  return ratio;
}

}  // namespace sfumato::svg
