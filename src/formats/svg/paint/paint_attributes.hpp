#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "formats/svg/paint/paints.hpp"
#include "formats/svg/read/input.hpp"
#include "formats/svg/style/length.hpp"
#include "sfumato/base/affine.hpp"

namespace sfumato::svg {

/// A paint server, followed by the servers that it inherits from by href.
class PaintAttributes {
 public:
  /// Follows the chain. Errors: bad_input if the chain is a cycle or refers to an element that is
  /// not a paint server.
  static Result<PaintAttributes> read(Input& input, Element paint);

  Element paint() const { return chain_.front(); }
  /// Returns the first in the chain that has the attribute; null if none has. `same_kind`:
  /// considers only paint servers with the element name of the first.
  Element bearer(const char* name, bool same_kind = false) const;
  /// Returns the first in the chain that satisfies the predicate; null if there is none.
  template <class IsWanted>
  Element first_with(IsWanted is_wanted) const {
    for (const Element element : chain_) {
      if (is_wanted(element)) return element;
    }
    return {};
  }
  std::optional<std::string_view> text(const char* name) const;

  /// Returns whether the attribute says objectBoundingBox. Errors: bad_input for unknown values.
  Result<bool> in_bounding_box(const char* name, bool by_default) const;
  /// Returns a length in user units or, if `in_box`, as a fraction of the bounding box.
  Result<double> length(const char* name, bool in_box, const Box& viewport, Axis axis,
                        double share_by_default) const;
  /// Returns gradientTransform or patternTransform, or the property `transform` of a style, about
  /// transform-origin, of the first in the chain where it can be read. Errors: bad_input, also if
  /// it has no inverse.
  Result<Affine> transform(const char* name, const Box& viewport) const;

 private:
  PaintAttributes(Input& input, std::vector<Element> chain)
      : input_(&input), chain_(std::move(chain)) {}

  Result<std::optional<Affine>> transform_of(Element element, const char* name,
                                             const Box& viewport) const;

  Input* input_;
  std::vector<Element> chain_;
};

/// Returns the map from the unit square onto the bounding box. Errors: bad_input if the box has no
/// area.
Result<Affine> user_from_bounds(Input& input, const PaintedShape& shape, Element paint);

/// Returns whether the map can be inverted and is within the limits.
bool is_usable(const Affine& map);

}  // namespace sfumato::svg
