#pragma once

#include <cstdint>
#include <vector>

#include "sfumato/base/vec2.hpp"

namespace sfumato::svg_import {

/// A chord of a flattened contour. Chords of a contour follow one another.
struct Chord {
  Vec2 from;
  Vec2 to;
  double begin = 0;  ///< parameter of the contour, piece + t, at `from`
  double end = 0;
  std::uint32_t contour = 0;
};

/// How often the contours go round a point, clockwise as seen on the screen; O(chords).
int winding_number(const std::vector<Chord>& chords, Vec2 point);

/// The stretch of a chain of cubics (3 n + 1 points) between two parameters, begin < end.
std::vector<Vec2> stretch(const std::vector<Vec2>& chain, double begin, double end);

}  // namespace sfumato::svg_import
