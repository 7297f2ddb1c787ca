#pragma once

#include <cstdint>

namespace sfumato::gather {

enum class Method : std::uint8_t { exact, rays };

struct GatherOptions {
  Method method = Method::exact;
  int rays_per_node = 64;  ///< Method::rays: at most limits::kRays
  std::uint64_t seed = 0;
};

/// What is seen ahead of the free end of an open curve (docs/mathematics.md).
enum class Ends : std::uint8_t {
  soft,   ///< the two sides' colours turn into each other round the end
  paper,  ///< the paper's integral alone: a sliver, ever thinner towards the end
};

}  // namespace sfumato::gather
