#include "formats/svg/paint/background.hpp"

#include <algorithm>
#include <string_view>

#include "base/try.hpp"
#include "formats/css/value.hpp"
#include "formats/svg/shapes/shapes.hpp"
#include "formats/svg/style/color.hpp"

namespace sfumato::svg {
namespace {

/// A share of the artboard's size: rectangles that are smaller by this still cover it.
constexpr double kSlack = 1e-6;

bool is_one(Input& input, Element rect, css::Property property) {
  const auto text = input.property(rect, property);
  return !text || css::share_of(*text, input.text_poll()) == 1;
}

bool is_opaque(Input& input, Element rect) {
  return is_one(input, rect, css::Property::opacity) &&
         is_one(input, rect, css::Property::fill_opacity);
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
                                            const Affine& artboard_from_user, const Box& artboard,
                                            const Box& viewport) {
  if (std::string_view(shape.name()) != "rect") return BackgroundRect{};
  SFUMATO_TRY_ASSIGN(const Box& rect, read_rect(input, shape, viewport));
  if (!covers(rect, artboard_from_user, artboard)) return BackgroundRect{};
  const std::string_view fill = input.property(shape, css::Property::fill).value_or("black");
  css::Tokenizer tokens(fill, input.text_poll());
  const css::Token first = next_solid(tokens);
  if (first.is(css::TokenType::ident) && css::is_named(first.value, "none")) {
    return BackgroundRect{true, std::nullopt};
  }
  if (css::take_url(tokens, first) || !is_opaque(input, shape)) return BackgroundRect{};
  SFUMATO_TRY_ASSIGN(const css::Color& color, read_color(input, shape, css::Property::fill));
  if (color.alpha < 1) return BackgroundRect{};
  return BackgroundRect{true, color.color};
}

Result<std::optional<css::Color>> read_root_background(Input& input) {
  using Color = std::optional<css::Color>;
  const auto text = input.property(input.root(), css::Property::background_color);
  if (!text || css::keyword_of(*text, input.text_poll()) == "none") return Color();
  SFUMATO_TRY_ASSIGN(const css::Color& color,
                     read_color(input, input.root(), css::Property::background_color));
  return color.alpha > 0 ? Color(color) : Color();
}

}  // namespace sfumato::svg
