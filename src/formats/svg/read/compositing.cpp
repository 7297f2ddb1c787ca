#include "formats/svg/read/compositing.hpp"

#include <algorithm>

#include "document/names.hpp"
#include "formats/css/value.hpp"
#include "formats/text/suggestion.hpp"

namespace sfumato::svg {
namespace {

constexpr css::Property kIgnoredEffects[] = {css::Property::clip_path, css::Property::mask,
                                             css::Property::filter};

}  // namespace

Result<Compositing> read_compositing(Input& input, Element element) {
  Compositing compositing;
  if (const auto text = input.property(element, css::Property::opacity)) {
    const auto share = css::share_of(*text, input.text_poll());
    if (!share) {
      const std::string wrong = "opacity of " + tag(element) + " is " + text::quoted(*text) +
                                "; use a number from 0 to 1 or a percentage";
      if (!input.forgives(element)) return input.error(element, wrong);
      input.warn("/opacity", element, wrong + "; it is ignored");
    }
    compositing.opacity = static_cast<float>(share.value_or(1));
  }
  if (const auto text = input.property(element, css::Property::mix_blend_mode)) {
    const std::string word = css::keyword_of(*text, input.text_poll()).value_or(std::string(*text));
    const auto found = std::ranges::find(kBlendNames, word);
    if (found != kBlendNames.end()) {
      compositing.blend = static_cast<BlendMode>(found - kBlendNames.begin());
    } else {
      input.warn("/blend " + word.substr(0, 64), element,
                 "mix-blend-mode " + text::quoted(*text) + " is not known; normal is used" +
                     text::did_you_mean(word, kBlendNames));
    }
  }
  compositing.isolated = input.keyword(element, css::Property::isolation) == "isolate";
  return compositing;
}

void warn_of_effects(Input& input, Element element, const ReadEffects& read) {
  for (const css::Property property : kIgnoredEffects) {
    if (property == css::Property::clip_path && read.clip_path) continue;
    if (property == css::Property::mask && read.mask) continue;
    if (property == css::Property::filter && read.filter) continue;
    const auto value = input.property(element, property);
    if (!value || value->empty() || css::keyword_of(*value, input.text_poll()) == "none") continue;
    const std::string name = css::property_name(property);
    input.warn("/" + name, element, name + " of " + tag(element) + " is not read");
  }
}

}  // namespace sfumato::svg
