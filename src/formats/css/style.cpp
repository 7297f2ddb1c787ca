#include "formats/css/style.hpp"

#include <algorithm>

#include "formats/css/value.hpp"
#include "formats/css/variables.hpp"

namespace sfumato::css {
namespace {

/// The last important declaration of a property wins, else the last declaration.
bool replaces(const Declaration& declaration, bool is_important) {
  return declaration.is_important || !is_important;
}

}  // namespace

void Style::add(const Declaration& declaration, TextPoll& poll) {
  ++declaration_count_;
  if (is_named(declaration.name, "all")) {
    if (wide_keyword(declaration.value, poll) == WideKeyword::none) return;
    for (std::size_t i = 0; i < kPropertyCount; ++i) {
      set(static_cast<Property>(i), declaration);
    }
    return;
  }
  if (is_named(declaration.name, "marker")) return set_markers(declaration, poll);
  if (is_named(declaration.name, "background")) return set_background(declaration, poll);
  if (declaration.name.starts_with("--")) return set_variable(declaration, poll);
  const auto property = property_of(declaration.name);
  if (!property) return;
  if (is_value(*property, declaration.value, poll)) return set(*property, declaration);
  drop(declaration);
}

void Style::set_markers(const Declaration& declaration, TextPoll& poll) {
  if (!is_value(Property::marker_start, declaration.value, poll)) return drop(declaration);
  for (const Property each : {Property::marker_start, Property::marker_mid, Property::marker_end}) {
    set(each, declaration);
  }
}

/// A colour alone, or `none`: other backgrounds are not read.
void Style::set_background(const Declaration& declaration, TextPoll& poll) {
  const bool is_color = is_value(Property::background_color, declaration.value, poll) ||
                        keyword_of(declaration.value, poll) == "none";
  if (!is_color) return drop(declaration);
  set(Property::background_color, declaration);
}

bool Style::empty() const {
  const auto is_set = [](const std::optional<Setting>& setting) { return setting.has_value(); };
  return variables_.empty() && std::ranges::none_of(settings_, is_set);
}

void Style::set_variable(const Declaration& declaration, TextPoll& poll) {
  const bool is_read = is_variable_name(declaration.name) &&
                       variables_in(declaration.value, poll) != Variables::invalid;
  if (!is_read) return drop(declaration);
  const auto found = variables_.find(declaration.name);
  if (found == variables_.end()) {
    if (variables_.size() == kVariablesPerBlock) return drop(declaration);
    variables_.emplace(declaration.name, Setting{declaration.value, declaration.is_important});
  } else if (replaces(declaration, found->second.is_important)) {
    found->second = {declaration.value, declaration.is_important};
  }
}

void Style::set(Property property, const Declaration& declaration) {
  std::optional<Setting>& setting = settings_[static_cast<std::size_t>(property)];
  if (setting && !replaces(declaration, setting->is_important)) return;
  setting = Setting{declaration.value, declaration.is_important};
}

}  // namespace sfumato::css
