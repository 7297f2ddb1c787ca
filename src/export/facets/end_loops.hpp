#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "base/half_edge.hpp"
#include "base/poll.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::outputs {

/// Returns the border half-edge that begins where `half_edge` ends, around the area that the mesh
/// covers.
///
/// twin   per half-edge the one on the other side; kNoHalfEdge: none
inline std::uint32_t next_at_end(std::span<const std::uint32_t> twin, std::uint32_t half_edge) {
  std::uint32_t next = next_half_edge(half_edge);
  while (twin[next] != kNoHalfEdge) next = next_half_edge(twin[next]);
  return next;
}

/// Returns whether two points lie approximately on the same side of a rectangle.
inline bool is_on_frame(Vec2 a, Vec2 b, const Box& frame) {
  const double near = 2e-6 * std::max(frame.width(), frame.height());
  const auto both = [&](double x, double y, double side) {
    return std::fabs(x - side) <= near && std::fabs(y - side) <= near;
  };
  return both(a.x, b.x, frame.min.x) || both(a.x, b.x, frame.max.x) ||
         both(a.y, b.y, frame.min.y) || both(a.y, b.y, frame.max.y);
}

/// Calls visit(half_edge, is_first) for all border half-edges, one closed line after another. Lines
/// around the mesh have the orientation of triangles, lines around its holes the opposite. Cost:
/// O(half-edges). Errors: limit (memory), cancelled, as visit.
template <class Visit>
Status for_each_end_loop(Context& context, std::span<const std::uint32_t> twin,
                         const Visit& visit) {
  RarePoll<4096> poll(context);
  TableMemory memory("lines around a mesh");
  std::vector<std::uint8_t> is_done;
  SFUMATO_TRY(memory.resize(context, is_done, twin.size()));
  for (std::uint32_t first = 0; first < twin.size(); ++first) {
    if (poll.cancelled()) return context.cancel_status();
    if (twin[first] != kNoHalfEdge || is_done[first]) continue;
    for (std::uint32_t edge = first; !is_done[edge]; edge = next_at_end(twin, edge)) {
      if (poll.cancelled()) return context.cancel_status();
      is_done[edge] = 1;
      SFUMATO_TRY(visit(edge, edge == first));
    }
  }
  return ok_status();
}

}  // namespace sfumato::outputs
