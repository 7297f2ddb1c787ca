#include "export/picture_copy.hpp"

#include "base/try.hpp"

namespace sfumato::outputs {
namespace {

Status copy_field(const Context& context, const PatchField& from, TableMemory& memory,
                  PatchField& to) {
  to.channel_count = from.channel_count;
  to.shader = from.shader;
  Status status = memory.append(context, from.triangle_node, to.triangle_node);
  return status ? memory.append(context, from.node_value, to.node_value) : status;
}

Status copy_texture(const Context& context, const Texture& from, TableMemory& memory, Texture& to) {
  to.width = from.width;
  to.height = from.height;
  to.layer_from_texture = from.layer_from_texture;
  to.repeats = from.repeats;
  to.period = from.period;
  return memory.append(context, from.rgba, to.rgba);
}

}  // namespace

Status copy_layer(const Context& context, const PatchLayer& layer, TableMemory& memory,
                  std::vector<PatchLayer>* to) {
  PatchLayer& copy = to->emplace_back();
  copy.frame = layer.frame;
  copy.order = layer.order;
  Status status = memory.append(context, layer.vertex_position, copy.vertex_position);
  if (status) status = memory.append(context, layer.triangle_vertex, copy.triangle_vertex);
  if (status) status = memory.append(context, layer.edge_is_curve, copy.edge_is_curve);
  if (status) status = memory.append(context, layer.soft_edge, copy.soft_edge);
  if (status) status = copy_field(context, layer.color, memory, copy.color);
  return status ? copy_field(context, layer.opacity, memory, copy.opacity) : status;
}

Status copy_shaders(const Context& context, std::span<const Shader> shaders, TableMemory& memory,
                    std::vector<Shader>* to) {
  for (const Shader& shader : shaders) {
    Shader& copy = to->emplace_back();
    copy.id = shader.id;
    if (const auto* texture = std::get_if<Texture>(&shader.paint)) {
      SFUMATO_TRY(copy_texture(context, *texture, memory, copy.paint.emplace<Texture>()));
    } else {
      copy.paint = shader.paint;
    }
  }
  return ok_status();
}

}  // namespace sfumato::outputs
