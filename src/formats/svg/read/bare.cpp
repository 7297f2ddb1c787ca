#include "formats/svg/read/bare.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "base/text/ascii.hpp"
#include "formats/css/declarations.hpp"
#include "formats/text/suggestion.hpp"

namespace sfumato::svg {
namespace {

/// Attributes that SVG has not under these names, but Sfumato has.
constexpr std::array<std::string_view, 8> kOurs{
    "left", "right", "left-blur", "right-blur", "left-opacity", "right-opacity", "diffuse", "blur"};

/// Returns the name of an attribute that lacks its prefix.
std::optional<std::string> without_prefix(Element element) {
  for (const pugi::xml_attribute attribute : element.attributes()) {
    if (std::ranges::find(kOurs, attribute.name()) != kOurs.end()) return attribute.name();
  }
  return std::nullopt;
}

/// "sf:left" of style="sf:left:red".
std::optional<std::string> in_style(Input& input, Element element) {
  const auto style = input.attribute(element, "style");
  if (!style) return std::nullopt;
  std::optional<std::string> found;
  css::Tokenizer tokens(*style, input.text_poll());
  css::read_declarations(tokens, false, [&](const css::Declaration& declaration) {
    const std::string_view name = declaration.value.substr(0, declaration.value.find(':'));
    if (!found && declaration.name == "sf" && std::ranges::find(kOurs, name) != kOurs.end()) {
      found = "sf:" + std::string(name);
    }
  });
  return found;
}

/// Returns an explanation if Sfumato's attributes are written in a form that is not read.
std::string misplaced(Input& input, Element element) {
  const std::string of = " of " + tag(element);
  if (const auto name = without_prefix(element)) {
    return *name + of + " has no prefix; use sf:" + *name;
  }
  if (const auto name = in_style(input, element)) {
    return *name + of + " is in style; write it as an attribute: " + *name + "=\"…\"";
  }
  return {};
}

/// Returns a prefix that was meant to be ours and leads elsewhere.
std::string wrong_address(Element element) {
  for (const pugi::xml_attribute attribute : element.attributes()) {
    const std::string_view name = attribute.name();
    if (!name.starts_with("xmlns:")) continue;
    const std::string_view prefix = name.substr(6), address = attribute.value();
    if (address == "urn:sfumato:1") continue;
    const bool is_meant = prefix == "sf" || prefix == "sfumato" ||
                          ascii_lower(address.substr(0, 256)).find("sfumato") != std::string::npos;
    if (!is_meant) continue;
    return "the prefix " + std::string(prefix.substr(0, 64)) + " is bound to " +
           text::quoted(address) + "; use xmlns:" + std::string(prefix.substr(0, 64)) +
           "=\"urn:sfumato:1\"";
  }
  return {};
}

/// Holds facts about Sfumato's attributes in a document.
struct Facts {
  bool has_ours = false;
  std::string address;    ///< a complaint; empty: none
  std::string misplaced;  ///< the same
};

void look(Input& input, Element element, Facts& facts) {
  if (!input.check()) return;
  facts.has_ours |= element != input.root() && input.has_sf(element);
  if (facts.address.empty()) facts.address = wrong_address(element);
  if (facts.misplaced.empty()) facts.misplaced = misplaced(input, element);
  for (const Element child : element.children()) {
    if (child.type() == pugi::node_element) look(input, child, facts);
  }
}

template <class Sides>
bool has_color(const Sides& side) {
  return side.color.kind == ShaderKind::curve_domain || side.color.kind == ShaderKind::image_domain;
}

}  // namespace

std::string why_bare(Input& input, Element shape) {
  std::string why = tag(shape) + " in a layer bears nothing and draws nothing";
  const std::string cause = misplaced(input, shape);
  return why + ": " +
         (cause.empty() ? "stroke and fill are not read there; use sf:left, sf:right or both"
                        : cause);
}

bool gives_color(const Document& document) {
  const auto is_colored = [](const Curve& curve) {
    return has_color(curve.left) || has_color(curve.right);
  };
  const auto has_colored = [&](const Layer& layer) {
    return std::ranges::any_of(layer.curves, is_colored);
  };
  const auto is_stroke = [](const StackItem& item) {
    return std::holds_alternative<LocalStroke>(item);
  };
  return std::ranges::any_of(document.layers, has_colored) ||
         std::ranges::any_of(document.stack, is_stroke);
}

EmptyCause why_empty(Input& input) {
  Facts facts;
  look(input, input.root(), facts);
  if (!facts.address.empty()) return {facts.address};
  if (!facts.misplaced.empty()) return {facts.misplaced};
  if (facts.has_ours) return {};
  return {
      "it contains no curves of Sfumato; add curves with sf:left and sf:right in <g "
      "sf:diffuse=\"true\">",
      true};
}

}  // namespace sfumato::svg
