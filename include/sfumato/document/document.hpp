#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "sfumato/base/affine.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/base/color.hpp"
#include "sfumato/base/color_space.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/base/vec2.hpp"
#include "sfumato/document/curve.hpp"
#include "sfumato/document/shader.hpp"

namespace sfumato {

/// How the colours of an item mix with the colours below it: the modes of CSS
/// `mix-blend-mode`, as defined in the W3C's Compositing and Blending Level 1, on sRGB code values.
enum class BlendMode : std::uint8_t {
  normal,       ///< covers the colours below
  multiply,     ///< the product of both: darkens
  screen,       ///< the product of both complements: lightens
  overlay,      ///< multiply or screen, depending on whether the colour below is dark or light
  darken,       ///< the smaller of both, in each channel
  lighten,      ///< the larger of both, in each channel
  color_dodge,  ///< brightens the colours below by the item's colour
  color_burn,   ///< darkens the colours below by the item's colour
  hard_light,   ///< multiply or screen, depending on whether the item's colour is dark or light
  soft_light,   ///< the same, softer
  difference,   ///< the absolute difference of both
  exclusion,    ///< the same with less contrast
  hue,          ///< the item's hue; saturation and luminosity of the colours below
  saturation,   ///< the item's saturation
  color,        ///< the item's hue and saturation
  luminosity    ///< the item's luminosity; hue and saturation of the colours below
};

/// Curves that are solved together: one mesh, one solution. Their coordinates are in the layer's
/// own frame.
struct Layer {
  std::string id;             ///< for messages and files; may be empty or not unique
  std::vector<Curve> curves;  ///< drawing order: where two lie on one edge, the last wins
};

/// A layer painted at one place of the stacking order.
struct LayerInstance {
  std::uint32_t layer = 0;              ///< index into Document::layers
  Affine artboard_from_layer;           ///< invertible
  float opacity = 1;                    ///< of the whole, 0 to 1
  BlendMode blend = BlendMode::normal;  ///< with the colours below
};

/// A local curve painted at one place of the stacking order.
struct LocalStroke {
  LocalCurve curve;             ///< in its own frame
  Affine artboard_from_stroke;  ///< invertible
};

/// Begins a group: the items up to its GroupEnd are composited with each other, then as one onto
/// the rest (an isolated group of CSS compositing).
struct GroupBegin {
  float opacity = 1;                    ///< of the whole, 0 to 1
  BlendMode blend = BlendMode::normal;  ///< with the colours below
};

/// Ends the group that was begun last.
struct GroupEnd {};

/// One item of Document::stack.
using StackItem = std::variant<LayerInstance, LocalStroke, GroupBegin, GroupEnd>;

/// A picture as its author wrote it. Plain data; validate() checks its invariants.
struct Document {
  Box artboard;  ///< the part of the plane that is shown: user units, y down, not empty
  /// The size in pixels that the author wishes for; none: a pixel to a user unit. Kept for callers:
  /// only RasterOptions set the size of an image.
  std::optional<Vec2> size_px{};
  InterpolationSpace interpolation = InterpolationSpace::srgb;  ///< the space for mixing colours
  std::optional<Rgb> background;  ///< behind all items; none: transparent
  std::vector<Shader> shaders;    ///< the sides of curves refer to them by index
  std::vector<Layer> layers;      ///< in any order; `stack` says which are painted, and where
  std::vector<StackItem> stack;   ///< bottom first; groups nest and are closed
};

/// @name Memory of parts of a document
/// @{

/// Returns roughly the bytes of memory that the object's vectors take, without the object itself.
/// Readers charge these to the Budget only while they read; a caller who keeps a document may
/// charge them again.
std::size_t bytes_of(const Document& document);
std::size_t bytes_of(const Curve& curve);
std::size_t bytes_of(const LocalCurve& curve);
std::size_t bytes_of(const std::vector<StackItem>& stack);
std::size_t bytes_of(const std::vector<Shader>& shaders);
/// @}

/// Checks every invariant of the model: sizes against the context's limits, finite numbers in
/// range, indices, 3 n + 1 control points, sorted stop lists. Readers do it last; diffuse(), lint()
/// and write_svg() do it first. Errors: bad_input, limit, cancelled. Cost: O(size of the document).
Status validate(const Context& context, const Document& document);

/// @name Parts that a Picture takes over from a Document
/// @{

/// Checks only the invariants of this part. Errors: bad_input, limit, cancelled.
Status validate(const Context& context, const std::vector<Shader>& shaders);
Status validate(const Context& context, const LocalStroke& stroke);
/// @}

}  // namespace sfumato
