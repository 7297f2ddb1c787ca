#include "raster/layer_view.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace sfumato::raster {
namespace {

/// Pixels per unit, and pixels from the image to the artboard's origin. Beyond, squares of pixel
/// coordinates could overflow.
constexpr double kLargestScale = 1e100;

bool drawable(const Box& box) {
  return is_finite(box.min) && is_finite(box.max) && box.width() > 0 && box.height() > 0;
}

bool all_below(const std::vector<std::uint32_t>& indices, std::size_t bound) {
  return std::all_of(indices.begin(), indices.end(), [&](std::uint32_t i) { return i < bound; });
}

bool is_position(Vec2 p) {
  return std::fabs(p.x) <= limits::kCoordinate && std::fabs(p.y) <= limits::kCoordinate;
}

bool is_moderate(const Affine& m) {
  const double entries[] = {m.a, m.b, m.c, m.d, m.e, m.f};
  return std::all_of(std::begin(entries), std::end(entries),
                     [](double entry) { return std::fabs(entry) <= kLargestScale; });
}

bool is_whole(const PatchLayer& layer) {
  const std::size_t count = layer.triangle_count();
  if (layer.color.channel_count < 3) return false;
  const std::size_t nodes =
      layer.color.node_value.size() / static_cast<std::size_t>(layer.color.channel_count);
  return layer.triangle_vertex.size() == 3 * count && layer.edge_is_curve.size() == 3 * count &&
         layer.color.triangle_node.size() == 10 * count &&
         all_below(layer.triangle_vertex, layer.vertex_position.size()) &&
         all_below(layer.color.triangle_node, nodes) &&
         std::all_of(layer.vertex_position.begin(), layer.vertex_position.end(), is_position);
}

}  // namespace

Status check_picture(const Picture& picture) {
  for (const PatchLayer& layer : picture.layers) {
    if (!is_whole(layer))
      return make_error(StatusCode::bad_input, "a layer of the picture whose tables do not fit");
  }
  for (const PictureItem& item : picture.stack) {
    const auto* instance_item = std::get_if<PatchInstance>(&item);
    if (!instance_item) continue;
    const PatchInstance& instance = *instance_item;
    if (instance.layer >= picture.layers.size())
      return make_error(StatusCode::bad_input, "an instance of a layer that is not there");
    if (!is_moderate(instance.artboard_from_layer))
      return make_error(StatusCode::bad_input, "an instance placed beyond all numbers");
  }
  return ok_status();
}

Result<Affine> image_from_artboard(const Picture& picture, const RasterOptions& options) {
  const Box viewport = options.viewport.value_or(picture.viewport);
  if (!drawable(viewport))
    return make_error(StatusCode::bad_input, "an empty viewport; expected a positive size");
  const double x_scale = options.width / viewport.width();
  const double y_scale = options.height / viewport.height();
  const Affine map{x_scale, 0, 0, y_scale, -viewport.min.x * x_scale, -viewport.min.y * y_scale};
  if (!is_moderate(map))
    return make_error(StatusCode::bad_input, "a viewport too small or too far away to be drawn");
  return map;
}

LayerView view_instance(const Picture& picture, const PatchInstance& instance,
                        const Affine& image_from_artboard) {
  const PatchLayer& layer = picture.layers[instance.layer];
  LayerView view;
  view.vertex_position = layer.vertex_position.data();
  view.triangle_vertex = layer.triangle_vertex.data();
  view.edge_is_curve = layer.edge_is_curve.data();
  view.triangle_node = layer.color.triangle_node.data();
  view.node_value = layer.color.node_value.data();
  view.channel_count = layer.color.channel_count;
  view.order = layer.order;
  view.image_from_layer = image_from_artboard * instance.artboard_from_layer;
  view.mirrored = view.image_from_layer.determinant() < 0;
  return view;
}

}  // namespace sfumato::raster
