#include "formats/svg/compositing.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "formats/blend_names.hpp"
#include "formats/number.hpp"
#include "formats/suggestion.hpp"

namespace sfumato::svg {
namespace {

constexpr std::array<const char*, 5> kIgnoredEffects{"clip-path", "mask", "filter",
                                                     "transform-origin", "transform-box"};

}  // namespace

Result<Compositing> read_compositing(Input& input, Element element) {
  Compositing compositing;
  if (const auto text = input.property(element, "opacity")) {
    const bool is_percentage = text->ends_with('%');
    const auto number = parse_number(is_percentage ? text->substr(0, text->size() - 1) : *text);
    if (!number) {
      return input.error(element, "opacity of " + tag(element) + " is " + quoted(*text) +
                                      "; expected a number from 0 to 1 or a percentage");
    }
    const double share = is_percentage ? *number / 100 : *number;
    compositing.opacity = static_cast<float>(std::clamp(share, 0.0, 1.0));
  }
  if (const auto text = input.property(element, "mix-blend-mode")) {
    const auto found = std::ranges::find(kBlendNames, *text);
    if (found != kBlendNames.end()) {
      compositing.blend = static_cast<BlendMode>(found - kBlendNames.begin());
    } else {
      input.warn("/blend " + std::string(text->substr(0, 64)), element,
                 "mix-blend-mode " + quoted(*text) + " is not known; normal is used" +
                     did_you_mean(*text, kBlendNames));
    }
  }
  compositing.isolated = input.property(element, "isolation").value_or("auto") == "isolate";
  return compositing;
}

void warn_of_effects(Input& input, Element element) {
  for (const char* name : kIgnoredEffects) {
    const auto value = input.property(element, name);
    if (!value || value->empty() || *value == "none") continue;
    input.warn(std::string("/") + name, element,
               std::string(name) + " of " + tag(element) + " is not read");
  }
}

}  // namespace sfumato::svg
