// Styles of elements: the part of Input that knows CSS.
#include <algorithm>
#include <functional>
#include <utility>

#include "base/ascii.hpp"
#include "base/table_memory.hpp"
#include "formats/css/media.hpp"
#include "formats/css/value.hpp"
#include "formats/svg/input.hpp"
#include "formats/text/suggestion.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato::svg {
namespace {

bool is_text(pugi::xml_node node) {
  return node.type() == pugi::node_pcdata || node.type() == pugi::node_cdata;
}

}  // namespace

/// Notes what style="" says of properties that are known.
Status Input::read_style(Element element) {
  const auto text = attribute(element, "style");
  if (!text) return ok_status();
  css::Style style;
  css::Tokenizer tokens(*text, text_poll_);
  css::read_declarations(tokens, false, [&](const css::Declaration& declaration) {
    style.add(declaration, text_poll_);
  });
  if (Status status = text_poll_.status(); !status) return status;
  warn_of_dropped(element, style.dropped());
  for (std::size_t i = 0; i < css::kPropertyCount; ++i) {
    const auto property = static_cast<css::Property>(i);
    if (!style[property]) continue;
    Status status = push_back(element, style_memory_, styles_,
                              {element.internal_object(), property, *style[property]});
    if (!status) return status;
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
  const auto property = dropped ? css::property_of(dropped->name) : std::nullopt;
  if (!property) return;
  const std::string name = css::property_name(*property);
  warn("/declaration " + name, element,
       text::quoted(name + ": " + std::string(dropped->value.substr(0, 64))) +
           " is left out: its value is not understood" +
           css::value_hint(*property, dropped->value, text_poll_));
}

/// Whether a <style> is a sheet of CSS for a screen.
bool Input::applies(Element style) {
  const std::string_view type = style.attribute("type").value();
  if (!type.empty() && ascii_lower(type.substr(0, 64)) != "text/css") {
    warn("/style type", style,
         "the <style> is of type " + text::quoted(type) + " and is left out; expected text/css");
    return false;
  }
  const std::string_view media = style.attribute("media").value();
  const css::Media fits = css::media_of(media, text_poll_);
  if (fits == css::Media::unknown) {
    warn("/style media", style,
         "the <style> for " + text::quoted(media) +
             " is left out: it asks for more than a kind of media; expected screen or all");
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
  if (Status status = text_poll_.status(); !status) return status;
  if (sheet_.value_count() > limits().style_values) {
    return over_limit(element, &Limits::style_values, "values in style sheets");
  }
  warn_of_dropped(element, notes.dropped);
  if (notes.left_out.empty()) return ok_status();
  warn("/style sheet", element,
       "the style rule " + text::quoted(notes.left_out) +
           " is not read; expected simple selectors: an element, .class or #id");
  return ok_status();
}

std::optional<css::Setting> Input::styled(Element element, css::Property property) {
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

std::optional<css::Setting> Input::in_sheet(Element element, css::Property property) const {
  if (sheet_.empty()) return std::nullopt;
  return sheet_.find(element.name(), element.attribute("id").value(),
                     element.attribute("class").value(), property);
}

bool Input::is_styled(Element element, css::Property property) {
  for (const auto& setting : {styled(element, property), in_sheet(element, property)}) {
    if (!setting || wide_keyword(setting->value) != css::WideKeyword::none) continue;
    if (css::keyword_of(setting->value, text_poll_) != "none") return true;
  }
  return false;
}

css::WideKeyword Input::wide_keyword(std::string_view value) {
  // Most values are told from these words by how they begin.
  constexpr std::string_view kBeginnings = "iIuUrR\\/";
  if (value.empty() || kBeginnings.find(value.front()) == std::string_view::npos) {
    return css::WideKeyword::none;
  }
  return css::wide_keyword(value, text_poll_);
}

Input::Cascaded Input::cascaded(Element element, css::Property property) {
  std::array<std::optional<std::string_view>, 3> candidates;
  const std::optional<css::Setting> own = styled(element, property);
  const std::optional<css::Setting> sheet = in_sheet(element, property);
  if (own) candidates[0] = own->value;
  if (sheet) candidates[1] = sheet->value;
  if (sheet && sheet->is_important && !(own && own->is_important)) {
    std::swap(candidates[0], candidates[1]);
  }
  if (const auto written = attribute(element, css::property_name(property))) {
    candidates[2] = ascii_trimmed(*written);
  }
  for (const auto& candidate : candidates) {
    if (!candidate) continue;
    const css::WideKeyword keyword = wide_keyword(*candidate);
    if (keyword == css::WideKeyword::none) return {keyword, candidate};
    if (keyword != css::WideKeyword::revert_layer) return {keyword, std::nullopt};
  }
  return {};
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
