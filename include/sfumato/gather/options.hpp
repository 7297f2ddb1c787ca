#pragma once

#include <cstdint>

/// The computation of the colour at a point from the curves that are visible from it.
namespace sfumato::gather {

/// The method for the integral over the directions around a point.
enum class Method : std::uint8_t {
  exact,  ///< in closed form over the exact visible set: without noise, and faster
  rays    ///< by jittered random rays, as in the paper: use it for comparisons
};

/// Options of a gather.
struct GatherOptions {
  Method method = Method::exact;  ///< DiffuseOptions::gather and diffuse() explain rays
  int rays_per_node = 64;         ///< from 1 to limits::kRays; counts for Method::rays
  std::uint64_t seed = 0;         ///< for Method::rays: the same seed gives the same rays

  /// Compares all members exactly.
  friend bool operator==(const GatherOptions&, const GatherOptions&) = default;
};

/// The colours ahead of the free end of an open curve (docs/mathematics.md, "Free ends").
enum class Ends : std::uint8_t {
  soft,   ///< the colours of the two sides blend into each other around the end
  paper,  ///< only the paper's integral: a jump from one to the other along a thin sliver
};

}  // namespace sfumato::gather
