#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "formats/css/selector.hpp"
#include "formats/css/style.hpp"

namespace sfumato::css {

/// A setting of a rule, with its place in the cascade.
struct RankedSetting {
  Setting setting;
  std::uint32_t specificity = 0;
  std::size_t order = 0;  ///< of the rules in the sheets

  /// Returns whether this one wins over the other.
  bool outranks(const RankedSetting& other) const;
};

/// The rules of style sheets, at the top or in @media that a screen matches. find() finds rules
/// with a selector of one part (`*`, an element's name, `.class`, `#id`). The caller matches the
/// other rules with the elements of a tree.
class StyleSheet {
 public:
  /// Parts of a sheet that set nothing, the first of each kind.
  struct Notes {
    std::string_view left_out{};  ///< a selector or an at-rule that is not supported
    std::optional<Declaration> dropped{};
  };

  struct NamedSetting {
    PropertyName name;
    Setting setting;
  };

  /// A rule with a selector of several parts. Its texts are unescaped.
  struct ComplexRule {
    std::uint32_t first_part = 0, part_count = 0;
    std::uint32_t first_setting = 0, setting_count = 0;
    std::uint32_t specificity = 0;
    std::size_t order = 0;
  };

  /// Adds the rules of a sheet; the text must outlive this. Stops after `most_values` values.
  Notes add(std::string_view text, std::size_t most_values, TextPoll& poll);

  bool empty() const { return values_.empty() && rules_.empty(); }
  /// Number of values that the rules set, counted per selector, of any property, and of parts of
  /// selectors but the first; exceeds `most_values` if there were more.
  std::size_t value_count() const { return count_; }
  /// Returns whether a rule sets this property of any element.
  bool sets(Property property) const { return is_set_[static_cast<std::size_t>(property)]; }

  /// Returns the value that the rules with selectors of one part set for an element.
  std::optional<RankedSetting> find(std::string_view name, std::string_view id,
                                    std::string_view classes, const PropertyName& property) const;

  std::span<const ComplexRule> complex_rules() const { return rules_; }
  /// Returns the numbers of the rules whose last compound asks for this name, class or id, or for
  /// none of them (Kind::any).
  std::span<const std::uint32_t> rules_for(SelectorPart::Kind kind, std::string_view name) const;
  std::span<const SelectorPart> parts_of(const ComplexRule& rule) const;
  const NamedSetting& setting(std::uint32_t index) const { return settings_[index]; }

 private:
  using Kind = SelectorPart::Kind;

  struct Key {
    Kind kind;
    PropertyName property;
    std::string_view name;

    bool operator<(const Key& other) const;
  };

  class Reader;

  void add_rule(const Selector& selector, const Style& style, std::size_t most_values);
  void add_complex_rule(const Selector& selector, std::span<const SelectorPart> parts,
                        const Style& style, std::size_t most_values);
  void add_settings(const Style& style);
  void index_rule(std::span<const SelectorPart> parts);
  bool count(std::size_t values, std::size_t most_values);
  std::string_view stored(std::string_view raw);
  void consider(const Key& key, std::optional<RankedSetting>& best) const;

  std::map<Key, RankedSetting> values_;
  std::vector<ComplexRule> rules_;
  std::vector<SelectorPart> parts_;
  std::vector<NamedSetting> settings_;
  std::map<std::pair<Kind, std::string_view>, std::vector<std::uint32_t>> rules_for_;
  std::array<bool, kPropertyCount + 1> is_set_{};
  bool shares_settings_ = false;  ///< the block's settings are already the last ones
  std::uint32_t first_setting_ = 0;
  std::deque<std::string> names_;  ///< texts that were written with escapes
  std::size_t count_ = 0;
};

}  // namespace sfumato::css
