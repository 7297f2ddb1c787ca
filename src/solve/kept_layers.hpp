#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace sfumato::solve {

/// A layer of which what drags begin from is kept.
struct KeptLayer {
  std::uint32_t index = 0;         ///< the caller's
  std::uint64_t last_drag = 0;     ///< the larger the later; 0: it has seen none
  std::size_t triangle_count = 0;  ///< memory grows with it
};

/// The indices of those to be given up so that the others have no more triangles than that: first
/// those that were dragged longest ago or never, and of these the smallest, which are soon solved
/// again. The one that was dragged last stays in any case.
std::vector<std::uint32_t> layers_beyond(std::vector<KeptLayer> layers, std::size_t most_triangles);

}  // namespace sfumato::solve
