#include "formats/svg/color.hpp"

#include "formats/css/css_value.hpp"

namespace sfumato::svg {

Result<CssColor> read_color(Input& input, Element element, CssProperty property) {
  std::string_view text = input.property(element, property).value_or("black");
  if (css_keyword(text, input.text_poll()) == "currentcolor") {
    property = CssProperty::color;
    text = input.property(element, property).value_or("black");
  }
  const Result<CssColor> color = parse_css_color(text, input.text_poll());
  if (!color) return input.in(element, css_property_name(property), color.status());
  return color;
}

}  // namespace sfumato::svg
