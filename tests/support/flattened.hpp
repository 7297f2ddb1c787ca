#pragma once

#include <vector>

#include "import/chords.hpp"

namespace sfumato::test {

/// Returns a chain of cubics as a polygon, within the tolerance.
inline std::vector<Vec2> flattened(const std::vector<Vec2>& chain, double tolerance) {
  std::vector<Vec2> polygon{chain.front()};
  svg_import::for_each_chord_end(chain, tolerance, [&](Vec2 end) { polygon.push_back(end); });
  return polygon;
}

}  // namespace sfumato::test
