#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string_view>

#include "formats/css/declarations.hpp"
#include "formats/css/properties.hpp"

namespace sfumato::css {

/// Custom properties of one block of declarations.
inline constexpr std::size_t kVariablesPerBlock = 10'000;

/// The value of a property from one source.
struct Setting {
  std::string_view value{};  ///< raw; valid
  bool is_important = false;
};

/// Holds the properties that a block of declarations sets. The last important declaration of a
/// property wins, else the last declaration. Declarations that CSS drops set nothing.
class Style {
 public:
  /// Adds the next declaration.
  void add(const Declaration& declaration, TextPoll& poll);

  const std::optional<Setting>& operator[](Property property) const {
    return settings_[static_cast<std::size_t>(property)];
  }
  /// Returns the custom properties, by name.
  const std::map<std::string_view, Setting>& variables() const { return variables_; }
  /// Calls sink(name, setting) for each property that the block sets, custom ones last.
  template <class Sink>
  void for_each(Sink sink) const {
    for (std::size_t i = 0; i < kPropertyCount; ++i) {
      if (settings_[i]) sink(PropertyName{static_cast<Property>(i)}, *settings_[i]);
    }
    for (const auto& [name, setting] : variables_) {
      sink(PropertyName{Property::custom, name}, setting);
    }
  }
  /// Returns whether the block sets no property that is read.
  bool empty() const;
  /// Returns the number of declarations added, of any property.
  std::size_t declaration_count() const { return declaration_count_; }
  /// Returns the first declaration of a known or a custom property that was dropped.
  const std::optional<Declaration>& dropped() const { return dropped_; }

 private:
  void set(Property property, const Declaration& declaration);
  void set_background(const Declaration& declaration, TextPoll& poll);
  void set_markers(const Declaration& declaration, TextPoll& poll);
  void set_variable(const Declaration& declaration, TextPoll& poll);
  void drop(const Declaration& declaration) {
    if (!dropped_) dropped_ = declaration;
  }

  std::array<std::optional<Setting>, kPropertyCount> settings_{};
  std::map<std::string_view, Setting> variables_;
  std::size_t declaration_count_ = 0;
  std::optional<Declaration> dropped_;
};

}  // namespace sfumato::css
