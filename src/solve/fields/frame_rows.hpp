#pragma once

#include <cstdint>
#include <vector>

#include "base/table_memory.hpp"
#include "mesh/triangle_mesh.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"
#include "solve/fields/nodes.hpp"

namespace sfumato::solve {

/// Rows of a frame's patches that are not those of the layer which the frame began from, without
/// the curve: all others have the same bits at the same place. Their soft edges are not counted.
struct FrameRows {
  std::uint32_t first_vertex = 0;              ///< and all behind it
  std::vector<std::uint32_t> triangles{};      ///< ascending
  std::vector<std::uint32_t> nodes{};          ///< of colour, ascending
  std::vector<std::uint32_t> opacity_nodes{};  ///< ascending
  TableMemory memory{"a drag"};
};

/// Puts rows in ascending order, each once. Errors: limit (memory), cancelled.
/// count   of the rows of their table
Status sort_rows(const Context& context, std::size_t count, std::vector<std::uint32_t>& rows);

/// What the rows of a frame's patches are copied from.
struct FrameSource {
  const mesh::TriangleMesh& mesh;
  const NodeLayout& color;
  const NodeLayout* opacity = nullptr;  ///< null: there is none, or `color` holds it
};

/// Gives the tables of patches room for those of a frame; they stay as they are. Errors: limit
/// (memory), cancelled.
Status make_room(const Context& context, const FrameSource& frame, PatchLayer& layer);

/// The same for frames of a layer that has been solved now.
Status make_room(const Context& context, PatchLayer& layer);

/// Makes patches that are not those of the base in the rows `then` the ones of a frame, in the rows
/// `now`, but for soft edges. There is room in them.
void write_rows(const FrameSource& frame, const FrameRows& then, const FrameRows& now,
                PatchLayer& layer);

}  // namespace sfumato::solve
