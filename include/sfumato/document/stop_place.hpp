#pragma once

#include <cstdint>
#include <optional>
#include <variant>

#include "sfumato/base/color.hpp"

namespace sfumato {

/// A side of a Curve.
enum class CurveSide : std::uint8_t {
  left,  ///< Curve::left
  right  ///< Curve::right
};

/// An attribute whose values on a side come from stops.
enum class StopAttribute : std::uint8_t {
  color,   ///< Side::color
  opacity  ///< Side::opacity
};

/// A stop of a diffusion curve, or all stops of one of its lists.
struct StopPlace {
  std::uint32_t layer = 0;                         ///< index into Document::layers
  std::uint32_t curve = 0;                         ///< index into Layer::curves
  CurveSide side = CurveSide::left;                ///< of the curve
  StopAttribute attribute = StopAttribute::color;  ///< of the side
  std::optional<std::uint32_t> index{};            ///< into StopList::stops; none: all

  /// Compares all members exactly.
  friend bool operator==(const StopPlace&, const StopPlace&) = default;
};

/// The value of a stop: a colour in sRGB code values, or an opacity, both from 0 to 1.
using StopValue = std::variant<Rgb, float>;

}  // namespace sfumato
