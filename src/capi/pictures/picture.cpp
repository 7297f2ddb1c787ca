#include "capi/pictures/picture.hpp"

#include "capi/pictures/view.hpp"

namespace sfumato::capi {
namespace {

sfumato_view view_of_nodes(const PatchField& field) {
  return view_of(field.triangle_node, kNodesPerTriangle, SFUMATO_U32, sizeof(std::uint32_t));
}

sfumato_view view_of_values(const PatchField& field) {
  return view_of(field.node_value, static_cast<std::uint32_t>(field.channel_count), SFUMATO_F32,
                 sizeof(float));
}

/// Returns the layer; null if there is none.
const PatchLayer* find_layer(const sfumato_picture* handle, std::uint32_t layer) {
  if (!handle || layer >= handle->picture().layers.size()) return nullptr;
  return &handle->picture().layers[layer];
}

double statistic(const sfumato_picture& picture, std::uint32_t which) {
  const DiffuseStats& stats = picture.stats;
  switch (which) {
    case SFUMATO_CURVES:
      return static_cast<double>(stats.curves);
    case SFUMATO_SEGMENTS:
      return static_cast<double>(stats.segments);
    case SFUMATO_SOLVED_TRIANGLES:
      return static_cast<double>(stats.triangles);
    case SFUMATO_SOLVED_VERTICES:
      return static_cast<double>(stats.vertices);
    case SFUMATO_NODES:
      return static_cast<double>(stats.nodes);
    case SFUMATO_GEOMETRY_SECONDS:
      return stats.geometry_seconds;
    case SFUMATO_TRIANGULATION_SECONDS:
      return stats.triangulation_seconds;
    case SFUMATO_GATHER_SECONDS:
      return stats.gather_seconds;
    case SFUMATO_WAITING_NODES:
      return static_cast<double>(picture.solution ? picture.solution->waiting_nodes() : 0);
    case SFUMATO_KEPT_LAYERS:
      return static_cast<double>(picture.frame.kept);
    case SFUMATO_CONTINUED_LAYERS:
      return static_cast<double>(picture.frame.continued);
    case SFUMATO_BEGUN_LAYERS:
      return static_cast<double>(picture.frame.begun);
    default:
      return 0;
  }
}

}  // namespace

sfumato_view table_of(const PatchLayer& layer, std::uint32_t table) {
  switch (table) {
    case SFUMATO_VERTICES:
      return view_of(layer.vertex_position, 2, SFUMATO_F64, sizeof(double));
    case SFUMATO_TRIANGLES:
      return view_of(layer.triangle_vertex, 3, SFUMATO_U32, sizeof(std::uint32_t));
    case SFUMATO_CURVE_EDGES:
      return view_of(layer.edge_is_curve, 3, SFUMATO_U8, sizeof(std::uint8_t));
    case SFUMATO_COLOR_NODES:
      return view_of_nodes(layer.color);
    case SFUMATO_COLOR_VALUES:
      return view_of_values(layer.color);
    case SFUMATO_OPACITY_NODES:
      return view_of_nodes(layer.opacity);
    case SFUMATO_OPACITY_VALUES:
      return view_of_values(layer.opacity);
    default:
      return {};
  }
}

}  // namespace sfumato::capi

int32_t sfumato_picture_viewport(const sfumato_picture* picture, double box[4]) {
  if (!picture || !box) return SFUMATO_BAD_USAGE;
  sfumato::capi::write_box(picture->picture().viewport, box);
  return SFUMATO_OK;
}

uint32_t sfumato_picture_layer_count(const sfumato_picture* picture) {
  return picture ? static_cast<uint32_t>(picture->picture().layers.size()) : 0;
}

int32_t sfumato_picture_table(const sfumato_picture* picture, uint32_t layer, uint32_t table,
                              sfumato_view* view) {
  if (view) *view = {};
  const sfumato::PatchLayer* found = sfumato::capi::find_layer(picture, layer);
  if (!found || !view || table > SFUMATO_OPACITY_VALUES) return SFUMATO_BAD_USAGE;
  *view = sfumato::capi::table_of(*found, table);
  return SFUMATO_OK;
}

int32_t sfumato_picture_changes(const sfumato_picture* picture, uint32_t layer, uint32_t table,
                                sfumato_view* view) {
  if (view) *view = {};
  if (!picture || !view || layer >= picture->changed.size() ||
      table >= picture->changed[layer].size()) {
    return SFUMATO_BAD_USAGE;
  }
  const sfumato::capi::RowRanges& ranges = picture->changed[layer][table];
  *view = {ranges.empty() ? nullptr : ranges.data(), ranges.size(), sizeof ranges[0], 2,
           SFUMATO_U32};
  return SFUMATO_OK;
}

double sfumato_picture_statistic(const sfumato_picture* picture, uint32_t statistic) {
  return picture ? sfumato::capi::statistic(*picture, statistic) : 0;
}
