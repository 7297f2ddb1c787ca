#include "mesh/inside.hpp"

#include <cstdint>
#include <vector>

#include "base/poll.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"

namespace sfumato::mesh {

Status flood_inside(const Context& context, Triangulation& mesh, const ChordStore& chords) {
  constexpr std::int16_t kUnknown = -1;
  for (Triangle& t : mesh.triangle) t.inside = kUnknown;
  TableMemory memory("the triangle mesh");
  std::vector<std::int32_t> stack;
  SFUMATO_TRY(memory.push_back(context, stack, triangle_of(mesh.spoke[0])));
  mesh.triangle[stack[0]].inside = 0;
  RarePoll<4096> poll(context);
  while (!stack.empty()) {
    if (poll.cancelled()) return context.cancel_status();
    const std::int32_t t = stack.back();
    stack.pop_back();
    SFUMATO_TRY(memory.make_room(context, stack, 3));
    for (HalfEdge e = 4 * t; e < 4 * t + 3; ++e) {
      if (mesh.across(e) == kHull) continue;
      const bool frame = mesh.is_wall(e) && chords[mesh.chord[e]].load.frame;
      const auto inside = static_cast<std::int16_t>(mesh.triangle[t].inside ^ int{frame});
      Triangle& other = mesh.triangle[triangle_of(mesh.twin(e))];
      if (other.inside == kUnknown) {
        other.inside = inside;
        stack.push_back(triangle_of(mesh.twin(e)));
      } else if (other.inside != inside) {
        return make_error(StatusCode::internal, "mesh: the frame is not closed");
      }
    }
  }
  return ok_status();
}

}  // namespace sfumato::mesh
