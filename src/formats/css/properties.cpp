#include "formats/css/properties.hpp"

#include <algorithm>
#include <span>

#include "document/blend_names.hpp"
#include "formats/css/color.hpp"
#include "formats/css/value.hpp"
#include "formats/text/suggestion.hpp"

namespace sfumato::css {
namespace {

using Words = std::span<const std::string_view>;

/// In the order of Property, which is that of the names.
constexpr std::array<const char*, kPropertyCount> kNames{"clip-path",
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

/// In the order of WideKeyword, from `inherit`.
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
  Tokenizer tokens(value, poll);
  std::size_t count = 0;
  for (Token token = next_solid(tokens); !token.is(TokenType::end); token = next_solid(tokens)) {
    const auto is_token = [&](std::string_view word) { return is_named(token.value, word); };
    if (!token.is(TokenType::ident) || std::ranges::none_of(words, is_token)) return false;
    if (++count > most) return false;
  }
  return count > 0;
}

/// The words that the value of a property is made of; none where it is something else.
Words words_of(Property property) {
  switch (property) {
    case Property::display:
      return kDisplays;
    case Property::isolation:
      return kIsolations;
    case Property::mix_blend_mode:
      return kBlendNames;
    case Property::overflow:
      return kOverflows;
    case Property::visibility:
      return kVisibilities;
    default:
      return {};
  }
}

/// How many words a value may have.
std::size_t most_words(Property property) {
  if (property == Property::display) return 3;
  return property == Property::overflow ? 2 : 1;
}

bool is_color(std::string_view value, TextPoll& poll) {
  return keyword_of(value, poll) == "currentcolor" || parse_color(value, poll).ok();
}

/// `none`, a colour, or an url with what to paint where it leads nowhere.
bool is_paint(std::string_view value, TextPoll& poll) {
  Tokenizer tokens(value, poll);
  const Token first = next_solid(tokens);
  if (take_url(tokens, first)) {
    value.remove_prefix(tokens.position());
    Tokenizer rest(value, poll);
    return next_solid(rest).is(TokenType::end) || is_paint(value, poll);
  }
  const auto word = keyword_of(value, poll);
  return word == "none" || word == "context-fill" || word == "context-stroke" ||
         is_color(value, poll);
}

}  // namespace

const char* property_name(Property property) {
  return kNames[static_cast<std::size_t>(property)];
}

std::optional<Property> property_of(std::string_view raw_name) {
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (is_named(raw_name, kNames[i])) return static_cast<Property>(i);
  }
  return std::nullopt;
}

bool is_inherited(Property property) {
  return property == Property::color || property == Property::fill ||
         property == Property::fill_opacity || property == Property::fill_rule ||
         property == Property::paint_order || property == Property::visibility ||
         (property >= Property::stroke && property <= Property::stroke_width);
}

WideKeyword wide_keyword(std::string_view value, TextPoll& poll) {
  // Most values are told from these words by their first letter.
  const auto token = only_token(value, poll);
  if (!token || !token->is(TokenType::ident)) return WideKeyword::none;
  for (std::size_t i = 0; i < kWideKeywords.size(); ++i) {
    if (is_named(token->value, kWideKeywords[i])) return static_cast<WideKeyword>(i + 1);
  }
  return WideKeyword::none;
}

bool is_value(Property property, std::string_view value, TextPoll& poll) {
  if (wide_keyword(value, poll) != WideKeyword::none) return true;
  switch (property) {
    case Property::opacity:
    case Property::fill_opacity:
    case Property::stop_opacity:
    case Property::stroke_opacity:
      return share_of(value, poll).has_value();
    case Property::color:
    case Property::stop_color:
      return is_color(value, poll);
    case Property::fill:
    case Property::stroke:
      return is_paint(value, poll);
    case Property::display:
    case Property::isolation:
    case Property::mix_blend_mode:
    case Property::overflow:
    case Property::visibility:
      return is_words(value, words_of(property), most_words(property), poll);
    case Property::paint_order:
      return paint_order_of(value, poll).has_value();
    case Property::fill_rule:
    case Property::stroke_dasharray:
    case Property::stroke_dashoffset:
    case Property::stroke_linecap:
    case Property::stroke_linejoin:
    case Property::stroke_miterlimit:
    case Property::stroke_width:
      break;  // who reads them tells what is wrong
    case Property::clip_path:
    case Property::filter:
    case Property::mask:
    case Property::transform:
    case Property::transform_box:
    case Property::transform_origin:
      break;  // they are not read: that there is a value is all
  }
  Tokenizer tokens(value, poll);
  return !next_solid(tokens).is(TokenType::end);
}

std::string value_hint(Property property, std::string_view value, TextPoll& poll) {
  const auto word = keyword_of(value, poll);
  if (!word) return {};
  const Words words = words_of(property);
  if (!words.empty()) return text::did_you_mean(*word, words);
  const bool is_paint =
      property == Property::fill || property == Property::color || property == Property::stop_color;
  return is_paint ? did_you_mean_color(*word) : std::string();
}

}  // namespace sfumato::css
