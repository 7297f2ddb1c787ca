#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "sfumato/base/vec2.hpp"
#include "sfumato/document/stops.hpp"

namespace sfumato {

/// What a side of a curve does to the rays of one attribute (docs/mathematics.md).
enum class ShaderKind : std::uint8_t {
  open,          ///< bears no shader: rays pass through
  barrier,       ///< stops rays and gives nothing
  curve_domain,  ///< gives the value of a stop list at the hit point
  image_domain   ///< gives the value of Document::shaders[shader] at the shaded point
};

template <class Value>
struct SideShader {
  ShaderKind kind = ShaderKind::open;
  StopList<Value> stops{};   ///< not empty exactly where kind is curve_domain
  std::uint32_t shader = 0;  ///< index into Document::shaders where kind is image_domain

  friend bool operator==(const SideShader&, const SideShader&) = default;
};

/// One side of a diffusion curve. Colour and opacity are decoupled (paper section 5).
struct Side {
  SideShader<Rgb> color{};
  SideShader<float> opacity{};  ///< values 0 to 1
  ScalarStops blur_radius{};    ///< user units, at least 0; empty: 0 everywhere

  friend bool operator==(const Side&, const Side&) = default;
};

/// A chain of cubic Béziers with shaders on both sides.
/// Left is left of the walking direction as seen on the screen.
struct Curve {
  std::string id{};
  std::vector<Vec2> control_points{};  ///< 3 n + 1 points for n ≥ 1 pieces
  Side left{};
  Side right{};
  double weight = 1;  ///< k of the integral, above 0

  std::size_t piece_count() const {
    return control_points.empty() ? 0 : (control_points.size() - 1) / 3;
  }

  friend bool operator==(const Curve&, const Curve&) = default;
};

/// A painted stroke with local influence (paper section 5, eq. 12–16).
struct LocalCurve {
  std::string id{};
  std::vector<Vec2> control_points{};  ///< as Curve
  ColorStops left_color;
  ColorStops right_color;
  ScalarStops blur_radius{};     ///< R(t), user units
  ScalarStops influence_radius;  ///< Q(t), user units, above 0 somewhere
  double alpha = 1;              ///< scale of opacity

  friend bool operator==(const LocalCurve&, const LocalCurve&) = default;
};

}  // namespace sfumato
