#include "gather/rows/row_sources.hpp"

#include <cmath>
#include <span>

#include "base/poll.hpp"
#include "base/try.hpp"

namespace sfumato::gather {
namespace {

using curves::FieldValue;

/// Read the channels of curves::sample_stop_places().
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

/// Returns the side of an end, whose values do not depend on the place of a point.
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

RowEdge edge_of(const mesh::TriangleMesh& mesh, std::uint32_t half_edge) {
  const Vec2 from = mesh.vertex_position[mesh.origin(half_edge)];
  const Vec2 along = mesh.vertex_position[mesh.target(half_edge)] - from;
  return {from, along, 1 / length(along)};
}

Status add_edges(const Context& context, const mesh::TriangleMesh& mesh,
                 const curves::SegmentAttributes& places, const Scene& scene, RowSources& sources) {
  const std::size_t count = scene.hit_edge.size();
  SFUMATO_TRY(sources.memory.resize(context, sources.edge, count));
  SFUMATO_TRY(sources.memory.resize(context, sources.source, count));
  RarePoll<4096> poll(context);
  for (std::size_t t = 0; t < scene.triangle.size(); ++t) {
    if (poll.cancelled()) return context.cancel_status();
    for (std::uint32_t k = 0; k < 3; ++k) {
      const EdgeCode code = scene.triangle[t].edge[k];
      if (!is_hit(code)) continue;
      const std::uint32_t h = 3 * scene.source[t] + k;
      sources.edge[hit_index(code)] = edge_of(mesh, h);
      sources.source[hit_index(code)] =
          source_of(facing_side(mesh, places, h), back_side(mesh, places, h));
    }
  }
  return ok_status();
}

/// Adds sources of the ends in `sources`. `places`: of these and perhaps of others, in the order of
/// their vertices, with places for values.
Status add_ends(const Context& context, std::span<const FreeEnd> places, RowSources& sources) {
  const std::span<const FreeEnd> ends = sources.ends.all();
  const std::size_t count = sources.edge.size() + 2 * ends.size();
  SFUMATO_TRY(sources.memory.reserve(context, sources.source, count));
  for (const FreeEnd& end : ends) {
    const auto [from, to] = std::ranges::equal_range(places, end.vertex, {}, &FreeEnd::vertex);
    const FreeEnd& place = from == to ? end : *from;
    sources.source.push_back(source_of(place.positive, place.negative, end.blur_positive));
    sources.source.push_back(source_of(place.negative, place.positive, end.blur_negative));
  }
  return context.check();
}

}  // namespace

Result<RowSources> find_row_sources(Context& context, const mesh::TriangleMesh& mesh,
                                    const curves::SegmentAttributes& places, const Scene& scene,
                                    const curves::SegmentAttributes* values) {
  RowSources sources;
  SFUMATO_TRY(add_edges(context, mesh, places, scene, sources));
  SFUMATO_TRY_ASSIGN(sources.ends, FreeEnds::create(context, mesh, values ? *values : places, {},
                                                    scene.weight_unit));
  TableMemory memory("free ends of curves");
  std::vector<FreeEnd> with_places;
  if (values) {
    SFUMATO_TRY_ASSIGN(with_places, find_free_ends(context, mesh, places, memory));
  }
  SFUMATO_TRY(add_ends(context, with_places, sources));
  return sources;
}

}  // namespace sfumato::gather
