#include "formats/svg/style/selector_match.hpp"

#include <algorithm>
#include <span>
#include <string_view>

#include "base/text/ascii.hpp"

namespace sfumato::svg {
namespace {

using css::SelectorPart;
using PartKind = SelectorPart::Kind;
using Combinator = SelectorPart::Combinator;
using AttributeMatch = SelectorPart::Match;
using SelectorParts = std::span<const SelectorPart>;

/// Bytes of a text that cost as much as any other step.
constexpr std::size_t kStepText = 32;

bool is_element(pugi::xml_node node) {
  return node.type() == pugi::node_element;
}

/// Calls `is_wanted` with each word of a list that white space separates, until it returns true.
template <class IsWanted>
bool any_word(std::string_view list, IsWanted is_wanted) {
  while (!(list = ascii_trimmed(list)).empty()) {
    const auto end = std::ranges::find_if(list, is_ascii_blank);
    const auto length = static_cast<std::size_t>(end - list.begin());
    if (is_wanted(list.substr(0, length))) return true;
    list.remove_prefix(length);
  }
  return false;
}

char folded(char c, bool ignores_case) {
  return ignores_case && c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool is_equal(std::string_view a, std::string_view b, bool ignores_case) {
  return std::ranges::equal(a, b, [ignores_case](char x, char y) {
    return folded(x, ignores_case) == folded(y, ignores_case);
  });
}

bool compares(std::string_view text, const SelectorPart& part) {
  const std::string_view asked = part.value;
  const auto is_asked = [&](std::string_view piece) {
    return is_equal(piece, asked, part.ignores_case);
  };
  const bool has_room = !asked.empty() && asked.size() <= text.size();
  switch (part.match) {
    case AttributeMatch::exists:
      return true;
    case AttributeMatch::equals:
      return is_asked(text);
    case AttributeMatch::word:
      return any_word(text, is_asked);
    case AttributeMatch::dash:
      return is_asked(text) || (text.size() > asked.size() && text[asked.size()] == '-' &&
                                is_asked(text.substr(0, asked.size())));
    case AttributeMatch::prefix:
      return has_room && is_asked(text.substr(0, asked.size()));
    case AttributeMatch::suffix:
      return has_room && is_asked(text.substr(text.size() - asked.size()));
    case AttributeMatch::substring:
      for (std::size_t at = 0; has_room && at + asked.size() <= text.size(); ++at) {
        if (is_asked(text.substr(at, asked.size()))) return true;
      }
      return false;
  }
  return false;
}

/// Where the compound of the last part begins.
std::size_t compound_begin(SelectorParts parts) {
  std::size_t i = parts.size() - 1;
  while (i > 0 && parts[i].combinator == Combinator::none) --i;
  return i;
}

}  // namespace

const std::vector<std::uint32_t>& SelectorMatcher::match(pugi::xml_node element) {
  matched_.clear();
  test(sheet_.rules_for(PartKind::any, {}), element);
  test(sheet_.rules_for(PartKind::element, element.name()), element);
  if (const std::string_view id = element.attribute("id").value(); !id.empty()) {
    test(sheet_.rules_for(PartKind::id, id), element);
  }
  std::vector<std::string_view> seen;
  any_word(element.attribute("class").value(), [&](std::string_view one) {
    const std::span<const std::uint32_t> rules = sheet_.rules_for(PartKind::of_class, one);
    // A class that is written twice matches no rule twice.
    if (!rules.empty() && std::ranges::find(seen, one) == seen.end()) {
      test(rules, element);
      seen.push_back(one);
    }
    return !take(1 + seen.size() / kStepText + one.size() / kStepText);
  });
  if (is_over()) matched_.clear();
  return matched_;
}

void SelectorMatcher::test(std::span<const std::uint32_t> rules, pugi::xml_node element) {
  for (const std::uint32_t rule : rules) {
    const SelectorParts parts = sheet_.parts_of(sheet_.complex_rules()[rule]);
    if (match_from(parts, element) == Outcome::matched) matched_.push_back(rule);
    if (is_over()) return;
  }
}

/// Whether the parts match with `element` as the last. A failure says how far the search went back
/// for nothing, so that each part is tried once for each ancestor.
SelectorMatcher::Outcome SelectorMatcher::match_from(SelectorParts parts, pugi::xml_node element) {
  const std::size_t begin = compound_begin(parts);
  for (std::size_t i = begin; i < parts.size(); ++i) {
    if (!is_matched(parts[i], element)) return Outcome::try_sibling;
  }
  if (begin == 0) return Outcome::matched;
  return match_before(parts.first(begin), parts[begin].combinator, element);
}

SelectorMatcher::Outcome SelectorMatcher::match_before(SelectorParts parts, Combinator combinator,
                                                       pugi::xml_node element) {
  switch (combinator) {
    case Combinator::next_sibling:
    case Combinator::later_sibling:
      return match_sibling(parts, element, combinator == Combinator::later_sibling);
    case Combinator::child: {
      const pugi::xml_node parent = element.parent();
      if (!is_element(parent)) return Outcome::failed;
      const Outcome outcome = match_from(parts, parent);
      return outcome == Outcome::try_sibling ? Outcome::try_ancestor : outcome;
    }
    default:
      return match_ancestor(parts, element);
  }
}

SelectorMatcher::Outcome SelectorMatcher::match_ancestor(SelectorParts parts,
                                                         pugi::xml_node element) {
  for (element = element.parent(); is_element(element); element = element.parent()) {
    const Outcome outcome = match_from(parts, element);
    if (outcome == Outcome::matched || outcome == Outcome::failed || is_over()) return outcome;
  }
  return Outcome::failed;
}

/// is_any: any earlier sibling, else the previous one.
SelectorMatcher::Outcome SelectorMatcher::match_sibling(SelectorParts parts, pugi::xml_node element,
                                                        bool is_any) {
  while ((element = previous_element(element))) {
    const Outcome outcome = match_from(parts, element);
    if (outcome != Outcome::try_sibling || !is_any || is_over()) return outcome;
  }
  return Outcome::try_ancestor;
}

pugi::xml_node SelectorMatcher::previous_element(pugi::xml_node element) {
  do {
    element = element.previous_sibling();
  } while (take(1) && element && !is_element(element));
  return element;
}

pugi::xml_node SelectorMatcher::next_element(pugi::xml_node element) {
  do {
    element = element.next_sibling();
  } while (take(1) && element && !is_element(element));
  return element;
}

bool SelectorMatcher::is_matched(const SelectorPart& part, pugi::xml_node element) {
  return take(1) && is_met(part, element) != part.is_negated;
}

bool SelectorMatcher::is_met(const SelectorPart& part, pugi::xml_node element) {
  switch (part.kind) {
    case PartKind::any:
      return true;
    case PartKind::element:
      return part.name == element.name();
    case PartKind::of_class:
      return has_class(part.name, element);
    case PartKind::id:
      return part.name == element.attribute("id").value();
    case PartKind::attribute:
      return has_attribute(part, element);
    case PartKind::root:
      return !is_element(element.parent());
    case PartKind::first_child:
      return !previous_element(element);
    case PartKind::last_child:
      return !next_element(element);
    case PartKind::only_child:
      return !previous_element(element) && !next_element(element);
    case PartKind::never:
      return false;
  }
  return false;
}

bool SelectorMatcher::has_class(std::string_view asked, pugi::xml_node element) {
  const std::string_view classes = element.attribute("class").value();
  return take(classes.size() / kStepText) &&
         any_word(classes, [asked](std::string_view one) { return one == asked; });
}

bool SelectorMatcher::has_attribute(const SelectorPart& part, pugi::xml_node element) {
  // Names of the tree that begin with ':' belong to Sfumato's own attributes.
  for (const pugi::xml_attribute attribute : element.attributes()) {
    if (!take(1)) return false;
    if (part.name != attribute.name()) continue;
    const std::string_view text = attribute.value();
    const bool is_search = part.match == AttributeMatch::substring;
    const std::size_t work = text.size() / kStepText * (is_search ? 1 + part.value.size() : 1);
    return take(work) && compares(text, part);
  }
  return false;
}

}  // namespace sfumato::svg
