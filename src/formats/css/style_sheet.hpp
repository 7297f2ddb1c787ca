#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "formats/css/selector.hpp"
#include "formats/css/style.hpp"

namespace sfumato::css {

/// The simple part of CSS: rules whose selectors are `*`, an element's name, `.class` or `#id`, at
/// the top or in @media that a screen matches.
class StyleSheet {
 public:
  /// Parts of a sheet that set nothing, the first of each kind.
  struct Notes {
    std::string_view left_out{};  ///< a selector or an at-rule that is not supported
    std::optional<Declaration> dropped{};
  };

  /// Adds the rules of a sheet; the text must outlive this. Stops after `most_values` values.
  Notes add(std::string_view text, std::size_t most_values, TextPoll& poll);

  bool empty() const { return values_.empty(); }
  /// Number of values that the rules set, counted per selector, of any property; exceeds
  /// `most_values` if there were more.
  std::size_t value_count() const { return count_; }

  /// The value that the rules set for an element. Important values precede the rest; then rules for
  /// the id precede rules for classes, and these rules for the name; then later rules win.
  std::optional<Setting> find(std::string_view name, std::string_view id, std::string_view classes,
                              Property property) const;

 private:
  struct Value {
    Setting setting;
    std::size_t order = 0;  ///< later rules win
  };

  struct Key {
    Selector::Kind kind;
    Property property;
    std::string_view name;

    bool operator<(const Key& other) const;
  };

  class Reader;

  void add_rule(const Selector& selector, const Style& style, std::size_t most_values);
  const Value* value_of(const Key& key) const;

  std::map<Key, Value> values_;
  std::deque<std::string> names_;  ///< names that were written with escapes
  std::size_t count_ = 0;
};

}  // namespace sfumato::css
