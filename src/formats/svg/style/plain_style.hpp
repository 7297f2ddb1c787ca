#pragma once

#include <optional>
#include <string_view>

#include "formats/css/value.hpp"
#include "formats/svg/paint/paints.hpp"
#include "formats/svg/read/input.hpp"
#include "formats/svg/read/plain_svg.hpp"
#include "formats/svg/style/style_levels.hpp"
#include "sfumato/base/box.hpp"

namespace sfumato::svg {

/// How far from its path a stroke may reach, in units of its width.
double stroke_reach(const StrokeStyle& style);

/// The properties of fill, stroke and markers of one shape: its own, or inherited from the elements
/// around it.
class PlainStyle {
 public:
  /// levels    the elements around the shape, from the outermost; a <use> stands before the element
  ///           that it draws. Must stay set for this shape while this object is used.
  PlainStyle(Input& input, Element shape, StyleLevels& levels, const Box& viewport)
      : input_(input), shape_(shape), levels_(levels), viewport_(viewport) {}

  /// Returns whether a paint is that of a context. If so, set_context() comes before the other
  /// functions.
  bool asks_for_context() const;
  /// Sets the paints of `context-fill` and `context-stroke`; without a context they paint nothing.
  void set_context(const std::optional<ContextPaints>& context) {
    context_ = context.value_or(ContextPaints{});
  }

  /// The paint of `fill` or `stroke`; no value for no paint. A paint that cannot be read is
  /// replaced by its fallback colour, or by no paint, with a warning.
  /// Errors: limit, cancelled, out_of_memory.
  Result<std::optional<PlainPaint>> paint(css::Property which, Paints& paints,
                                          const PaintedShape& shape);
  /// Returns the same, without `fill-opacity` or `stroke-opacity`.
  Result<std::optional<PlainPaint>> bare_paint(css::Property which, Paints& paints,
                                               const PaintedShape& shape);
  /// Warns of `image-rendering` or `shape-rendering` that asks for hard edges.
  void warn_of_rendering(css::Property which) const;
  bool even_odd() const { return keyword(css::Property::fill_rule) == "evenodd"; }
  css::PaintOrder paint_order() const;
  /// User units. Errors: bad_input.
  Result<double> stroke_width() const;
  /// Returns the value of marker-start, marker-mid or marker-end.
  std::string_view marker(css::Property which) const;
  /// Reads the style of a stroke. If the stroke does not scale, lengths are in units of the
  /// artboard. Errors: bad_input.
  Result<StrokeStyle> stroke_style() const;

 private:
  std::string_view property(css::Property which, std::string_view initial) const;
  std::string keyword(css::Property which) const;
  std::optional<std::optional<PlainPaint>> context_paint(std::string_view word) const;
  Result<std::optional<PlainPaint>> color_paint(css::Property which, std::string_view text);
  Result<std::optional<PlainPaint>> server_paint(css::Property which, std::string_view url,
                                                 std::string_view fallback, Paints& paints,
                                                 const PaintedShape& shape);
  float opacity(css::Property which) const;
  Result<double> length(css::Property which, std::string_view text) const;
  Status read_dashes(StrokeStyle& style) const;
  double said_path_length() const;
  void fix_scale(StrokeStyle& style) const;
  void warn_of_vector_effect() const;
  StyleScope scope() const { return {shape_, levels_.around()}; }

  Input& input_;
  Element shape_;
  StyleLevels& levels_;
  const Box& viewport_;
  ContextPaints context_{};
};

}  // namespace sfumato::svg
