#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/table_memory.hpp"
#include "curves/bezier.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/base/vec2.hpp"

namespace sfumato::svg_import {

/// A chord of a flattened contour. Chords of a contour are consecutive.
struct Chord {
  Vec2 from;
  Vec2 to;
  double begin = 0;  ///< parameter of the contour, piece + t, at `from`
  double end = 0;
  std::uint32_t contour = 0;
};

/// Returns how many times the contours wind around a point, clockwise as seen on the screen;
/// O(chords).
int winding_number(const std::vector<Chord>& chords, Vec2 point);

/// Appends the stretch of a chain of cubics (3 n + 1 points) between two parameters, begin < end,
/// to an empty list. Errors: limit (memory), cancelled.
Status append_stretch(Context& context, const std::vector<Vec2>& chain, double begin, double end,
                      TableMemory& memory, std::vector<Vec2>& points);

/// Returns the number of chords that keep within the tolerance, 1 to 64.
int chord_count(const curves::Cubic& cubic, double tolerance);

/// Calls visit(end) for chords of a chain of cubics that keep within the tolerance.
template <class Visit>
void for_each_chord_end(const std::vector<Vec2>& chain, double tolerance, Visit visit) {
  for (std::size_t i = 0; 3 * i + 3 < chain.size(); ++i) {
    const curves::Cubic cubic = curves::piece(chain, i);
    const int count = chord_count(cubic, tolerance);
    for (int k = 1; k <= count; ++k) visit(curves::point_at(cubic, double{1} * k / count));
  }
}

/// Returns the parameter between `low` and `high` where a curve is beside a point: neither ahead of
/// the point nor behind it, along the chord between the two. Halves the interval, because Newton's
/// method may leave it where the curve stops.
double parameter_beside(const curves::Cubic& cubic, double low, double high, Vec2 point);

}  // namespace sfumato::svg_import
