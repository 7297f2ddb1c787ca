#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "formats/css/tokenizer.hpp"

namespace sfumato::css {

/// A simple selector: one condition on an element.
struct SelectorPart {
  enum class Kind : std::uint8_t {
    any,       ///< *
    element,   ///< name
    of_class,  ///< .name
    id,        ///< #name
    attribute,
    root,
    first_child,
    last_child,
    only_child,
    never  ///< true of no element of a picture, such as :hover
  };
  /// The relation between the element and the element of the part before.
  enum class Combinator : std::uint8_t {
    none,        ///< it is the same element
    descendant,  ///< white space
    child,
    next_sibling,
    later_sibling
  };
  /// How the attribute's value compares with `value`.
  enum class Match : std::uint8_t { exists, equals, word, dash, prefix, suffix, substring };

  Kind kind = Kind::any;
  Combinator combinator = Combinator::none;
  Match match = Match::exists;
  bool ignores_case = false;  ///< of the attribute's value
  bool is_negated = false;    ///< in :not()
  std::string_view name{};    ///< raw: unescaped()
  std::string_view value{};   ///< raw; of an attribute
};

/// One selector of a list.
struct Selector {
  /// The kind of a selector: one part, several parts, or not read.
  enum class Kind : std::uint8_t {
    any,          ///< *
    element,      ///< name
    of_class,     ///< .name
    id,           ///< #name
    complex,      ///< other parts than these, or several
    unsupported,  ///< valid CSS, but not read
    invalid       ///< CSS drops the rule
  };

  Kind kind = Kind::invalid;
  std::string_view name{};        ///< raw: unescaped(); of the first four kinds
  std::string_view text{};        ///< all of it
  std::uint32_t specificity = 0;  ///< the larger wins; as CSS counts ids, classes and names
  bool is_last = false;
};

/// The most parts of a selector that is read.
inline constexpr std::size_t kSelectorParts = 64;

/// Returns the specificity that a part adds to its selector.
std::uint32_t specificity_of(SelectorPart::Kind kind);

/// Consumes the next selector of a list, up to its comma or the end of the text. `parts`: cleared,
/// then filled with the parts of a selector that is read.
Selector take_selector(Tokenizer& tokens, std::vector<SelectorPart>& parts);

}  // namespace sfumato::css
