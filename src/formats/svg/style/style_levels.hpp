#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "formats/css/properties.hpp"
#include "formats/svg/read/input.hpp"

namespace sfumato::svg {

/// The elements around a shape, and the values of properties that it inherits from them. Shapes are
/// read one after another: the values of elements that the next one shares are kept, so that a
/// property costs one step for each element, however many shapes lie in it.
class StyleLevels {
 public:
  explicit StyleLevels(Input& input) : input_(input) {}

  /// Sets the elements around the next shape, the outermost first.
  void set(std::vector<Element> around);
  /// Valid until the next set().
  std::span<const Element> around() const { return around_; }
  /// Returns the value of the innermost element, which the shape inherits; none if it is initial.
  std::optional<std::string_view> value(css::Property property);

 private:
  /// Nothing where the property was not asked for.
  using Known = std::optional<std::optional<std::string_view>>;
  using Values = std::array<Known, css::kPropertyCount>;

  Known own_value(std::size_t level, css::Property property);

  Input& input_;
  std::vector<Element> around_;
  std::vector<Values> values_;  ///< of the first elements of around_
};

}  // namespace sfumato::svg
