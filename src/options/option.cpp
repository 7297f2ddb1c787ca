#include "options/option.hpp"

#include <algorithm>

#include "base/text/ascii.hpp"
#include "formats/css/color.hpp"
#include "formats/text/suggestion.hpp"
#include "options/values.hpp"

namespace sfumato::options {
namespace {

std::string word_list(const OptionInfo& option) {
  std::string list;
  for (const std::string_view word : option.words)
    list.append(list.empty() ? "" : "|").append(word);
  return list;
}

bool is_within(const NumberRange& range, double number) {
  const bool is_high_enough = range.is_above ? number > range.lowest : number >= range.lowest;
  return is_high_enough && number <= range.highest;
}

/// Reads a colour as in drawings; `none` and `transparent` mean no colour.
bool read_color(std::string_view text, Value& value) {
  const Result<css::Color> color = css::parse_color(text);
  if (text == "none" || (color && color->alpha == 0)) return true;
  if (!color || color->alpha < 1) return false;
  value.color = color->color;
  return true;
}

bool read_number(const OptionInfo& option, std::string_view text, Value& value) {
  if (option.instead && text == option.instead) return true;
  value.number = option.kind == ValueKind::fraction ? parse_fraction(text) : parse_number(text);
  return value.number &&
         (option.kind == ValueKind::fraction || is_within(option.numbers, *value.number));
}

bool read_whole(const OptionInfo& option, std::string_view text, Value& value) {
  const auto whole = parse_whole(text, option.wholes.lowest, option.wholes.highest);
  value.whole = whole.value_or(0);
  return whole.has_value();
}

bool read_word(const OptionInfo& option, std::string_view text, Value& value) {
  const auto word = option.ignores_case ? std::ranges::find(option.words, ascii_lower(text))
                                        : std::ranges::find(option.words, text);
  value.word = static_cast<std::size_t>(word - option.words.begin());
  return word != option.words.end();
}

bool read_box(std::string_view text, Value& value) {
  const std::optional<Box> box = parse_viewport(text);
  value.box = box.value_or(Box{});
  return box.has_value();
}

bool read_pixels(std::string_view text, Value& value) {
  const std::optional<PixelRect> pixels = parse_window(text);
  value.pixels = pixels.value_or(PixelRect{});
  return pixels.has_value();
}

bool read_value(const OptionInfo& option, std::string_view text, Value& value) {
  switch (option.kind) {
    case ValueKind::flag:
      return text.empty();
    case ValueKind::number:
    case ValueKind::fraction:
      return read_number(option, text, value);
    case ValueKind::whole:
      return read_whole(option, text, value);
    case ValueKind::word:
      return read_word(option, text, value);
    case ValueKind::box:
      return read_box(text, value);
    case ValueKind::pixels:
      return read_pixels(text, value);
    case ValueKind::color:
      return read_color(text, value);
    case ValueKind::text:
      break;
  }
  return true;
}

}  // namespace

std::string spelled(std::string_view text, bool for_command) {
  std::string result;
  bool is_in_name = false;
  for (const char c : text) {
    if (c == '@') {
      is_in_name = true;
      if (for_command) result += "--";
      continue;
    }
    const bool ends_key = is_in_name && c == '=';
    is_in_name = is_in_name && (c == '-' || (c >= 'a' && c <= 'z'));
    result += ends_key && for_command ? ' ' : c;
  }
  return result;
}

std::optional<Value> parse_value(const OptionInfo& option, std::string_view text) {
  Value value;
  value.text = text;
  if (!read_value(option, text, value)) return std::nullopt;
  return value;
}

std::string expected_value(const OptionInfo& option) {
  if (option.expected) return option.expected;
  if (option.kind == ValueKind::word) return "one of " + word_list(option);
  if (option.kind != ValueKind::whole) return {};
  return "a whole number from " + std::to_string(option.wholes.lowest) + " to " +
         std::to_string(option.wholes.highest);
}

std::string complaint_about_value(const OptionInfo& option, std::string_view text) {
  std::string complaint = "invalid value \"" + std::string(text) + "\"; use " +
                          expected_value(option) + text::did_you_mean(text, option.words);
  if (option.kind != ValueKind::color) return complaint;
  const Result<css::Color> color = css::parse_color(text);
  return color ? complaint : complaint + "; " + color.status().message;
}

std::string value_name(const OptionInfo& option) {
  return option.value_name ? option.value_name : word_list(option);
}

}  // namespace sfumato::options
