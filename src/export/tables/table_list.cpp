#include "export/tables/table_list.hpp"

#include <array>
#include <limits>
#include <variant>

#include "base/poll.hpp"
#include "base/try.hpp"
#include "document/names.hpp"
#include "export/poll_interval.hpp"
#include "picture/patch.hpp"

namespace sfumato::outputs {
namespace {

std::size_t node_count(const PatchField& field) {
  return field.channel_count == 0
             ? 0
             : field.node_value.size() / static_cast<std::size_t>(field.channel_count);
}

Status list_soft_edges(const Context& context, const PatchLayer& layer, LayerTables& made) {
  const std::size_t count = layer.soft_edge.size();
  SFUMATO_TRY(made.memory.reserve(context, made.soft_edge_side, 2 * count));
  SFUMATO_TRY(made.memory.reserve(context, made.soft_edge_reach, 2 * count));
  SFUMATO_TRY(made.memory.reserve(context, made.soft_edge_contrast, count));
  RarePoll<kWritesPerPoll> poll(context);
  for (const SoftEdge& edge : layer.soft_edge) {
    if (poll.cancelled()) return context.cancel_status();
    made.soft_edge_side.insert(made.soft_edge_side.end(), {edge.front, edge.back});
    made.soft_edge_reach.insert(made.soft_edge_reach.end(), {edge.reach[0], edge.reach[1]});
    made.soft_edge_contrast.push_back(edge.contrast);
  }
  return ok_status();
}

void add_field(const PatchField& field, const std::vector<Vec2>& position,
               const std::array<std::string_view, 4>& names, std::vector<Table>& tables) {
  if (field.channel_count == 0) return;
  tables.push_back(table_of(names[0], kNodesPerTriangle, field.triangle_node));
  tables.push_back(table_of(names[1], 2, position));
  tables.push_back(
      table_of(names[2], static_cast<std::size_t>(field.channel_count), field.node_value));
  tables.push_back(table_of(names[3], 1, field.shader));
}

}  // namespace

Status find_node_positions(const Context& context, const PatchLayer& layer, const PatchField& field,
                           TableMemory& memory, std::vector<Vec2>& position) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  Status status = memory.resize(context, position, node_count(field), Vec2{kUnknown, kUnknown});
  if (!status || field.channel_count == 0) return status;
  RarePoll<kWritesPerPoll> poll(context);
  for (std::size_t t = 0; t < layer.triangle_count(); ++t) {
    if (poll.cancelled()) return context.cancel_status();
    for (std::size_t place = 0; place < kNodesPerTriangle; ++place) {
      Vec2 sum{0, 0};
      for (std::size_t k = 0; k < 3; ++k) {
        const double weight = kNodeBarycentric[place][k];
        if (weight != 0)
          sum = sum + layer.vertex_position[layer.triangle_vertex[3 * t + k]] * weight;
      }
      position[field.triangle_node[node_slot(t, place)]] = sum;
    }
  }
  return ok_status();
}

Result<LayerTables> list_tables(const Context& context, const PatchLayer& layer) {
  LayerTables made;
  SFUMATO_TRY(find_node_positions(context, layer, layer.color, made.memory, made.color_position));
  SFUMATO_TRY(
      find_node_positions(context, layer, layer.opacity, made.memory, made.opacity_position));
  SFUMATO_TRY(list_soft_edges(context, layer, made));
  made.tables = {table_of("vertices", 2, layer.vertex_position),
                 table_of("triangles", 3, layer.triangle_vertex),
                 table_of("curve_edges", 3, layer.edge_is_curve)};
  add_field(layer.color, made.color_position,
            {"color_nodes", "color_positions", "color_values", "color_shaders"}, made.tables);
  add_field(layer.opacity, made.opacity_position,
            {"opacity_nodes", "opacity_positions", "opacity_values", "opacity_shaders"},
            made.tables);
  made.tables.push_back(table_of("soft_edge_sides", 2, made.soft_edge_side));
  made.tables.push_back(table_of("soft_edge_reach", 4, made.soft_edge_reach));
  made.tables.push_back(table_of("soft_edge_contrast", 1, made.soft_edge_contrast));
  return made;
}

Result<InstanceTables> list_instances(const Context& context, const Picture& picture) {
  InstanceTables made;
  RarePoll<kWritesPerPoll> poll(context);
  for (const PictureItem& item : picture.stack) {
    if (poll.cancelled()) return context.cancel_status();
    const auto* instance = std::get_if<PatchInstance>(&item);
    if (!instance) continue;
    const Affine& m = instance->artboard_from_layer;
    SFUMATO_TRY(made.memory.make_room(context, made.row, kInstanceColumns));
    SFUMATO_TRY(made.memory.push_back(context, made.blend, blend_name(instance->blend)));
    made.row.insert(made.row.end(), {static_cast<double>(instance->layer), m.a, m.b, m.c, m.d, m.e,
                                     m.f, static_cast<double>(instance->opacity)});
  }
  return made;
}

void note_omissions(const Picture& picture, ExportNotes* notes) {
  if (!notes) return;
  bool has_strokes = false, has_groups = false;
  for (const PictureItem& item : picture.stack) {
    has_strokes |= std::holds_alternative<LocalStroke>(item);
    has_groups |= std::holds_alternative<GroupBegin>(item);
  }
  if (has_strokes) notes->lost.push_back("local curves have no mesh and are left out");
  if (has_groups) notes->lost.push_back("groups are left out, their items are not");
  if (!picture.shaders.empty()) {
    notes->lost.push_back("of textures and gradients the weights alone are stored");
  }
  for (const PatchLayer& layer : picture.layers) notes->triangle_count += layer.triangle_count();
}

}  // namespace sfumato::outputs
