#include "formats/css/style.hpp"

namespace sfumato::css {

void Style::add(const Declaration& declaration, TextPoll& poll) {
  ++declaration_count_;
  if (is_named(declaration.name, "all")) {
    if (wide_keyword(declaration.value, poll) == WideKeyword::none) return;
    for (std::size_t i = 0; i < kPropertyCount; ++i) {
      set(static_cast<Property>(i), declaration);
    }
    return;
  }
  const auto property = property_of(declaration.name);
  if (!property) return;
  if (is_value(*property, declaration.value, poll)) return set(*property, declaration);
  if (!dropped_) dropped_ = declaration;
}

void Style::set(Property property, const Declaration& declaration) {
  std::optional<Setting>& setting = settings_[static_cast<std::size_t>(property)];
  if (setting && setting->is_important && !declaration.is_important) return;
  setting = Setting{declaration.value, declaration.is_important};
}

}  // namespace sfumato::css
