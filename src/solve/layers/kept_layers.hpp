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

/// The indices of those to be given up so that the others have no more triangles than that. They
/// are asked in the order of their last drags, the latest first, and of those without one the
/// largest first, since small ones are soon solved again: each stays for which there is room left,
/// and the one that was dragged last in any case.
std::vector<std::uint32_t> layers_beyond(std::vector<KeptLayer> layers, std::size_t most_triangles);

}  // namespace sfumato::solve
