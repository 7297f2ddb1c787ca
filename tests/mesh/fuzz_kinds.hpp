#pragma once

#include <cstdint>

#include "curves/flatten.hpp"
#include "mesh/mesher.hpp"

namespace sfumato::mesh::test {

/// Hard inputs for the mesher, on an artboard of 1024 units; each seed is another scene.
enum class FuzzKind : std::uint8_t {
  fans,         ///< curves that leave one point at 1 to 5 degrees from each other
  crossings,    ///< long random curves
  near_ends,    ///< chains whose joints miss by 1e-9 to 0.3 units
  near_copies,  ///< duplicates: exact, reversed, partial, offset by 1e-13 to 0.3 units
  tangents,     ///< curves that touch in one point, and curves that begin there
  specks,       ///< curves smaller than the weld, and curves folded back on themselves
  along_frame   ///< curves on and beside the frame
};
inline constexpr int kFuzzKindCount = 7;

curves::FlatCurves fuzz_scene(FuzzKind kind, std::uint64_t seed);

inline constexpr double kFuzzSide = 1024;

inline MeshOptions fuzz_options() {
  MeshOptions options;
  options.frame = {{0, 0}, {kFuzzSide, kFuzzSide}};
  return options;
}

}  // namespace sfumato::mesh::test
