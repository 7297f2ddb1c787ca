#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace sfumato::svg {

/// The simple part of CSS: rules whose selectors are `*`, an element's name, `.class` or `#id`.
class StyleSheet {
 public:
  /// Adds the rules of a sheet; the text must outlive this. What is not simple is left out: the
  /// first such selector or at-rule is returned. Beyond `most_values` none are added.
  std::string_view add(std::string_view text, std::size_t most_values);

  bool empty() const { return values_.empty(); }
  /// Values that the rules set, selector by selector; one more than the most where there were more.
  std::size_t value_count() const { return count_; }

  /// What the rules say of an element: the id's rule before the classes' before the name's.
  std::optional<std::string_view> find(std::string_view name, std::string_view id,
                                       std::string_view classes, std::string_view property) const;

 private:
  struct Value {
    std::string_view text;
    std::size_t order = 0;  ///< later rules win
  };

  void add_rule(std::string_view selector, std::string_view declarations, std::size_t most_values);
  const Value* value_of(std::string selector, std::string_view property) const;

  std::map<std::string, Value, std::less<>> values_;  ///< by selector, newline, property
  std::size_t count_ = 0;
};

}  // namespace sfumato::svg
