#include "picture/cover.hpp"

#include "base/boxes.hpp"

namespace sfumato::picture {
namespace {

/// A smaller share of a layer's area shows in no pixel, whatever the size of the image.
constexpr double kNoArea = 1e-10;

/// Returns the box that the layer's triangles fill; empty if they leave a part of their box out.
Box filled_box(const PatchLayer& layer) {
  Box box;
  double area = 0;
  for (std::uint32_t t = 0; t < layer.triangle_count(); ++t) {
    Vec2 corner[3];
    for (std::uint32_t k = 0; k < 3; ++k) {
      corner[k] = layer.vertex_position[layer.triangle_vertex[3 * t + k]];
      box.extend(corner[k]);
    }
    area += 0.5 * cross(corner[1] - corner[0], corner[2] - corner[0]);
  }
  return area >= (1 - kNoArea) * box.width() * box.height() ? box : Box();
}

bool holds(const Box& box, const Box& part) {
  return box.contains(part.min) && box.contains(part.max);
}

bool is_opaque(const Picture& picture, const PatchInstance& instance) {
  const PatchLayer& layer = picture.layers[instance.layer];
  return instance.opacity == 1 && instance.blend == BlendMode::normal &&
         layer.opacity.channel_count == 0 && layer.triangle_count() > 0;
}

}  // namespace

bool covers(const Picture& picture, const Box& box) {
  int depth = 0;
  for (const PictureItem& item : picture.stack) {
    depth += std::holds_alternative<GroupBegin>(item) - std::holds_alternative<GroupEnd>(item);
    const auto* instance = std::get_if<PatchInstance>(&item);
    if (!instance || depth > 0 || !is_opaque(picture, *instance)) continue;
    const PatchLayer& layer = picture.layers[instance->layer];
    const Box shown = mapped_box(inverse(instance->artboard_from_layer), box);
    if (holds(layer.frame, shown) && holds(filled_box(layer), shown)) return true;
  }
  return false;
}

}  // namespace sfumato::picture
