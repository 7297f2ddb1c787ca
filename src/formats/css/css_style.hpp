#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "formats/css/css_declarations.hpp"
#include "formats/css/css_properties.hpp"

namespace sfumato {

/// What one source says of a property.
struct CssSetting {
  std::string_view value{};  ///< raw; CSS keeps it
  bool is_important = false;
};

/// What a block of declarations sets: of several of one property the last important one, else the
/// last. Declarations that CSS drops set nothing.
class CssStyle {
 public:
  /// Takes the next declaration.
  void add(const CssDeclaration& declaration, TextPoll& poll);

  const std::optional<CssSetting>& operator[](CssProperty property) const {
    return settings_[static_cast<std::size_t>(property)];
  }
  /// How many declarations were taken, of whatever property.
  std::size_t declaration_count() const { return declaration_count_; }
  /// The first that was dropped though its property is known.
  const std::optional<CssDeclaration>& dropped() const { return dropped_; }

 private:
  void set(CssProperty property, const CssDeclaration& declaration);

  std::array<std::optional<CssSetting>, kCssPropertyCount> settings_{};
  std::size_t declaration_count_ = 0;
  std::optional<CssDeclaration> dropped_;
};

}  // namespace sfumato
