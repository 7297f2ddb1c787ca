#include "solve/points/exact_fields.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "base/charge.hpp"
#include "base/poll.hpp"
#include "base/try.hpp"
#include "gather/ends/free_ends.hpp"
#include "gather/scene/scene.hpp"
#include "mesh/mesher.hpp"
#include "solve/layers/layer_units.hpp"

namespace sfumato::solve {
namespace {

RayEdge edge_of(const mesh::TriangleMesh& mesh, std::uint32_t h, const gather::Facing& facing) {
  if (facing.has_value()) return RayEdge::side;
  if (facing.kind == ShaderKind::barrier) return RayEdge::stop;
  return mesh.half_edge_twin[h] == mesh::kNone ? RayEdge::stop : RayEdge::open;
}

/// Returns the side of a half-edge. Without a value on the other side nothing is blurred.
ExactSide side_of(const mesh::TriangleMesh& mesh, const curves::SegmentAttributes& attributes,
                  std::uint32_t h, const gather::Facing& facing) {
  ExactSide side;
  std::ranges::copy(facing.from.channel, side.from);
  std::ranges::copy(facing.to.channel, side.to);
  side.weight = facing.weight;
  const bool asks_for_blur = facing.blur_from > 0 || facing.blur_to > 0;
  if (!asks_for_blur || !gather::back_side(mesh, attributes, h).has_value()) return side;
  side.blur_from = facing.blur_from;
  side.blur_to = facing.blur_to;
  return side;
}

Status add_sides(const Context& context, const mesh::TriangleMesh& mesh,
                 const curves::SegmentAttributes& attributes, TableMemory& memory,
                 ExactField& field) {
  RarePoll<8192> poll(context);
  for (std::uint32_t h = 0; h < field.edge.size(); ++h) {
    if (poll.cancelled()) return context.cancel_status();
    gather::Facing facing;
    if (mesh.has_curves(h)) facing = gather::facing_side(mesh, attributes, h);
    field.edge[h] = edge_of(mesh, h, facing);
    if (field.edge[h] != RayEdge::side) continue;
    SFUMATO_TRY(memory.push_back(context, field.side, side_of(mesh, attributes, h, facing)));
  }
  return ok_status();
}

Status add_ends(Context& context, const mesh::TriangleMesh& mesh,
                const curves::SegmentAttributes& attributes, TableMemory& memory,
                ExactField& field) {
  SFUMATO_TRY_ASSIGN(const gather::FreeEnds& ends,
                     gather::FreeEnds::create(context, mesh, attributes, Vec2{0, 0}, 1));
  const gather::EndTerm* term = ends.view().term;
  for (const gather::FreeEnd& end : ends.all()) {
    ExactEnd exact{end.position,
                   end.direction,
                   static_cast<float>(end.bend),
                   static_cast<float>(end.reach),
                   term->weight,
                   end.blur_positive,
                   end.blur_negative};
    std::ranges::copy(end.positive.channel, exact.positive);
    std::ranges::copy(end.negative.channel, exact.negative);
    SFUMATO_TRY(memory.push_back(context, field.end, exact));
    ++term;
  }
  return ok_status();
}

Result<ExactField> field_of(Context& context, const mesh::TriangleMesh& mesh,
                            const curves::SegmentAttributes& attributes, gather::Ends ends,
                            TableMemory& memory) {
  ExactField field;
  field.channel_count = attributes.base_channels;
  SFUMATO_TRY(memory.resize(context, field.edge, mesh.triangle_vertex.size()));
  SFUMATO_TRY(add_sides(context, mesh, attributes, memory, field));
  if (ends == gather::Ends::soft) SFUMATO_TRY(add_ends(context, mesh, attributes, memory, field));
  return field;
}

Result<ExactLayer> layer_of(Context& context, const mesh::TriangleMesh& mesh,
                            const SampledFields& sampled, gather::Ends ends, TableMemory& memory) {
  ExactLayer layer;
  const auto has_shaders = [](const SampledField& field) {
    return !field.attributes.shader.empty();
  };
  if (has_shaders(sampled.color) || (sampled.opacity && has_shaders(*sampled.opacity)))
    return layer;
  SFUMATO_TRY(memory.assign(context, mesh.vertex_position, layer.vertex_position));
  SFUMATO_TRY(memory.assign(context, mesh.triangle_vertex, layer.triangle_vertex));
  SFUMATO_TRY_ASSIGN(auto&& color, field_of(context, mesh, sampled.color.attributes, ends, memory));
  layer.field.push_back(std::move(color));
  if (!sampled.opacity) return layer;
  SFUMATO_TRY_ASSIGN(auto&& opacity,
                     field_of(context, mesh, sampled.opacity->attributes, ends, memory));
  layer.field.push_back(std::move(opacity));
  return layer;
}

/// Returns the coarsest tolerance in the visible part.
double tolerance_of(const curves::FlattenOptions& options) {
  if (options.focuses.empty()) return options.tolerance;
  double tolerance = 0;
  for (const curves::FlattenFocus& focus : options.focuses)
    tolerance = std::max(tolerance, focus.tolerance);
  return tolerance;
}

}  // namespace

/// Does the first steps of prepare_layer(), for points.
Result<ExactLayer> exact_layer(Context& context, const Document& document, std::uint32_t layer,
                               const LayerSight& sight, const DiffuseOptions& options,
                               TableMemory& memory) {
  const std::vector<Curve>& curves = document.layers[layer].curves;
  const LayerUnits units(document.artboard, sight, options);
  SFUMATO_TRY_ASSIGN(const curves::FlatCurves& flat,
                     flatten_layer(context, document.layers[layer], sight, units));
  ScopedCharge charge;
  SFUMATO_TRY(charge.add(context, curves::bytes_of(flat), "flattening"));
  SFUMATO_TRY_ASSIGN(const SampledFields& sampled,
                     sample_fields(context, {flat, curves, document.interpolation}, options, {}));
  SFUMATO_TRY_ASSIGN(auto&& mesher, mesh::Mesher::build(context, flat, units.mesh_options()));
  SFUMATO_TRY_ASSIGN(const mesh::TriangleMesh& mesh, mesher.visibility_mesh(context));
  Result<ExactLayer> exact = layer_of(context, mesh, sampled, options.ends, memory);
  if (exact) exact->tolerance = tolerance_of(units.flatten_options());
  return exact;
}

Status add_exact_fields(Context& context, const Document& document, const DiffuseOptions& options,
                        Picture* picture) {
  TableMemory memory("exact fields");
  for (std::uint32_t i = 0; i < picture->layers.size(); ++i) {
    if (picture->layers[i].triangle_count() == 0) continue;
    const LayerSight sight = sight_of_layer(document, i, picture->viewport);
    SFUMATO_TRY_ASSIGN(picture->layers[i].exact,
                       exact_layer(context, document, i, sight, options, memory));
  }
  return ok_status();
}

}  // namespace sfumato::solve
