#include "formats/svg/color.hpp"

#include "formats/css/value.hpp"

namespace sfumato::svg {

Result<css::Color> read_color(Input& input, Element element, css::Property property) {
  std::string_view text = input.property(element, property).value_or("black");
  if (css::keyword_of(text, input.text_poll()) == "currentcolor") {
    property = css::Property::color;
    text = input.property(element, property).value_or("black");
  }
  const Result<css::Color> color = css::parse_color(text, input.text_poll());
  if (!color) return input.in(element, css::property_name(property), color.status());
  return color;
}

}  // namespace sfumato::svg
