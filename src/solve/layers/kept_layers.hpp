#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace sfumato::solve {

/// A layer whose tables for drags are kept.
struct KeptLayer {
  std::uint32_t index = 0;         ///< chosen by the caller
  std::uint64_t last_drag = 0;     ///< larger is later; 0: never dragged
  std::size_t triangle_count = 0;  ///< a measure of its memory
};

/// Returns the indices of the layers to release, so that the other layers have at most
/// `most_triangles` triangles. Considers the layers in the order of their last drags, the latest
/// first. Layers without a drag follow, the largest first, since small layers are solved again
/// quickly. Keeps each layer that still fits. Always keeps the layer that was dragged last.
std::vector<std::uint32_t> layers_beyond(std::vector<KeptLayer> layers, std::size_t most_triangles);

}  // namespace sfumato::solve
