#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "formats/css/declarations.hpp"
#include "formats/css/properties.hpp"

namespace sfumato::css {

/// What one source says of a property.
struct Setting {
  std::string_view value{};  ///< raw; CSS keeps it
  bool is_important = false;
};

/// What a block of declarations sets: of several of one property the last important one, else the
/// last. Declarations that CSS drops set nothing.
class Style {
 public:
  /// Takes the next declaration.
  void add(const Declaration& declaration, TextPoll& poll);

  const std::optional<Setting>& operator[](Property property) const {
    return settings_[static_cast<std::size_t>(property)];
  }
  /// How many declarations were taken, of whatever property.
  std::size_t declaration_count() const { return declaration_count_; }
  /// The first that was dropped though its property is known.
  const std::optional<Declaration>& dropped() const { return dropped_; }

 private:
  void set(Property property, const Declaration& declaration);

  std::array<std::optional<Setting>, kPropertyCount> settings_{};
  std::size_t declaration_count_ = 0;
  std::optional<Declaration> dropped_;
};

}  // namespace sfumato::css
