#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "formats/css/variables.hpp"
#include "formats/svg/read/input.hpp"
#include "formats/svg/style/style_scope.hpp"

namespace sfumato::svg {

/// Bytes that the var() of one value read and write, all custom properties within each other
/// included.
inline constexpr std::size_t kVariableValueBytes = std::size_t{1} << 16;

/// Replaces var() in one value (CSS Custom Properties 1, section 3).
class VariableValues {
 public:
  explicit VariableValues(Input& input) : input_(input) {}

  /// Appends the value with each var() replaced. False if the value is invalid at computed-value
  /// time: a property is missing and has no fallback, or properties refer to each other in a cycle.
  bool expand(const StyleScope& scope, std::string_view value, std::string& text);
  /// Returns whether a limit made the value invalid.
  bool is_over() const { return is_over_; }

 private:
  /// A custom property whose value is being computed.
  struct Open {
    pugi::xml_node element;  ///< that declares it
    std::string_view name;
  };

  bool take(std::size_t bytes);
  bool append(std::string_view piece, std::string& text);
  bool replace(const StyleScope& scope, const css::VariableReference& reference, std::string& text);
  bool append_variable(StyleScope scope, std::string_view name, std::string& text);
  bool append_declared(const StyleScope& scope, std::string_view name, std::string_view value,
                       std::string& text);

  Input& input_;
  std::vector<Open> open_;
  /// The outermost open property of a cycle; the properties within it are invalid.
  std::size_t cycle_begin_ = kNoCycle;
  static constexpr std::size_t kNoCycle = ~std::size_t{0};
  std::size_t depth_ = 0;
  std::size_t bytes_ = 0;
  bool is_over_ = false;
};

}  // namespace sfumato::svg
