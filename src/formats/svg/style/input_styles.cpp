// Styles of elements: the part of Input that knows CSS.
#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <utility>

#include "base/limit_error.hpp"
#include "base/table_memory.hpp"
#include "base/text/ascii.hpp"
#include "base/try.hpp"
#include "formats/css/media.hpp"
#include "formats/css/value.hpp"
#include "formats/css/variables.hpp"
#include "formats/svg/read/input.hpp"
#include "formats/svg/style/selector_match.hpp"
#include "formats/text/suggestion.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato::svg {
namespace {

/// Steps that a setting of a matching rule costs, which is kept.
constexpr std::size_t kSettingSteps = 2;

bool is_text(pugi::xml_node node) {
  return node.type() == pugi::node_pcdata || node.type() == pugi::node_cdata;
}

}  // namespace

/// Records the known properties of style="".
Status Input::read_style(Element element) {
  const auto text = attribute(element, "style");
  if (!text) return ok_status();
  css::Style style;
  css::Tokenizer tokens(*text, text_poll_);
  css::read_declarations(tokens, false, [&](const css::Declaration& declaration) {
    style.add(declaration, text_poll_);
  });
  SFUMATO_TRY(text_poll_.status());
  warn_of_dropped(element, style.dropped());
  for (std::size_t i = 0; i < css::kPropertyCount; ++i) {
    const auto property = static_cast<css::Property>(i);
    if (!style[property]) continue;
    SFUMATO_TRY(push_back(element, style_memory_, styles_,
                          {element.internal_object(), {property}, *style[property]}));
  }
  for (const auto& [name, setting] : style.variables()) {
    has_variables_ = true;
    SFUMATO_TRY(push_back(element, style_memory_, styles_,
                          {element.internal_object(), {css::Property::custom, name}, setting}));
  }
  return ok_status();
}

bool Input::is_before(const Styled& a, const Styled& b) {
  if (a.element != b.element) return std::less<>()(a.element, b.element);
  return a.property < b.property;
}

Status Input::sort_styles() {
  return TableMemory::sort(context_, styles_, is_before);
}

void Input::warn_of_dropped(Element element, const std::optional<css::Declaration>& dropped) {
  if (!dropped) return;
  const auto property = css::property_of(dropped->name);
  const std::string name =
      property ? css::property_name(*property) : std::string(dropped->name.substr(0, 64));
  const std::string hint =
      property ? css::value_hint(*property, dropped->value, text_poll_) : std::string();
  warn("/declaration " + (property ? name : "--"), element,
       text::quoted(name + ": " + std::string(dropped->value.substr(0, 64))) +
           " is left out: its value is not understood" + hint);
}

/// Returns whether a <style> is a sheet of CSS for a screen.
bool Input::applies(Element style) {
  const std::string_view type = style.attribute("type").value();
  if (!type.empty() && ascii_lower(type.substr(0, 64)) != "text/css") {
    warn("/style type", style,
         "the <style> is of type " + text::quoted(type) + " and is left out; use text/css");
    return false;
  }
  const std::string_view media = style.attribute("media").value();
  const css::Media fits = css::media_of(media, text_poll_);
  if (fits == css::Media::unknown) {
    warn("/style media", style,
         "the <style> for " + text::quoted(media) +
             " is left out: it asks for more than a kind of media; use screen or all");
  }
  return fits == css::Media::matches;
}

Status Input::read_style_sheet(Element element) {
  if (!applies(element)) return text_poll_.status();
  std::string_view sheet;
  for (const pugi::xml_node child : element.children()) {
    if (!is_text(child)) continue;
    const std::string_view piece = child.value();
    if (sheet.empty()) {
      sheet = piece;
      continue;
    }
    const bool is_second = sheet_texts_.empty() || sheet_texts_.back().data() != sheet.data();
    Status status;
    if (is_second) status = sheet_memory_.append(context_, sheet, sheet_texts_.emplace_back());
    if (status) status = sheet_memory_.append(context_, piece, sheet_texts_.back());
    if (!status) return placed(element, std::move(status));
    sheet = sheet_texts_.back();
  }
  const css::StyleSheet::Notes notes = sheet_.add(sheet, limits().style_values, text_poll_);
  SFUMATO_TRY(text_poll_.status());
  if (sheet_.value_count() > limits().style_values) {
    return over_limit(element, &Limits::style_values, "values in style sheets");
  }
  warn_of_dropped(element, notes.dropped);
  if (notes.left_out.empty()) return ok_status();
  warn("/style sheet", element,
       "the style rule " + text::quoted(notes.left_out) +
           " is not read; use selectors of names, classes, ids and attributes");
  return ok_status();
}

