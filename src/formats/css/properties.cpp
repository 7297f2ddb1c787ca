#include "formats/css/properties.hpp"

#include <algorithm>
#include <span>

#include "document/blend_names.hpp"
#include "formats/css/basic_shape.hpp"
#include "formats/css/color.hpp"
#include "formats/css/length.hpp"
#include "formats/css/transform_list.hpp"
#include "formats/css/value.hpp"
#include "formats/css/variables.hpp"
#include "formats/text/suggestion.hpp"

namespace sfumato::css {
namespace {

using Words = std::span<const std::string_view>;

/// In the order of Property, which is that of the names.
constexpr std::array<std::string_view, kPropertyCount> kNames{"background-color",
                                                              "clip-path",
                                                              "clip-rule",
                                                              "color",
                                                              "color-interpolation",
                                                              "cx",
                                                              "cy",
                                                              "d",
                                                              "display",
                                                              "fill",
                                                              "fill-opacity",
                                                              "fill-rule",
                                                              "filter",
                                                              "flood-color",
                                                              "flood-opacity",
                                                              "font-size",
                                                              "height",
                                                              "image-rendering",
                                                              "isolation",
                                                              "marker-end",
                                                              "marker-mid",
                                                              "marker-start",
                                                              "mask",
                                                              "mask-type",
                                                              "mix-blend-mode",
                                                              "opacity",
                                                              "overflow",
                                                              "paint-order",
                                                              "r",
                                                              "rotate",
                                                              "rx",
                                                              "ry",
                                                              "scale",
                                                              "shape-rendering",
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
                                                              "translate",
                                                              "vector-effect",
                                                              "visibility",
                                                              "width",
                                                              "x",
                                                              "y"};

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
constexpr std::array<std::string_view, 3> kColorInterpolations{"auto", "srgb", "linearrgb"};
constexpr std::array<std::string_view, 2> kIsolations{"auto", "isolate"};
constexpr std::array<std::string_view, 2> kMaskTypes{"alpha", "luminance"};
constexpr std::array<std::string_view, 5> kOverflows{"visible", "hidden", "clip", "scroll", "auto"};
constexpr std::array<std::string_view, 5> kTransformBoxes{"content-box", "border-box", "fill-box",
                                                          "stroke-box", "view-box"};
constexpr std::array<std::string_view, 5> kVectorEffects{
    "none", "non-scaling-stroke", "non-scaling-size", "non-rotation", "fixed-position"};
constexpr std::array<std::string_view, 3> kVisibilities{"visible", "hidden", "collapse"};
/// Sizes that SVG takes for `auto`.
constexpr std::array<std::string_view, 6> kAutoSizes{
    "auto", "min-content", "max-content", "fit-content", "stretch", "-webkit-fill-available"};

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

/// Returns the words that the value of a property is made of; none where it is something else.
Words words_of(Property property) {
  switch (property) {
    case Property::color_interpolation:
      return kColorInterpolations;
    case Property::display:
      return kDisplays;
    case Property::isolation:
      return kIsolations;
    case Property::mask_type:
      return kMaskTypes;
    case Property::mix_blend_mode:
      return kBlendNames;
    case Property::overflow:
      return kOverflows;
    case Property::transform_box:
      return kTransformBoxes;
    case Property::vector_effect:
      return kVectorEffects;
    case Property::visibility:
      return kVisibilities;
    case Property::height:
    case Property::rx:
    case Property::ry:
    case Property::width:
      return kAutoSizes;
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

/// `none`, a colour, or an url with a fallback paint.
bool is_paint(std::string_view value, TextPoll& poll) {
  for (;;) {
    Tokenizer tokens(value, poll);
    if (!take_url(tokens, next_solid(tokens))) break;
    value.remove_prefix(tokens.position());
    if (next_solid(tokens).is(TokenType::end)) return true;
  }
  const auto word = keyword_of(value, poll);
  return word == "none" || word == "context-fill" || word == "context-stroke" ||
         is_color(value, poll);
}

/// How a property takes lengths.
struct LengthRule {
  bool needs_unit = true;  ///< in a declaration: a number other than 0 is not a length
  bool may_be_negative = false;
};

std::optional<LengthRule> length_rule(Property property) {
  switch (property) {
    case Property::cx:
    case Property::cy:
    case Property::x:
    case Property::y:
      return LengthRule{true, true};
    case Property::height:
    case Property::r:
    case Property::rx:
    case Property::ry:
    case Property::width:
      return LengthRule{};
    case Property::stroke_dashoffset:
      return LengthRule{false, true};
    case Property::stroke_dasharray:
    case Property::stroke_width:
      return LengthRule{false, false};
    default:
      return std::nullopt;
  }
}

bool is_length(const Token& token, const LengthRule& rule, ValueSyntax syntax) {
  const auto length = length_of(token);
  if (!length || (length->value < 0 && !rule.may_be_negative)) return false;
  return length->unit != Unit::number || length->value == 0 || !rule.needs_unit ||
         syntax == ValueSyntax::attribute;
}

/// `none`, or lengths with commas or white space between them.
bool is_dash_list(std::string_view value, ValueSyntax syntax, TextPoll& poll) {
  const LengthRule rule = *length_rule(Property::stroke_dasharray);
  Tokenizer tokens(value, poll);
  Token token = next_solid(tokens);
  if (token.is(TokenType::ident)) {
    return is_named(token.value, "none") && next_solid(tokens).is(TokenType::end);
  }
  while (is_length(token, rule, syntax)) {
    token = next_solid(tokens);
    if (token.is(TokenType::end)) return true;
    if (token.is(TokenType::comma)) token = next_solid(tokens);
  }
  return false;
}

bool is_length_value(Property property, const LengthRule& rule, std::string_view value,
                     ValueSyntax syntax, TextPoll& poll) {
  const auto token = only_token(value, poll);
  if (token && is_length(*token, rule, syntax)) return true;
  const Words words = words_of(property);
  return !words.empty() && is_words(value, words, 1, poll);
}

}  // namespace

const char* property_name(Property property) {
  return kNames[static_cast<std::size_t>(property)].data();
}

std::optional<Property> property_of(std::string_view raw_name) {
  const bool has_escapes = raw_name.find('\\') != std::string_view::npos;
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (!has_escapes && raw_name.size() != kNames[i].size()) continue;
    if (is_named(raw_name, kNames[i])) return static_cast<Property>(i);
  }
  return std::nullopt;
}

bool is_inherited(Property property) {
  return property == Property::clip_rule || property == Property::color ||
         property == Property::color_interpolation || property == Property::fill ||
         property == Property::fill_opacity || property == Property::fill_rule ||
         property == Property::font_size || property == Property::image_rendering ||
         property == Property::paint_order || property == Property::shape_rendering ||
         property == Property::visibility ||
         (property >= Property::marker_end && property <= Property::marker_start) ||
         (property >= Property::stroke && property <= Property::stroke_width);
}

WideKeyword wide_keyword(std::string_view value, TextPoll& poll) {
  // The first letter distinguishes most values from these words.
  const auto token = only_token(value, poll);
  if (!token || !token->is(TokenType::ident)) return WideKeyword::none;
  for (std::size_t i = 0; i < kWideKeywords.size(); ++i) {
    if (is_named(token->value, kWideKeywords[i])) return static_cast<WideKeyword>(i + 1);
  }
  return WideKeyword::none;
}

bool is_value(Property property, std::string_view value, TextPoll& poll, ValueSyntax syntax) {
  if (wide_keyword(value, poll) != WideKeyword::none) return true;
  const Variables variables = variables_in(value, poll);
  if (variables != Variables::none) return variables == Variables::valid;
  const bool is_attribute = syntax == ValueSyntax::attribute;
  switch (property) {
    case Property::opacity:
    case Property::fill_opacity:
    case Property::flood_opacity:
    case Property::stop_opacity:
    case Property::stroke_opacity:
      return share_of(value, poll).has_value();
    case Property::background_color:
    case Property::color:
    case Property::flood_color:
    case Property::stop_color:
      return is_color(value, poll);
    case Property::fill:
    case Property::stroke:
      return is_paint(value, poll);
    case Property::marker_end:
    case Property::marker_mid:
    case Property::marker_start:
      return keyword_of(value, poll) == "none" || url_of(value, poll).has_value();
    case Property::paint_order:
      return paint_order_of(value, poll).has_value();
    case Property::d:
      return is_attribute || path_data_of(value, poll).has_value();
    case Property::font_size:
      return font_size_of(value, {}, !is_attribute, poll).has_value();
    case Property::stroke_dasharray:
      return is_dash_list(value, syntax, poll);
    case Property::transform:
      return is_attribute || read_transform_list(value, poll, [](const TransformFunction&) {});
    case Property::rotate:
    case Property::scale:
    case Property::translate:
      return !is_attribute && transform_step_of(property, value, poll).has_value();
    case Property::transform_origin:
      return transform_origin_of(value, !is_attribute, poll).has_value();
    case Property::clip_path:
      return is_clip_path(value, !is_attribute, poll);
    case Property::custom:
      return true;
    default:
      break;
  }
  if (const auto rule = length_rule(property)) {
    return is_length_value(property, *rule, value, syntax, poll);
  }
  const Words words = words_of(property);
  if (!words.empty()) return is_words(value, words, most_words(property), poll);
  // The readers of other properties report errors; here any value counts.
  Tokenizer tokens(value, poll);
  return !next_solid(tokens).is(TokenType::end);
}

bool is_auto_size(std::string_view value, TextPoll& poll) {
  // The first letter distinguishes lengths from these words.
  if (value.empty() || (value.front() >= '0' && value.front() <= '9')) return false;
  return is_words(value, kAutoSizes, 1, poll);
}

std::optional<std::string_view> path_data_of(std::string_view value, TextPoll& poll) {
  Tokenizer tokens(value, poll);
  Token token = next_solid(tokens);
  if (token.is(TokenType::ident) && is_named(token.value, "none")) {
    return next_solid(tokens).is(TokenType::end) ? std::optional<std::string_view>("")
                                                 : std::nullopt;
  }
  if (!token.is(TokenType::function) || !is_named(token.value, "path")) return std::nullopt;
  const Token data = next_solid(tokens);
  token = next_solid(tokens);
  const bool is_closed = token.is(TokenType::end) || (token.is(TokenType::close_paren) &&
                                                      next_solid(tokens).is(TokenType::end));
  const bool is_plain = data.value.find('\\') == std::string_view::npos;
  if (!data.is(TokenType::string) || !is_closed || !is_plain) return std::nullopt;
  return data.value;
}

std::string value_hint(Property property, std::string_view value, TextPoll& poll) {
  const bool is_paint = property == Property::background_color || property == Property::fill ||
                        property == Property::stroke || property == Property::color ||
                        property == Property::flood_color || property == Property::stop_color;
  const auto word = keyword_of(value, poll);
  if (!word && is_paint) return "; " + parse_color(value, poll).status().message;
  if (!word) return {};
  const Words words = words_of(property);
  if (!words.empty()) return text::did_you_mean(*word, words);
  return is_paint ? did_you_mean_color(*word) : std::string();
}

}  // namespace sfumato::css
