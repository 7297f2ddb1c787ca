#include "formats/svg/style/conditional.hpp"

#include <algorithm>
#include <array>

#include "base/text/ascii.hpp"
#include "formats/svg/style/vocabulary.hpp"

namespace sfumato::svg {
namespace {

/// Elements other than shapes that programs draw. A <foreignObject> is not among them: beside it
/// there is a fallback for programs without HTML.
constexpr std::array<std::string_view, 7> kDrawn{"a", "g", "image", "svg", "switch", "text", "use"};

bool is_english(std::string_view language) {
  const std::string_view tag = ascii_trimmed(language);
  return ascii_lower(tag.substr(0, 2)) == "en" && (tag.size() == 2 || tag[2] == '-');
}

bool names_english(std::string_view languages) {
  while (!languages.empty()) {
    const std::size_t comma = std::min(languages.find(','), languages.size());
    if (is_english(languages.substr(0, comma))) return true;
    languages.remove_prefix(std::min(comma + 1, languages.size()));
  }
  return false;
}

}  // namespace

bool meets_conditions(const Input& input, Element element) {
  if (input.attribute(element, "requiredExtensions")) return false;
  const auto languages = input.attribute(element, "systemLanguage");
  return !languages || names_english(*languages);
}

bool can_be_chosen(std::string_view element_name) {
  return is_shape(element_name) || std::ranges::find(kDrawn, element_name) != kDrawn.end();
}

}  // namespace sfumato::svg
