#include "raster/layers/layer_view.hpp"

#include "picture/check_picture.hpp"
#include "raster/options.hpp"

namespace sfumato::raster {
namespace {

static_assert(picture::kLargestImageSide == RasterWindow::kLargestSide);

bool drawable(const Box& box) {
  return is_finite(box.min) && is_finite(box.max) && box.width() > 0 && box.height() > 0;
}

FieldView view_field(const PatchField& field) {
  return {field.triangle_node.data(), field.node_value.data(), field.channel_count,
          field.shader.data(), static_cast<int>(field.shader.size())};
}

}  // namespace

Result<Affine> image_from_artboard(const Picture& picture, const RasterOptions& options) {
  const TileGrid grid = grid_of(options);
  const Box viewport = options.viewport.value_or(picture.viewport);
  if (!drawable(viewport))
    return make_error(StatusCode::bad_input, "an empty viewport; use a positive size");
  const double x_scale = grid.width / viewport.width();
  const double y_scale = grid.height / viewport.height();
  const Affine map{x_scale, 0, 0, y_scale, -viewport.min.x * x_scale, -viewport.min.y * y_scale};
  if (!picture::is_moderate(map))
    return make_error(StatusCode::bad_input, "a viewport too small or too far away to be drawn");
  return map;
}

LayerView view_instance(const Picture& picture, const PatchInstance& instance,
                        const Affine& image_from_artboard) {
  const PatchLayer& layer = picture.layers[instance.layer];
  LayerView view;
  view.index = instance.layer;
  view.vertex_position = layer.vertex_position.data();
  view.triangle_vertex = layer.triangle_vertex.data();
  view.edge_is_curve = layer.edge_is_curve.data();
  view.soft_edge = layer.soft_edge.data();
  view.soft_edge_count = layer.soft_edge.size();
  view.bow = layer.bow.data();
  view.bow_count = layer.bow.size();
  view.color = view_field(layer.color);
  view.opacity = view_field(layer.opacity);
  view.exact = layer.exact_points.get();
  view.frame = layer.frame;
  view.order = layer.order;
  view.image_from_layer = image_from_artboard * instance.artboard_from_layer;
  view.mirrored = view.image_from_layer.determinant() < 0;
  return view;
}

}  // namespace sfumato::raster
