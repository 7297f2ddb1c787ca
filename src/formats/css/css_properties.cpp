#include "formats/css/css_properties.hpp"

#include <algorithm>
#include <span>

#include "document/blend_names.hpp"
#include "formats/css/css_color.hpp"
#include "formats/css/css_value.hpp"
#include "formats/text/suggestion.hpp"

namespace sfumato {
namespace {

using Words = std::span<const std::string_view>;

/// In the order of CssProperty, which is that of the names.
constexpr std::array<const char*, kCssPropertyCount> kNames{"clip-path",
                                                            "color",
                                                            "display",
                                                            "fill",
                                                            "fill-opacity",
                                                            "fill-rule",
                                                            "filter",
                                                            "isolation",
                                                            "mask",
                                                            "mix-blend-mode",
                                                            "opacity",
                                                            "overflow",
                                                            "paint-order",
                                                            "stop-color",
                                                            "stop-opacity",
                                                            "stroke",
                                                            "stroke-dasharray",
                                                            "stroke-dashoffset",
                                                            "stroke-linecap",
                                                            "stroke-linejoin",
                                                            "stroke-miterlimit",
                                                            "stroke-opacity",
                                                            "stroke-width",
                                                            "transform",
                                                            "transform-box",
                                                            "transform-origin",
                                                            "visibility"};

/// In the order of CssWideKeyword, from `inherit`.
constexpr std::array<std::string_view, 5> kWideKeywords{"inherit", "initial", "unset", "revert",
                                                        "revert-layer"};

constexpr std::array<std::string_view, 28> kDisplays{"none",
                                                     "inline",
                                                     "block",
                                                     "contents",
                                                     "flow",
                                                     "flow-root",
                                                     "inline-block",
                                                     "list-item",
                                                     "run-in",
                                                     "table",
                                                     "inline-table",
                                                     "table-row-group",
                                                     "table-header-group",
                                                     "table-footer-group",
                                                     "table-row",
                                                     "table-cell",
                                                     "table-column-group",
                                                     "table-column",
                                                     "table-caption",
                                                     "flex",
                                                     "inline-flex",
                                                     "grid",
                                                     "inline-grid",
                                                     "ruby",
                                                     "ruby-base",
                                                     "ruby-text",
                                                     "ruby-base-container",
                                                     "ruby-text-container"};
constexpr std::array<std::string_view, 2> kIsolations{"auto", "isolate"};
constexpr std::array<std::string_view, 5> kOverflows{"visible", "hidden", "clip", "scroll", "auto"};
constexpr std::array<std::string_view, 3> kVisibilities{"visible", "hidden", "collapse"};

/// One to `most` of the words, in any order.
bool is_words(std::string_view value, Words words, std::size_t most, TextPoll& poll) {
  CssTokenizer tokens(value, poll);
  std::size_t count = 0;
  for (CssToken token = next_solid(tokens); !token.is(CssTokenType::end);
       token = next_solid(tokens)) {
    const auto is_token = [&](std::string_view word) { return css_is_name(token.value, word); };
    if (!token.is(CssTokenType::ident) || std::ranges::none_of(words, is_token)) return false;
    if (++count > most) return false;
  }
  return count > 0;
}

/// The words that the value of a property is made of; none where it is something else.
Words words_of(CssProperty property) {
  switch (property) {
    case CssProperty::display:
      return kDisplays;
    case CssProperty::isolation:
      return kIsolations;
    case CssProperty::mix_blend_mode:
      return kBlendNames;
    case CssProperty::overflow:
      return kOverflows;
    case CssProperty::visibility:
      return kVisibilities;
    default:
      return {};
  }
}

/// How many words a value may have.
std::size_t most_words(CssProperty property) {
  if (property == CssProperty::display) return 3;
  return property == CssProperty::overflow ? 2 : 1;
}

bool is_color(std::string_view value, TextPoll& poll) {
  return css_keyword(value, poll) == "currentcolor" || parse_css_color(value, poll).ok();
}

/// `none`, a colour, or an url with what to paint where it leads nowhere.
bool is_paint(std::string_view value, TextPoll& poll) {
  CssTokenizer tokens(value, poll);
  const CssToken first = next_solid(tokens);
  if (take_css_url(tokens, first)) {
    value.remove_prefix(tokens.position());
    CssTokenizer rest(value, poll);
    return next_solid(rest).is(CssTokenType::end) || is_paint(value, poll);
  }
  const auto word = css_keyword(value, poll);
  return word == "none" || word == "context-fill" || word == "context-stroke" ||
         is_color(value, poll);
}

}  // namespace

const char* css_property_name(CssProperty property) {
  return kNames[static_cast<std::size_t>(property)];
}

std::optional<CssProperty> css_property_of(std::string_view raw_name) {
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (css_is_name(raw_name, kNames[i])) return static_cast<CssProperty>(i);
  }
  return std::nullopt;
}

