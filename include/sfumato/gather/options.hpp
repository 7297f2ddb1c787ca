#pragma once

#include <cstdint>

/// How the colour at a point is found from the curves that are visible from it.
namespace sfumato::gather {

/// How the integral over the directions around a point is computed.
enum class Method : std::uint8_t {
  exact,  ///< in closed form over the exact visible set: without noise, and faster
  rays    ///< by jittered random rays, as in the paper: for comparisons
};

/// Options of a gather.
struct GatherOptions {
  Method method = Method::exact;  ///< DiffuseOptions::gather and diffuse() have more on rays
  int rays_per_node = 64;         ///< from 1 to limits::kRays; counts for Method::rays
  std::uint64_t seed = 0;         ///< of Method::rays: the same seed gives the same rays

  /// Exact comparison of all members.
  friend bool operator==(const GatherOptions&, const GatherOptions&) = default;
};

/// What the picture shows ahead of the free end of an open curve (docs/mathematics.md, "Free
/// ends").
enum class Ends : std::uint8_t {
  soft,   ///< the colours of the two sides blend into each other around the end
  paper,  ///< the paper's integral alone: a jump from one to the other along a thin sliver
};

}  // namespace sfumato::gather
