#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "formats/css/css_tokenizer.hpp"

namespace sfumato {

/// The properties of CSS that documents are asked for.
enum class CssProperty : std::uint8_t {
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

inline constexpr std::size_t kCssPropertyCount = 27;

/// "clip-path"; ends with a zero.
const char* css_property_name(CssProperty property);

/// The property of a name as it is written: in any case, with escapes.
std::optional<CssProperty> css_property_of(std::string_view raw_name);

/// Whether an element takes the value of its parent where it has none itself.
bool is_inherited(CssProperty property);

/// The words that any property may have for a value.
enum class CssWideKeyword : std::uint8_t { none, inherit, initial, unset, revert, revert_layer };

/// Which of them a value is; none where it is none of them.
CssWideKeyword css_wide_keyword(std::string_view value, TextPoll& poll);

/// Whether CSS keeps a declaration with this value, as far as the property is understood here.
bool is_css_value(CssProperty property, std::string_view value, TextPoll& poll);

/// "; did you mean screen?" of a value that CSS drops; nothing where no word is near.
std::string css_value_hint(CssProperty property, std::string_view value, TextPoll& poll);

}  // namespace sfumato
