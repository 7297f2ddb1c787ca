#include "gather/row_sources.hpp"

#include <cmath>
#include <utility>

#include "base/poll.hpp"
#include "gather/scene.hpp"

namespace sfumato::gather {
namespace {

using curves::FieldValue;

/// The channels of curves::sample_stop_places().
float fraction_of(const FieldValue& place) {
  return place.channel[0];
}
std::uint32_t column_of(const FieldValue& place) {
  return static_cast<std::uint32_t>(std::lround(place.channel[1]));
}
std::uint32_t curve_of(const FieldValue& place) {
  return static_cast<std::uint32_t>(std::lround(place.channel[2]));
}

RowSide row_side(const Facing& facing) {
  if (!facing.has_value()) return {};
  if (facing.kind == ShaderKind::image_domain) {
    return {.shader = static_cast<std::int32_t>(facing.shader), .has_value = true};
  }
  return {.column = column_of(facing.from),
          .from = fraction_of(facing.from),
          .to = fraction_of(facing.to),
          .has_value = true};
}

/// The side of an end, whose values are the same wherever a point is.
RowSide row_side(const FieldValue& place) {
  return {.column = column_of(place),
          .from = fraction_of(place),
          .to = fraction_of(place),
          .has_value = true};
}

RowSource source_of(const Facing& front, const Facing& back) {
  return {row_side(front), row_side(back), curve_of(front.from), front.blur_from, front.blur_to};
}

RowSource source_of(const FieldValue& front, const FieldValue& back, float blur) {
  return {row_side(front), row_side(back), curve_of(front), blur, blur};
}

Status add_edges(const Context& context, const mesh::TriangleMesh& mesh,
                 const curves::SegmentAttributes& places, RowSources& sources) {
  const auto half_edges = static_cast<std::uint32_t>(mesh.triangle_vertex.size());
  Status status = sources.memory.resize(context, sources.at_half_edge, half_edges, kNoSource);
  RarePoll<4096> poll(context);
  for (std::uint32_t h = 0; status && h < half_edges; ++h) {
    if (poll.cancelled()) return context.cancel_status();
    if (mesh.half_edge_constraint[h] == mesh::kNone) continue;
    const Facing front = facing_side(mesh, places, h);
    if (front.kind == ShaderKind::barrier) sources.at_half_edge[h] = kBarrierSource;
    if (!front.has_value()) continue;
    sources.at_half_edge[h] = static_cast<std::int32_t>(sources.source.size());
    status = sources.memory.push_back(context, sources.source,
                                      source_of(front, back_side(mesh, places, h)));
    if (status) status = sources.memory.push_back(context, sources.weight, front.weight);
  }
  return status;
}

Status add_ends(const Context& context, RowSources& sources) {
  sources.first_end = static_cast<std::uint32_t>(sources.source.size());
  Status status;
  for (const FreeEnd& end : sources.ends.all()) {
    status = sources.memory.push_back(context, sources.source,
                                      source_of(end.positive, end.negative, end.blur_positive));
    if (status) {
      status = sources.memory.push_back(context, sources.source,
                                        source_of(end.negative, end.positive, end.blur_negative));
    }
    if (!status) return status;
  }
  return context.check();
}

}  // namespace

Result<RowSources> find_row_sources(Context& context, const mesh::TriangleMesh& mesh,
                                    const curves::SegmentAttributes& places) {
  RowSources sources;
  Status status = add_edges(context, mesh, places, sources);
  if (!status) return status;
  Result<FreeEnds> ends = FreeEnds::create(context, mesh, places, {}, 1);
  if (!ends) return ends.status();
  sources.ends = std::move(*ends);
  status = add_ends(context, sources);
  if (!status) return status;
  return sources;
}

}  // namespace sfumato::gather