/// Finds the settings of rules with selectors of several parts, for every element.
Status Input::match_rules() {
  has_variables_ |= sheet_.sets(css::Property::custom);
  if (sheet_.complex_rules().empty()) return ok_status();
  SelectorMatcher matcher(sheet_, limits().selector_steps);
  SFUMATO_TRY(match_rules_of(root(), matcher));
  return TableMemory::sort(context_, matched_, [](const Matched& a, const Matched& b) {
    if (a.element != b.element) return std::less<>()(a.element, b.element);
    return a.setting < b.setting;
  });
}

css::RankedSetting Input::ranked(const Matched& matched) const {
  const css::StyleSheet::ComplexRule& rule = sheet_.complex_rules()[matched.rule];
  return {sheet_.setting(matched.setting).setting, rule.specificity, rule.order};
}

/// Handles the element and its content. Ends without an error when the steps are used up.
Status Input::match_rules_of(Element element, SelectorMatcher& matcher) {
  SFUMATO_TRY(check());
  std::map<css::PropertyName, Matched> winners;
  for (const std::uint32_t number : matcher.match(element)) {
    const css::StyleSheet::ComplexRule& rule = sheet_.complex_rules()[number];
    if (!matcher.take(kSettingSteps * rule.setting_count)) break;
    for (std::uint32_t i = 0; i < rule.setting_count; ++i) {
      const Matched setting{element.internal_object(), number, rule.first_setting + i};
      const auto [winner, is_new] =
          winners.try_emplace(sheet_.setting(setting.setting).name, setting);
      if (!is_new && ranked(setting).outranks(ranked(winner->second))) winner->second = setting;
    }
  }
  if (matcher.is_over()) {
    warn("/selector-steps", element,
         "from here on rules with combinators do not apply: more than the limit of " +
             limit_text(limits(), &Limits::selector_steps,
                        "steps of selectors; raise the limit selector-steps"));
    return ok_status();
  }
  for (const auto& [name, winner] : winners) {
    SFUMATO_TRY(push_back(element, match_memory_, matched_, winner));
  }
  for (const Element child : element.children()) {
    if (child.type() != pugi::node_element) continue;
    SFUMATO_TRY(match_rules_of(child, matcher));
    if (matcher.is_over()) break;
  }
  return ok_status();
}

std::optional<css::Setting> Input::styled(Element element, const css::PropertyName& property) {
  if (styles_.empty()) return std::nullopt;
  const void* asked = element.internal_object();
  if (last_styled_.element != asked) {
    // An element is asked for many properties, one after another.
    const auto settings = std::ranges::equal_range(styles_, asked, std::less<>(), &Styled::element);
    last_styled_ = {asked, settings};
  }
  for (const Styled& styled : last_styled_.settings) {
    if (styled.property == property) return styled.setting;
  }
  return std::nullopt;
}

std::optional<css::RankedSetting> Input::matched(Element element,
                                                 const css::PropertyName& property) {
  if (matched_.empty()) return std::nullopt;
  const void* asked = element.internal_object();
  if (last_matched_.element != asked) {
    last_matched_ = {asked,
                     std::ranges::equal_range(matched_, asked, std::less<>(), &Matched::element)};
  }
  for (const Matched& setting : last_matched_.settings) {
    if (sheet_.setting(setting.setting).name == property) return ranked(setting);
  }
  return std::nullopt;
}

std::optional<css::Setting> Input::in_sheet(Element element, const css::PropertyName& property) {
  if (!sheet_.sets(property.property)) return std::nullopt;
  auto best = sheet_.find(element.name(), element.attribute("id").value(),
                          element.attribute("class").value(), property);
  const auto other = matched(element, property);
  if (other && (!best || other->outranks(*best))) best = other;
  return best ? std::optional(best->setting) : std::nullopt;
}

css::WideKeyword Input::wide_keyword(std::string_view value) {
  // The beginning distinguishes most values from these words.
  constexpr std::string_view kBeginnings = "iIuUrR\\/";
  if (value.empty() || kBeginnings.find(value.front()) == std::string_view::npos) {
    return css::WideKeyword::none;
  }
  return css::wide_keyword(value, text_poll_);
}

std::array<std::uint64_t, css::kPropertyCount> Input::property_bits() {
  std::array<std::uint64_t, css::kPropertyCount> bits{};
  for (std::size_t i = 0; i < bits.size(); ++i) {
    bits[i] = name_bit(css::property_name(static_cast<css::Property>(i)));
  }
  return bits;
}

/// Returns whether an attribute of the element has a name like that of a property: the same
/// beginning and length. Most elements have few attributes and are asked for many properties.
bool Input::may_be_written(Element element, css::Property property) {
  const void* asked = element.internal_object();
  if (last_names_.element != asked) {
    last_names_ = {asked, 0};
    for (auto each = element.first_attribute(); each; each = each.next_attribute()) {
      last_names_.bits |= name_bit(each.name());
    }
  }
  return (last_names_.bits & property_bit_[static_cast<std::size_t>(property)]) != 0;
}

