#include "gather/row_sources.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "base/poll.hpp"

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

RowEdge edge_of(const mesh::TriangleMesh& mesh, std::uint32_t half_edge) {
  const Vec2 from = mesh.vertex_position[mesh.origin(half_edge)];
  const Vec2 along = mesh.vertex_position[mesh.target(half_edge)] - from;
  return {from, along, 1 / length(along)};
}

Status add_edges(const Context& context, const mesh::TriangleMesh& mesh,
                 const curves::SegmentAttributes& places, const Scene& scene, RowSources& sources) {
  const std::size_t count = scene.hit_edge.size();
  Status status = sources.memory.resize(context, sources.edge, count);
  if (status) status = sources.memory.resize(context, sources.source, count);
  RarePoll<4096> poll(context);
  for (std::size_t t = 0; status && t < scene.triangle.size(); ++t) {
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
  return status;
}

/// Sources of the ends that `sources` has. `places`: of these and perhaps of others, in the order
/// of their vertices, with places for values.
Status add_ends(const Context& context, std::span<const FreeEnd> places, RowSources& sources) {
  const std::span<const FreeEnd> ends = sources.ends.all();
  const std::size_t count = sources.edge.size() + 2 * ends.size();
  Status status = sources.memory.reserve(context, sources.source, count);
  if (!status) return status;
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
  Status status = add_edges(context, mesh, places, scene, sources);
  if (!status) return status;
  Result<FreeEnds> ends =
      FreeEnds::create(context, mesh, values ? *values : places, {}, scene.weight_unit);
  if (!ends) return ends.status();
  sources.ends = std::move(*ends);
  TableMemory memory("free ends of curves");
  std::vector<FreeEnd> with_places;
  if (values) {
    Result<std::vector<FreeEnd>> found = find_free_ends(context, mesh, places, memory);
    if (!found) return found.status();
    with_places = std::move(*found);
  }
  status = add_ends(context, with_places, sources);
  if (!status) return status;
  return sources;
}

}  // namespace sfumato::gather
