#include "gather/ends/meetings.hpp"

#include <cmath>

#include "base/poll.hpp"
#include "base/try.hpp"
#include "gather/scene/scene.hpp"
#include "sfumato/base/color_space.hpp"

namespace sfumato::gather {

Status find_meetings(const Context& context, const mesh::TriangleMesh& mesh, TableMemory& memory,
                     std::vector<Meeting>& meetings) {
  SFUMATO_TRY(memory.resize(context, meetings, mesh.vertex_position.size()));
  RarePoll<4096> poll(context);
  for (std::uint32_t h = 0; h < mesh.triangle_vertex.size(); ++h) {
    if (poll.cancelled()) return context.cancel_status();
    if (!mesh.has_curves(h)) continue;
    Meeting& meeting = meetings[mesh.origin(h)];
    ++meeting.edges;
    meeting.half_edge = h;
  }
  return context.check();
}

std::uint32_t curve_on(const mesh::TriangleMesh& mesh, const curves::SegmentAttributes& attributes,
                       std::uint32_t half_edge) {
  const auto constraint = static_cast<std::size_t>(mesh.half_edge_constraint[half_edge]);
  return attributes.curve[mesh.pieces(mesh.constraint[constraint]).back().segment];
}

std::optional<Cross> cross_at(const mesh::TriangleMesh& mesh,
                              const curves::SegmentAttributes& attributes, const Meeting& meeting) {
  Cross cross;
  if (meeting.edges != cross.strand.size()) return std::nullopt;
  std::size_t count = 0;
  std::uint32_t h = meeting.half_edge;
  do {
    if (mesh.has_curves(h)) {
      if (count == cross.strand.size()) return std::nullopt;
      cross.strand[count++] = {h, curve_on(mesh, attributes, h)};
    }
    const std::int32_t twin = mesh.half_edge_twin[previous_half_edge(h)];
    if (twin == mesh::kNone) return std::nullopt;
    h = static_cast<std::uint32_t>(twin);
  } while (h != meeting.half_edge);
  return count == cross.strand.size() ? std::optional(cross) : std::nullopt;
}

bool differ(const curves::SegmentAttributes& attributes, const curves::FieldValue& a,
            const curves::FieldValue& b, float by) {
  const auto code = [&](const curves::FieldValue& value) {
    return to_srgb(attributes.space, {value.channel[0], value.channel[1], value.channel[2]});
  };
  const Rgb one = code(a), other = code(b);
  return std::abs(one.r - other.r) > by || std::abs(one.g - other.g) > by ||
         std::abs(one.b - other.b) > by;
}

bool clashes(const mesh::TriangleMesh& mesh, const curves::SegmentAttributes& attributes,
             const Cross& cross, float by) {
  for (std::size_t i = 0; i < cross.strand.size(); ++i) {
    const std::uint32_t next = cross.strand[(i + 1) % cross.strand.size()].half_edge;
    const Facing one = facing_side(mesh, attributes, cross.strand[i].half_edge);
    const Facing other =
        facing_side(mesh, attributes, static_cast<std::uint32_t>(mesh.half_edge_twin[next]));
    if (one.kind != ShaderKind::curve_domain || other.kind != ShaderKind::curve_domain) continue;
    if (differ(attributes, one.from, other.to, by)) return true;
  }
  return false;
}

}  // namespace sfumato::gather
