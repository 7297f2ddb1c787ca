#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

namespace sfumato::gather {

/// A weight W in eight bits, to a quarter of an octave: 0 is none, and 1 is unknown or less than
/// 2⁻⁴⁰.
inline constexpr std::uint8_t kUnknownWeight = 1;

/// The highest bits of the number 2⁻⁴⁰: its exponent, and the quarter of the octave.
inline constexpr std::uint32_t kLeastWeightBits = (127 - 40) * 4;

/// weight   finite, at least 0
inline std::uint8_t weight_class(float weight) {
  if (!(weight > 0)) return 0;
  const std::uint32_t bits = std::bit_cast<std::uint32_t>(weight) >> 21;
  const std::uint32_t above = bits - std::min(bits, kLeastWeightBits);
  return static_cast<std::uint8_t>(std::min(above + kUnknownWeight, 255u));
}

/// Returns the least weight of this class.
inline float least_weight(std::uint8_t weight_class) {
  if (weight_class <= kUnknownWeight) return 0;
  return std::bit_cast<float>((kLeastWeightBits + weight_class - kUnknownWeight) << 21);
}

}  // namespace sfumato::gather
