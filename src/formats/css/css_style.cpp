#include "formats/css/css_style.hpp"

namespace sfumato {

void CssStyle::add(const CssDeclaration& declaration, TextPoll& poll) {
  ++declaration_count_;
  if (css_is_name(declaration.name, "all")) {
    if (css_wide_keyword(declaration.value, poll) == CssWideKeyword::none) return;
    for (std::size_t i = 0; i < kCssPropertyCount; ++i) {
      set(static_cast<CssProperty>(i), declaration);
    }
    return;
  }
  const auto property = css_property_of(declaration.name);
  if (!property) return;
  if (is_css_value(*property, declaration.value, poll)) return set(*property, declaration);
  if (!dropped_) dropped_ = declaration;
}

void CssStyle::set(CssProperty property, const CssDeclaration& declaration) {
  std::optional<CssSetting>& setting = settings_[static_cast<std::size_t>(property)];
  if (setting && setting->is_important && !declaration.is_important) return;
  setting = CssSetting{declaration.value, declaration.is_important};
}

}  // namespace sfumato
