#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

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

  struct Key {
    char kind;  ///< '#', '.', or 'e': an element's name or '*'
    std::string_view name;
    std::string_view property;

    bool operator<(const Key& other) const;
  };

  /// A property and its value.
  using Declaration = std::pair<std::string_view, std::string_view>;

  void add_rule(std::string_view selector, const std::vector<Declaration>& declarations,
                std::size_t most_values);
  const Value* value_of(const Key& key) const;

  std::map<Key, Value> values_;
  std::size_t count_ = 0;
};

}  // namespace sfumato::svg