/// Returns the presentation attribute of a property.
std::optional<std::string_view> Input::written(Element element, css::Property property) {
  const css::AttributeUse use = css::attribute_use(property);
  if (use == css::AttributeUse::none || !may_be_written(element, property)) return std::nullopt;
  const auto text = attribute(element, css::property_name(property));
  if (!text || (use == css::AttributeUse::own && forgives(element))) return std::nullopt;
  const std::string_view value = ascii_trimmed(*text);
  const bool is_checked = use == css::AttributeUse::checked ||
                          (use == css::AttributeUse::forgiven && forgives(element));
  if (!is_checked || css::is_value(property, value, text_poll_, css::ValueSyntax::attribute)) {
    return value;
  }
  const std::string name = css::property_name(property);
  warn("/attribute " + name, element,
       name + " of " + tag(element) + " is " + text::quoted(value) +
           "; its value is not understood, and it is ignored" +
           css::value_hint(property, value, text_poll_));
  return std::nullopt;
}

Input::Cascaded Input::declared(Element element, const css::PropertyName& property) {
  std::array<std::optional<std::string_view>, 3> candidates;
  const std::optional<css::Setting> own = styled(element, property);
  const std::optional<css::Setting> sheet = in_sheet(element, property);
  if (own) candidates[0] = own->value;
  if (sheet) candidates[1] = sheet->value;
  if (sheet && sheet->is_important && !(own && own->is_important)) {
    std::swap(candidates[0], candidates[1]);
  }
  if (property.property != css::Property::custom) {
    candidates[2] = written(element, property.property);
  }
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const auto& candidate = candidates[i];
    if (!candidate) continue;
    const css::WideKeyword keyword = wide_keyword(*candidate);
    if (keyword == css::WideKeyword::none) return {keyword, candidate, i == 2};
    if (keyword != css::WideKeyword::revert_layer) return {keyword, std::nullopt};
  }
  return {};
}

Input::Cascaded Input::declared_variable(Element element, std::string_view name) {
  return declared(element, {css::Property::custom, name});
}

Input::Cascaded Input::cascaded(const StyleScope& scope, css::Property property) {
  const Cascaded own = with_variables(scope, property);
  const bool is_color = property == css::Property::color && own.value;
  // As a value of `color` itself, `currentColor` is the colour around the element.
  if (!is_color || css::keyword_of(*own.value, text_poll_) != "currentcolor") return own;
  return {css::WideKeyword::inherit, std::nullopt};
}

Input::Cascaded Input::with_variables(const StyleScope& scope, css::Property property) {
  Cascaded own = declared(scope.element(), {property});
  if (!own.value) return own;
  const css::Variables variables = css::variables_in(*own.value, text_poll_);
  if (variables == css::Variables::none) return own;
  // Where no value comes out, the property is as if it were not declared, and nothing below counts.
  const Cascaded unset{css::WideKeyword::unset, std::nullopt};
  if (variables == css::Variables::invalid) return unset;
  own.value = substituted(scope, *own.value);
  const auto syntax =
      own.is_attribute ? css::ValueSyntax::attribute : css::ValueSyntax::declaration;
  if (!own.value || !css::is_value(property, *own.value, text_poll_, syntax)) return unset;
  const css::WideKeyword keyword = wide_keyword(*own.value);
  if (keyword == css::WideKeyword::none) return own;
  return {keyword == css::WideKeyword::revert_layer ? css::WideKeyword::unset : keyword,
          std::nullopt};
}

std::optional<std::string_view> Input::property(Element element, css::Property property) {
  Inherited& known = inherited_[static_cast<std::size_t>(property)];
  const void* asked = nullptr;  // the parent whose value is taken
  std::optional<std::string_view> value;
  for (; element && element.type() == pugi::node_element; element = element.parent()) {
    if (asked && element.internal_object() == known.parent) {
      value = known.value;
      break;
    }
    const Cascaded own = cascaded(element, property);
    value = own.value;
    const bool goes_up = own.keyword == css::WideKeyword::inherit ||
                         (own.keyword != css::WideKeyword::initial && is_inherited(property));
    if (value || !goes_up) break;
    if (!asked) asked = element.parent().internal_object();
  }
  if (asked) known = {asked, value};
  return value;
}

std::string Input::keyword(Element element, css::Property property) {
  const auto value = this->property(element, property);
  return value ? css::keyword_of(*value, text_poll_).value_or("") : std::string();
}

}  // namespace sfumato::svg
