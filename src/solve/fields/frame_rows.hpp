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

/// The rows of a frame's patches that may differ from its base: the layer without the curve. All
/// other rows have the same bits at the same index. Soft edges are not included.
struct FrameRows {
  std::uint32_t first_vertex = 0;              ///< this vertex and all later ones
  std::vector<std::uint32_t> triangles{};      ///< ascending
  std::vector<std::uint32_t> nodes{};          ///< of colour, ascending
  std::vector<std::uint32_t> opacity_nodes{};  ///< ascending
  TableMemory memory{"a drag"};
};

/// Sorts a list of rows in ascending order and removes duplicates. Errors: limit (memory),
/// cancelled.
/// count   the number of rows in their table
Status sort_rows(const Context& context, std::size_t count, std::vector<std::uint32_t>& rows);

/// The source of the rows of a frame's patches.
struct FrameSource {
  const mesh::TriangleMesh& mesh;
  const NodeLayout& color;
  const NodeLayout* opacity = nullptr;  ///< null: no opacity, or `color` holds it
};

/// Reserves memory in the tables of patches for the rows of a frame. The rows do not change.
/// Errors: limit (memory), cancelled.
Status make_room(const Context& context, const FrameSource& frame, PatchLayer& layer);

/// Does the same for future frames of a layer that was just solved.
Status make_room(const Context& context, PatchLayer& layer);

/// Replaces the patches of one frame by the patches of another frame with the same base, except for
/// soft edges. Call make_room() first.
/// then   the rows where `layer` differs from the base
/// now    the rows where the new frame differs from the base
void write_rows(const FrameSource& frame, const FrameRows& then, const FrameRows& now,
                PatchLayer& layer);

}  // namespace sfumato::solve
