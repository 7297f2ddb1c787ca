#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "formats/css/tokenizer.hpp"

namespace sfumato::css {

/// The CSS properties that are read from documents.
enum class Property : std::uint8_t {
  clip_path,
  color,
  display,
  fill,
  fill_opacity,
  fill_rule,
  filter,
  isolation,
  mask,
  mix_blend_mode,
  opacity,
  overflow,
  paint_order,
  stop_color,
  stop_opacity,
  stroke,
  stroke_dasharray,
  stroke_dashoffset,
  stroke_linecap,
  stroke_linejoin,
  stroke_miterlimit,
  stroke_opacity,
  stroke_width,
  transform,
  transform_box,
  transform_origin,
  visibility
};

inline constexpr std::size_t kPropertyCount = 27;

/// The name, such as "clip-path"; null-terminated.
const char* property_name(Property property);

/// The property with this name as written: in any case, with escapes.
std::optional<Property> property_of(std::string_view raw_name);

/// Whether an element without a value takes its parent's.
bool is_inherited(Property property);

/// The keywords that any property accepts.
enum class WideKeyword : std::uint8_t { none, inherit, initial, unset, revert, revert_layer };

/// The keyword that a value is; WideKeyword::none for other values.
WideKeyword wide_keyword(std::string_view value, TextPoll& poll);

/// Whether CSS keeps a declaration with this value, as far as the property is understood here.
bool is_value(Property property, std::string_view value, TextPoll& poll);

/// "; did you mean screen?" for a value that CSS drops; empty if no word is similar.
std::string value_hint(Property property, std::string_view value, TextPoll& poll);

}  // namespace sfumato::css
