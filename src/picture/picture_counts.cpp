#include "picture/picture_counts.hpp"

#include "picture/point_fields.hpp"

namespace sfumato::picture {

PictureCounts count_tables(const Picture& picture) {
  PictureCounts counts;
  for (const PatchLayer& layer : picture.layers) {
    counts.triangles += layer.triangle_count();
    counts.vertices += layer.vertex_position.size();
    for (const PatchField* field : {&layer.color, &layer.opacity}) {
      if (field->channel_count == 0) continue;
      counts.nodes += field->node_value.size() / static_cast<std::size_t>(field->channel_count);
    }
  }
  return counts;
}

std::uint64_t count_read_points(const Picture& picture) {
  std::uint64_t count = 0;
  for (const PatchLayer& layer : picture.layers)
    if (layer.exact_points) count += layer.exact_points->read_count();
  return count;
}

}  // namespace sfumato::picture
