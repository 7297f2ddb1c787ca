#include "picture/picture_counts.hpp"

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

}  // namespace sfumato::picture