bool is_inherited(CssProperty property) {
  return property == CssProperty::color || property == CssProperty::fill ||
         property == CssProperty::fill_opacity || property == CssProperty::fill_rule ||
         property == CssProperty::paint_order || property == CssProperty::visibility ||
         (property >= CssProperty::stroke && property <= CssProperty::stroke_width);
}

CssWideKeyword css_wide_keyword(std::string_view value, TextPoll& poll) {
  // Most values are told from these words by their first letter.
  const auto token = css_only_token(value, poll);
  if (!token || !token->is(CssTokenType::ident)) return CssWideKeyword::none;
  for (std::size_t i = 0; i < kWideKeywords.size(); ++i) {
    if (css_is_name(token->value, kWideKeywords[i])) return static_cast<CssWideKeyword>(i + 1);
  }
  return CssWideKeyword::none;
}

bool is_css_value(CssProperty property, std::string_view value, TextPoll& poll) {
  if (css_wide_keyword(value, poll) != CssWideKeyword::none) return true;
  switch (property) {
    case CssProperty::opacity:
    case CssProperty::fill_opacity:
    case CssProperty::stop_opacity:
    case CssProperty::stroke_opacity:
      return css_share(value, poll).has_value();
    case CssProperty::color:
    case CssProperty::stop_color:
      return is_color(value, poll);
    case CssProperty::fill:
    case CssProperty::stroke:
      return is_paint(value, poll);
    case CssProperty::display:
    case CssProperty::isolation:
    case CssProperty::mix_blend_mode:
    case CssProperty::overflow:
    case CssProperty::visibility:
      return is_words(value, words_of(property), most_words(property), poll);
    case CssProperty::paint_order:
      return css_paint_order(value, poll).has_value();
    case CssProperty::fill_rule:
    case CssProperty::stroke_dasharray:
    case CssProperty::stroke_dashoffset:
    case CssProperty::stroke_linecap:
    case CssProperty::stroke_linejoin:
    case CssProperty::stroke_miterlimit:
    case CssProperty::stroke_width:
      break;  // who reads them tells what is wrong
    case CssProperty::clip_path:
    case CssProperty::filter:
    case CssProperty::mask:
    case CssProperty::transform:
    case CssProperty::transform_box:
    case CssProperty::transform_origin:
      break;  // they are not read: that there is a value is all
  }
  CssTokenizer tokens(value, poll);
  return !next_solid(tokens).is(CssTokenType::end);
}

std::string css_value_hint(CssProperty property, std::string_view value, TextPoll& poll) {
  const auto word = css_keyword(value, poll);
  if (!word) return {};
  const Words words = words_of(property);
  if (!words.empty()) return did_you_mean(*word, words);
  const bool is_paint = property == CssProperty::fill || property == CssProperty::color ||
                        property == CssProperty::stop_color;
  return is_paint ? did_you_mean_color(*word) : std::string();
}

}  // namespace sfumato
