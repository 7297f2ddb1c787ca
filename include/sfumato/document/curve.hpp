#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "sfumato/base/vec2.hpp"
#include "sfumato/document/stops.hpp"

namespace sfumato {

/// How a side of a curve handles the rays of one attribute (docs/mathematics.md).
enum class ShaderKind : std::uint8_t {
  open,          ///< has no shader: rays pass through
  barrier,       ///< ends rays and gives no value
  curve_domain,  ///< gives the value of a stop list at the hit point
  image_domain   ///< gives the value of Document::shaders[shader] at the shaded point
};

/// One attribute, colour or opacity, on one side of a curve.
template <class Value>
struct SideShader {
  ShaderKind kind = ShaderKind::open;  ///< selects the members that count
  StopList<Value> stops{};             ///< not empty exactly where kind is curve_domain
  std::uint32_t shader = 0;            ///< index into Document::shaders where kind is image_domain

  /// Compares all members exactly.
  friend bool operator==(const SideShader&, const SideShader&) = default;
};

/// One side of a diffusion curve. Colour and opacity are independent: a side may have either, both
/// or none (paper section 5).
struct Side {
  SideShader<Rgb> color{};      ///< sRGB code values from 0 to 1
  SideShader<float> opacity{};  ///< values from 0 to 1
  /// The distance from the curve, in user units of the layer, over which the jump to the other side
  /// is smoothed. At least 0; empty: 0 everywhere.
  ScalarStops blur_radius{};

  /// Compares all members exactly.
  friend bool operator==(const Side&, const Side&) = default;
};

/// A diffusion curve: a chain of cubic Béziers with shaders on both sides. It is closed where its
/// last control point equals the first.
struct Curve {
  std::string id{};                    ///< for messages and files; may be empty or not unique
  std::vector<Vec2> control_points{};  ///< 3 n + 1 points for n ≥ 1 pieces; layer frame
  Side left{};        ///< to the left of the walking direction, as seen on the screen: left_of()
  Side right{};       ///< the opposite side
  double weight = 1;  ///< k of the integral, above 0: the weight beside other curves

  /// Returns the number of Bézier pieces.
  std::size_t piece_count() const {
    return control_points.empty() ? 0 : (control_points.size() - 1) / 3;
  }

  /// Compares all members exactly.
  friend bool operator==(const Curve&, const Curve&) = default;
};

/// A local curve: a painted stroke whose influence ends at a radius (paper section 5, equations
/// 12–16). A side without colours takes the colours of the other side; without any colour nothing
/// is painted.
struct LocalCurve {
  std::string id{};                    ///< as Curve::id
  std::vector<Vec2> control_points{};  ///< 3 n + 1 points for n ≥ 1 pieces; the stroke's frame
  ColorStops left_color;               ///< to the left, as Curve::left
  ColorStops right_color;              ///< to the right
  ScalarStops blur_radius{};           ///< R(t), at least 0, units of that frame; empty: 0
  ScalarStops influence_radius;        ///< Q(t), at least 0, above 0 somewhere, the same units
  double alpha = 1;  ///< factor of the opacity, at least 0; above 1 the solid core is wider

  /// Compares all members exactly.
  friend bool operator==(const LocalCurve&, const LocalCurve&) = default;
};

}  // namespace sfumato
