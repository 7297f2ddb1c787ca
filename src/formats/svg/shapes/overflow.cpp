#include "formats/svg/shapes/overflow.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "formats/css/value.hpp"

namespace sfumato::svg {
namespace {

constexpr std::array<std::string_view, 6> kWithViewport{"foreignObject", "image", "marker",
                                                        "pattern",       "svg",   "symbol"};

bool has_own_viewport(const Input& input, Element element) {
  return element != input.root() &&
         std::ranges::find(kWithViewport, element.name()) != kWithViewport.end();
}

}  // namespace

bool hides_overflow(Input& input, Element element) {
  for (; element && element.type() == pugi::node_element; element = element.parent()) {
    const Input::Cascaded own = input.cascaded(element, css::Property::overflow);
    if (own.value) {
      const std::string word = css::keyword_of(*own.value, input.text_poll()).value_or("");
      return word != "visible" && word != "auto";
    }
    const bool is_said =
        own.keyword != css::WideKeyword::none && own.keyword != css::WideKeyword::revert;
    if (!is_said) return has_own_viewport(input, element);
    if (own.keyword != css::WideKeyword::inherit) return false;
  }
  return false;
}

}  // namespace sfumato::svg
