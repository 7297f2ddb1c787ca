#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "formats/svg/input.hpp"
#include "formats/svg/length.hpp"
#include "formats/svg/paints.hpp"
#include "sfumato/base/affine.hpp"

namespace sfumato::svg {

/// A paint server with those that it inherits from by href, itself first.
class PaintAttributes {
 public:
  /// Follows the chain. Errors: bad_input where it is a circle or refers to what is no paint.
  static Result<PaintAttributes> read(Input& input, Element paint);

  Element paint() const { return chain_.front(); }
  /// The first of the chain that has the attribute; null where none has. `same_kind`: only paints
  /// of the first one's element name are asked.
  Element bearer(const char* name, bool same_kind = false) const;
  /// The first of the chain that is as asked; null where none is.
  template <class IsWanted>
  Element first_with(IsWanted is_wanted) const {
    for (const Element element : chain_) {
      if (is_wanted(element)) return element;
    }
    return {};
  }
  std::optional<std::string_view> text(const char* name) const;

  /// Whether the attribute says objectBoundingBox. Errors: bad_input for other words.
  Result<bool> in_bounding_box(const char* name, bool by_default) const;
  /// A length in user units, or where `in_box`, as a share of the bounding box.
  Result<double> length(const char* name, bool in_box, const Box& viewport, Axis axis,
                        double share_by_default) const;
  /// gradientTransform or patternTransform. Errors: bad_input, also where it has no inverse.
  Result<Affine> transform(const char* name) const;

 private:
  PaintAttributes(Input& input, std::vector<Element> chain)
      : input_(&input), chain_(std::move(chain)) {}

  Input* input_;
  std::vector<Element> chain_;
};

/// The map from the unit square onto the bounding box. Errors: bad_input where it has no area.
Result<Affine> user_from_bounds(Input& input, const PaintedShape& shape, Element paint);

/// Whether the map can be inverted and is within the limits.
bool is_usable(const Affine& map);

}  // namespace sfumato::svg
