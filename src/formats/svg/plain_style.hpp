#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "formats/svg/input.hpp"
#include "formats/svg/paints.hpp"
#include "formats/svg/plain_svg.hpp"
#include "sfumato/base/box.hpp"

namespace sfumato::svg {

/// The properties of fill and stroke of one shape: its own, or inherited from the elements around
/// it.
class PlainStyle {
 public:
  /// around   elements in which the shape is drawn, the outermost first; a <use> precedes the
  ///          element to which it refers
  PlainStyle(Input& input, Element shape, std::span<const Element> around, const Box& viewport)
      : input_(input), shape_(shape), around_(around), viewport_(viewport) {}

  /// The paint of `fill` or `stroke`; no value for no paint. A paint that cannot be read is
  /// replaced by its fallback colour, or by no paint, with a warning.
  /// Errors: limit, cancelled, out_of_memory.
  Result<std::optional<PlainPaint>> paint(css::Property which, Paints& paints,
                                          const PaintedShape& shape);
  bool even_odd() const { return keyword(css::Property::fill_rule) == "evenodd"; }
  bool stroke_first() const;
  /// Errors: bad_input.
  Result<StrokeStyle> stroke_style() const;

 private:
  std::string_view property(css::Property which, std::string_view initial) const;
  std::string keyword(css::Property which) const;
  Result<std::optional<PlainPaint>> color_paint(css::Property which, std::string_view text);
  Result<std::optional<PlainPaint>> server_paint(css::Property which, std::string_view url,
                                                 std::string_view fallback, Paints& paints,
                                                 const PaintedShape& shape);
  float opacity(css::Property which) const;
  Result<double> length(css::Property which, std::string_view text) const;
  Status read_dashes(StrokeStyle& style) const;

  Input& input_;
  Element shape_;
  std::span<const Element> around_;
  const Box& viewport_;
};

/// Whether the import continues with a warning after this error.
inline bool can_be_left_out(const Status& status) {
  return status.code == StatusCode::bad_input;
}

}  // namespace sfumato::svg
