#pragma once

#include <cstddef>
#include <cstdint>
#include <pugixml.hpp>
#include <vector>

#include "formats/css/style_sheet.hpp"

namespace sfumato::svg {

/// Finds the rules with selectors of several parts that match an element. Counts its steps: a test
/// of a part, an element, or 32 bytes of an attribute. Cost: the number of rules with the element's
/// id, class or name in their last compound, times the elements around it.
class SelectorMatcher {
 public:
  SelectorMatcher(const css::StyleSheet& sheet, std::size_t most_steps)
      : sheet_(sheet), most_steps_(most_steps) {}

  /// Returns the numbers of the rules that match, in no particular order; valid until the next
  /// call. Empty once the steps are used up.
  const std::vector<std::uint32_t>& match(pugi::xml_node element);

  /// Counts steps that the caller takes. False once they are used up.
  bool take(std::size_t steps) {
    steps_ += steps;
    return steps_ <= most_steps_;
  }
  bool is_over() const { return steps_ > most_steps_; }

 private:
  /// Why parts do not match: a search from another sibling or ancestor may succeed, or none can.
  enum class Outcome : std::uint8_t { matched, try_sibling, try_ancestor, failed };

  void test(std::span<const std::uint32_t> rules, pugi::xml_node element);
  Outcome match_from(std::span<const css::SelectorPart> parts, pugi::xml_node element);
  Outcome match_before(std::span<const css::SelectorPart> parts,
                       css::SelectorPart::Combinator combinator, pugi::xml_node element);
  Outcome match_ancestor(std::span<const css::SelectorPart> parts, pugi::xml_node element);
  Outcome match_sibling(std::span<const css::SelectorPart> parts, pugi::xml_node element,
                        bool is_any);
  bool is_matched(const css::SelectorPart& part, pugi::xml_node element);
  bool is_met(const css::SelectorPart& part, pugi::xml_node element);
  bool has_class(std::string_view asked, pugi::xml_node element);
  bool has_attribute(const css::SelectorPart& part, pugi::xml_node element);
  pugi::xml_node previous_element(pugi::xml_node element);
  pugi::xml_node next_element(pugi::xml_node element);

  const css::StyleSheet& sheet_;
  std::size_t most_steps_;
  std::size_t steps_ = 0;
  std::vector<std::uint32_t> matched_;
};

}  // namespace sfumato::svg
