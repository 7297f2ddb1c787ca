#include "formats/svg/style/color.hpp"

#include <string>

#include "base/text/ascii.hpp"
#include "formats/css/value.hpp"
#include "formats/text/suggestion.hpp"

namespace sfumato::svg {

Result<css::Color> parse_color(Input& input, Element element, std::string_view attribute,
                               std::string_view text) {
  Result<css::Color> color = css::parse_color(text, input.text_poll());
  if (color && color->is_mapped) warn_of_mapped(input, element, attribute, text);
  return color;
}

void warn_of_mapped(Input& input, Element element, std::string_view attribute,
                    std::string_view text) {
  input.warn("/gamut", element,
             std::string(attribute) + " of " + tag(element) + ": the colour " +
                 text::quoted(ascii_trimmed(text)) +
                 " lies outside sRGB; such colours become the nearest ones of sRGB, as CSS Color 4 "
                 "maps them");
}

Result<css::Color> read_color(Input& input, Element element, css::Property property) {
  std::string_view text = input.property(element, property).value_or("black");
  if (css::keyword_of(text, input.text_poll()) == "currentcolor") {
    property = css::Property::color;
    text = input.property(element, property).value_or("black");
  }
  const char* name = css::property_name(property);
  Result<css::Color> color = parse_color(input, element, name, text);
  if (!color) return input.in(element, name, color.status());
  return color;
}

}  // namespace sfumato::svg
