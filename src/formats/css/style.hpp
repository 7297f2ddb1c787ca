#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "formats/css/declarations.hpp"
#include "formats/css/properties.hpp"

namespace sfumato::css {

/// The value of a property from one source.
struct Setting {
  std::string_view value{};  ///< raw; valid
  bool is_important = false;
};

/// The properties that a block of declarations sets. Of several declarations of one property the
/// last important one wins, else the last. Declarations that CSS drops set nothing.
class Style {
 public:
  /// Adds the next declaration.
  void add(const Declaration& declaration, TextPoll& poll);

  const std::optional<Setting>& operator[](Property property) const {
    return settings_[static_cast<std::size_t>(property)];
  }
  /// The number of declarations added, of any property.
  std::size_t declaration_count() const { return declaration_count_; }
  /// The first declaration of a known property that was dropped.
  const std::optional<Declaration>& dropped() const { return dropped_; }

 private:
  void set(Property property, const Declaration& declaration);

  std::array<std::optional<Setting>, kPropertyCount> settings_{};
  std::size_t declaration_count_ = 0;
  std::optional<Declaration> dropped_;
};

}  // namespace sfumato::css
