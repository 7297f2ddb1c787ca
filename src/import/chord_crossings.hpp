#pragma once

#include <cstdint>
#include <vector>

#include "base/context.hpp"
#include "base/status.hpp"
#include "base/vec2.hpp"

namespace sfumato::svg_import {

/// A chord of a flattened contour. Chords of a contour follow one another.
struct Chord {
  Vec2 from;
  Vec2 to;
  double begin = 0;  ///< parameter of the contour, piece + t, at `from`
  double end = 0;
  std::uint32_t contour = 0;
};

/// Where two chords meet: a fraction of each.
struct Crossing {
  std::uint32_t first = 0;
  std::uint32_t second = 0;
  double at_first = 0;
  double at_second = 0;
};

/// All crossings, but for those of neighbours in their common end and of parallel chords.
/// Errors: limit (too many pairs that lie near each other), cancelled.
/// Cost: O(n log n) and the pairs whose boxes overlap across x.
Result<std::vector<Crossing>> find_crossings(const Context& context,
                                             const std::vector<Chord>& chords);

/// How often the contours go round a point, clockwise as seen on the screen; O(chords).
int winding_number(const std::vector<Chord>& chords, Vec2 point);

}  // namespace sfumato::svg_import
