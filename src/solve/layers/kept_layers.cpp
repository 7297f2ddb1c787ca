#include "solve/layers/kept_layers.hpp"

#include <algorithm>
#include <tuple>

namespace sfumato::solve {

std::vector<std::uint32_t> layers_beyond(std::vector<KeptLayer> layers,
                                         std::size_t most_triangles) {
  std::ranges::sort(layers, [](const KeptLayer& a, const KeptLayer& b) {
    return std::tie(b.last_drag, b.triangle_count, a.index) <
           std::tie(a.last_drag, a.triangle_count, b.index);
  });
  std::vector<std::uint32_t> beyond;
  std::size_t triangles = 0;
  for (const KeptLayer& layer : layers) {
    const bool is_last_dragged = layer.last_drag > 0 && beyond.empty() && triangles == 0;
    if (is_last_dragged || triangles + layer.triangle_count <= most_triangles) {
      triangles += layer.triangle_count;
    } else {
      beyond.push_back(layer.index);
    }
  }
  return beyond;
}

}  // namespace sfumato::solve
