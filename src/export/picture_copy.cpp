#include "export/picture_copy.hpp"

#include <utility>

#include "base/charge.hpp"
#include "base/large_vector.hpp"

namespace sfumato::outputs {
namespace {

Status copy_field(const Context& context, const PatchField& from, PatchField& to) {
  to.channel_count = from.channel_count;
  to.shader = from.shader;
  Status status = copy_large(context, from.triangle_node, to.triangle_node);
  return status ? copy_large(context, from.node_value, to.node_value) : status;
}

Status copy_texture(Context& context, const Texture& from, ScopedCharge* charge, Texture& to) {
  Status status = charge->add(context, from.rgba.size(), "a texture");
  if (!status) return status;
  to.width = from.width;
  to.height = from.height;
  to.layer_from_texture = from.layer_from_texture;
  to.repeats = from.repeats;
  to.period = from.period;
  return copy_large(context, from.rgba, to.rgba);
}

}  // namespace

Status copy_layer(Context& context, const PatchLayer& layer, ScopedCharge* charge,
                  std::vector<PatchLayer>* to) {
  Status status = charge->add(context, bytes_of(layer), "a layer to be painted");
  if (!status) return status;
  PatchLayer& copy = to->emplace_back();
  copy.frame = layer.frame;
  copy.order = layer.order;
  status = copy_large(context, layer.vertex_position, copy.vertex_position);
  if (status) status = copy_large(context, layer.triangle_vertex, copy.triangle_vertex);
  if (status) status = copy_large(context, layer.edge_is_curve, copy.edge_is_curve);
  if (status) status = copy_large(context, layer.soft_edge, copy.soft_edge);
  if (status) status = copy_field(context, layer.color, copy.color);
  return status ? copy_field(context, layer.opacity, copy.opacity) : status;
}

Status copy_shaders(Context& context, std::span<const Shader> shaders, ScopedCharge* charge,
                    std::vector<Shader>* to) {
  for (const Shader& shader : shaders) {
    Shader& copy = to->emplace_back();
    copy.id = shader.id;
    if (const auto* texture = std::get_if<Texture>(&shader.paint)) {
      Status status = copy_texture(context, *texture, charge, copy.paint.emplace<Texture>());
      if (!status) return status;
    } else {
      copy.paint = shader.paint;
    }
  }
  return ok_status();
}

}  // namespace sfumato::outputs
