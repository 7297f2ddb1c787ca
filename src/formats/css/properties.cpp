#include "formats/css/properties.hpp"

#include <algorithm>
#include <span>

#include "document/names.hpp"
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

/// In the order of WideKeyword, from `inherit`.
constexpr std::array<std::string_view, 5> kWideKeywords{"inherit", "initial", "unset", "revert",
                                                        "revert-layer"};

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

constexpr const PropertyRow& row_of(Property property) {
  return kProperties[static_cast<std::size_t>(property)];
}

static_assert(std::ranges::equal(row_of(Property::mix_blend_mode).words, kBlendNames),
              "properties.json has the blend modes of the document");

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

constexpr LengthRule kCoordinate{true, true};
constexpr LengthRule kSize{};
constexpr LengthRule kDashOffset{false, true};
constexpr LengthRule kStrokeWidth{false, false};

bool is_length(const Token& token, const LengthRule& rule, ValueSyntax syntax) {
  const auto length = length_of(token);
  if (!length || (length->value < 0 && !rule.may_be_negative)) return false;
  return length->unit != Unit::number || length->value == 0 || !rule.needs_unit ||
         syntax == ValueSyntax::attribute;
}

/// `none`, or lengths with commas or white space between them.
bool is_dash_list(std::string_view value, ValueSyntax syntax, TextPoll& poll) {
  Tokenizer tokens(value, poll);
  Token token = next_solid(tokens);
  if (token.is(TokenType::ident)) {
    return is_named(token.value, "none") && next_solid(tokens).is(TokenType::end);
  }
  while (is_length(token, kStrokeWidth, syntax)) {
    token = next_solid(tokens);
    if (token.is(TokenType::end)) return true;
    if (token.is(TokenType::comma)) token = next_solid(tokens);
  }
  return false;
}

bool is_length_value(const LengthRule& rule, std::string_view value, ValueSyntax syntax,
                     TextPoll& poll) {
  const auto token = only_token(value, poll);
  return token && is_length(*token, rule, syntax);
}

}  // namespace

const char* property_name(Property property) {
  return row_of(property).name;
}

std::optional<Property> property_of(std::string_view raw_name) {
  const bool has_escapes = raw_name.find('\\') != std::string_view::npos;
  for (std::size_t i = 0; i < kPropertyCount; ++i) {
    const std::string_view name = kProperties[i].name;
    if (!has_escapes && raw_name.size() != name.size()) continue;
    if (is_named(raw_name, name)) return static_cast<Property>(i);
  }
  return std::nullopt;
}

bool is_inherited(Property property) {
  return row_of(property).is_inherited;
}

AttributeUse attribute_use(Property property) {
  return row_of(property).attribute;
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
  if (property == Property::custom) return true;
  const PropertyRow& row = row_of(property);
  const bool is_attribute = syntax == ValueSyntax::attribute;
  switch (row.value) {
    case ValueKind::share:
      return share_of(value, poll).has_value();
    case ValueKind::color:
      return is_color(value, poll);
    case ValueKind::paint:
      return is_paint(value, poll);
    case ValueKind::marker:
      return keyword_of(value, poll) == "none" || url_of(value, poll).has_value();
    case ValueKind::paint_order:
      return paint_order_of(value, poll).has_value();
    case ValueKind::path_data:
      return is_attribute || path_data_of(value, poll).has_value();
    case ValueKind::font_size:
      return font_size_of(value, {}, !is_attribute, poll).has_value();
    case ValueKind::coordinate:
      return is_length_value(kCoordinate, value, syntax, poll);
    case ValueKind::size:
      return is_length_value(kSize, value, syntax, poll);
    case ValueKind::auto_size:
      return is_length_value(kSize, value, syntax, poll) || is_words(value, kAutoSizes, 1, poll);
    case ValueKind::dash_offset:
      return is_length_value(kDashOffset, value, syntax, poll);
    case ValueKind::stroke_width:
      return is_length_value(kStrokeWidth, value, syntax, poll);
    case ValueKind::dashes:
      return is_dash_list(value, syntax, poll);
    case ValueKind::transform_list:
      return is_attribute || read_transform_list(value, poll, [](const TransformFunction&) {});
    case ValueKind::transform_step:
      return !is_attribute && transform_step_of(property, value, poll).has_value();
    case ValueKind::transform_origin:
      return transform_origin_of(value, !is_attribute, poll).has_value();
    case ValueKind::clip_path:
      return is_clip_path(value, !is_attribute, poll);
    case ValueKind::words:
      return is_words(value, row.words, row.most_words, poll);
    case ValueKind::any:
      break;
  }
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
  const PropertyRow& row = row_of(property);
  const bool is_paint = row.value == ValueKind::color || row.value == ValueKind::paint;
  const auto word = keyword_of(value, poll);
  if (!word && is_paint) return "; " + parse_color(value, poll).status().message;
  if (!word) return {};
  const Words words = row.value == ValueKind::auto_size ? Words(kAutoSizes) : row.words;
  if (!words.empty()) return text::did_you_mean(*word, words);
  return is_paint ? did_you_mean_color(*word) : std::string();
}

}  // namespace sfumato::css
