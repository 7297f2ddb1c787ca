#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "formats/css/names.hpp"
#include "formats/css/tokenizer.hpp"

namespace sfumato::css {

/// A property that is read, or a custom one.
struct PropertyName {
  Property property = Property::custom;
  std::string_view custom{};

  friend bool operator==(const PropertyName&, const PropertyName&) = default;
  friend auto operator<=>(const PropertyName&, const PropertyName&) = default;
};

/// Returns the name, such as "clip-path"; null-terminated.
const char* property_name(Property property);

/// Returns the property with this name as written: in any case, with escapes.
std::optional<Property> property_of(std::string_view raw_name);

/// Returns whether an element without a value takes its parent's.
bool is_inherited(Property property);

/// Returns how the attribute with the property's name sets it.
AttributeUse attribute_use(Property property);

/// The keywords that any property accepts.
enum class WideKeyword : std::uint8_t { none, inherit, initial, unset, revert, revert_layer };

/// Returns the keyword that a value is; WideKeyword::none for other values.
WideKeyword wide_keyword(std::string_view value, TextPoll& poll);

/// Where a value stands. In an attribute lengths need no unit, and `transform` and `d` have the
/// syntax of SVG.
enum class ValueSyntax : std::uint8_t { declaration, attribute };

/// Returns whether CSS keeps a declaration with this value, as far as the property is understood
/// here. A value with var() is kept. Values of attributes in SVG's own syntax are not checked.
bool is_value(Property property, std::string_view value, TextPoll& poll,
              ValueSyntax syntax = ValueSyntax::declaration);

/// Returns whether a value of `width`, `height`, `rx` or `ry` is `auto` or a word that SVG takes
/// for it.
bool is_auto_size(std::string_view value, TextPoll& poll);

/// Returns the path data of the property `d`: path("…") in a declaration. Empty for `none`; no
/// value if it is invalid or written with escapes.
std::optional<std::string_view> path_data_of(std::string_view value, TextPoll& poll);

/// "; did you mean screen?" for a value that CSS drops; empty if no word is similar.
std::string value_hint(Property property, std::string_view value, TextPoll& poll);

}  // namespace sfumato::css
