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

enum class BlendMode : std::uint8_t {
  normal,
  multiply,
  screen,
  overlay,
  darken,
  lighten,
  color_dodge,
  color_burn,
  hard_light,
  soft_light,
  difference,
  exclusion,
  hue,
  saturation,
  color,
  luminosity
};

/// Curves that are solved together: one mesh, one solution. Frame: the layer's own.
struct Layer {
  std::string id;
  std::vector<Curve> curves;  ///< drawing order: where two lie on one edge, the last wins
};

/// A layer painted at one place of the stacking order.
struct LayerInstance {
  std::uint32_t layer = 0;  ///< index into Document::layers
  Affine artboard_from_layer;
  float opacity = 1;
  BlendMode blend = BlendMode::normal;
};

/// A local curve painted at one place of the stacking order.
struct LocalStroke {
  LocalCurve curve;
  Affine artboard_from_stroke;
};

/// What stands between this and its GroupEnd is composited by itself, then as one onto the rest
/// (an isolated group, as CSS compositing has it).
struct GroupBegin {
  float opacity = 1;
  BlendMode blend = BlendMode::normal;
};

struct GroupEnd {};

using StackItem = std::variant<LayerInstance, LocalStroke, GroupBegin, GroupEnd>;

/// A picture as its author wrote it. Plain data; `validate` states the invariants.
struct Document {
  Box artboard;  ///< user units, y down
  /// Of the picture where nothing else is asked for; none: a pixel to a user unit.
  std::optional<Vec2> size_px{};
  InterpolationSpace interpolation = InterpolationSpace::srgb;
  std::optional<Rgb> background;
  std::vector<Shader> shaders;
  std::vector<Layer> layers;
  std::vector<StackItem> stack;  ///< bottom first; groups nest and are closed
};

/// About what it takes in memory. Readers charge it only while they read: who holds a document may
/// charge it again.
std::size_t bytes_of(const Document& document);
std::size_t bytes_of(const LocalCurve& curve);  ///< beside the object itself
std::size_t bytes_of(const std::vector<Shader>& shaders);

/// Checks every invariant of the model: sizes against the context's limits, finite numbers in
/// range, indices, 3n+1 control points, stop lists that are sorted. Readers call it last; `diffuse`
/// relies on it. Errors: bad_input, limit, cancelled.
Status validate(const Context& context, const Document& document);

/// The same for what pictures take over from documents.
Status validate(const Context& context, const std::vector<Shader>& shaders);
Status validate(const Context& context, const LocalStroke& stroke);

}  // namespace sfumato
