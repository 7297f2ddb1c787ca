#pragma once

#include <cstddef>
#include <cstdint>

#include "base/inline.hpp"

namespace sfumato::gather {

/// Directions of a far field, counter-clockwise from +x.
inline constexpr int kFarDirections = 16;

/// Levels of a far field at most: 512 of the smallest squares in a row.
inline constexpr int kFarLevels = 10;

/// The numbers of a far field, per length that a ray travels: curves that it meets, their weight,
/// their weight times their value; after that, for each image-domain shader the weight of the sides
/// that have it.
inline constexpr int kFarOpacity = 0;
inline constexpr int kFarWeight = 1;
inline constexpr int kFarValue = 2;

/// Means over squares of the curves that rays meet in each of the directions. The squares of a
/// level tile the field; the squares of the next level are twice as large, and the last level is
/// one square.
struct FarField {
  const float* mean = nullptr;  ///< null: there is none
  float x0 = 0, y0 = 0;         ///< the field's corner
  float cells_per_unit = 1;     ///< of the smallest squares
  int side = 1;                 ///< of these in a row: a power of two
  int level_count = 1;
  int first[kFarLevels] = {};  ///< per level: squares before its own in `mean`
  int numbers = 0;             ///< for each direction of a square
  float nearest = 0;           ///< the field does not count curves nearer to a point than this
};

/// tan(π/16) and tan(3π/16): the borders of directions.
inline constexpr float kFirstBorder = 0.198912367f;
inline constexpr float kSecondBorder = 0.668178638f;

/// Returns the nearest of the directions. Precondition: not (0, 0).
SFUMATO_INLINE int far_direction(float x, float y) {
  const float across = x < 0 ? -x : x, up = y < 0 ? -y : y;
  const bool is_steep = up > across;
  const float longer = is_steep ? up : across, shorter = is_steep ? across : up;
  // Without branches, which could not be predicted.
  int direction = (shorter > kFirstBorder * longer) + (shorter > kSecondBorder * longer);
  direction += is_steep * (kFarDirections / 4 - 2 * direction);
  direction += (x < 0) * (kFarDirections / 2 - 2 * direction);
  direction += (y < 0) * (kFarDirections - 2 * direction);
  return direction % kFarDirections;
}

/// The size of a square relative to the window that it represents.
inline constexpr float kFarCellShare = 1.5f;

/// Returns the numbers around (x, y), seen in a direction from this distance, or null outside the
/// field.
SFUMATO_INLINE const float* far_mean(const FarField& far, float x, float y, int direction,
                                     float distance) {
  // The level by the exponent of how many of the smallest squares a side would have.
  const float cells = kFarCellShare * distance * far.cells_per_unit;
  const int exponent = static_cast<int>(__builtin_bit_cast(std::uint32_t, cells) >> 23) - 127;
  const int coarser = exponent < 0 ? 0 : exponent;
  const int level = coarser < far.level_count ? coarser : far.level_count - 1;
  const int side = far.side >> level;
  const float cells_per_unit = far.cells_per_unit / static_cast<float>(1 << level);
  const float column = (x - far.x0) * cells_per_unit, row = (y - far.y0) * cells_per_unit;
  const auto end = static_cast<float>(side);
  if (!(column >= 0 && row >= 0 && column < end && row < end)) return nullptr;
  const int square = far.first[level] + static_cast<int>(row) * side + static_cast<int>(column);
  return far.mean + static_cast<std::size_t>(square * kFarDirections + direction) *
                        static_cast<std::size_t>(far.numbers);
}

}  // namespace sfumato::gather
