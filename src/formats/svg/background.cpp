#include "formats/svg/background.hpp"

#include <algorithm>
#include <string_view>

#include "formats/css_color.hpp"
#include "formats/css_text.hpp"
#include "formats/number.hpp"
#include "formats/svg/shapes.hpp"

namespace sfumato::svg {
namespace {

/// Of the artboard's size: rectangles this much smaller still cover it.
constexpr double kSlack = 1e-6;

bool is_one(std::string_view text) {
  const bool is_percentage = text.ends_with('%');
  const auto number = parse_number(is_percentage ? text.substr(0, text.size() - 1) : text);
  return number && *number >= (is_percentage ? 100 : 1);
}

bool is_opaque(const Input& input, Element rect) {
  return is_one(input.property(rect, "opacity").value_or("1")) &&
         is_one(input.inherited_property(rect, "fill-opacity").value_or("1"));
}

bool covers(const Box& rect, const Affine& map, const Box& artboard) {
  if (!((map.b == 0 && map.c == 0) || (map.a == 0 && map.d == 0))) return false;
  Box box;
  box.extend(map(rect.min));
  box.extend(map(rect.max));
  const double slack = kSlack * std::max(artboard.width(), artboard.height());
  const Box grown = box.grown_by(slack);
  return grown.contains(artboard.min) && grown.contains(artboard.max);
}

}  // namespace

Result<BackgroundRect> read_background_rect(Input& input, Element shape,
                                            const Affine& artboard_from_user, const Box& artboard) {
  if (std::string_view(shape.name()) != "rect") return BackgroundRect{};
  const Result<Box> rect = read_rect(input, shape, artboard);
  if (!rect) return rect.status();
  if (!covers(*rect, artboard_from_user, artboard)) return BackgroundRect{};
  const std::string_view fill = input.inherited_property(shape, "fill").value_or("black");
  if (fill == "none") return BackgroundRect{true, std::nullopt};
  if (css_url(fill) || !is_opaque(input, shape)) return BackgroundRect{};
  const Result<CssColor> color = parse_css_color(fill);
  if (!color) return input.in(shape, "fill", color.status());
  if (color->alpha < 1) return BackgroundRect{};
  return BackgroundRect{true, color->color};
}

}  // namespace sfumato::svg
