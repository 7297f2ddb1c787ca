#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "base/table_memory.hpp"
#include "curves/attributes.hpp"
#include "gather/ends/free_ends.hpp"
#include "gather/rows/rows.hpp"
#include "gather/scene/scene.hpp"
#include "mesh/triangle_mesh.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/base/vec2.hpp"

namespace sfumato::gather {

/// The place of an edge's source. Its triangle is where cross(along, p - from) is positive.
struct RowEdge {
  Vec2 from;
  Vec2 along;
  double inverse_length = 0;

  double distance(Vec2 p) const { return std::max(cross(along, p - from) * inverse_length, 0.0); }
};

/// The sources of a mesh's rows: first the edges, then for each free end one for points on its
/// positive side and one for the others.
struct RowSources {
  std::vector<RowSource> source;
  std::vector<RowEdge> edge;  ///< per hit edge of the scene, whose index equals its source's
  FreeEnds ends;              ///< positions in the layer frame, weights in the scene's unit
  TableMemory memory{"rows of the gather"};

  std::uint32_t of_end(std::size_t end, bool is_positive) const {
    return static_cast<std::uint32_t>(edge.size() + 2 * end + (is_positive ? 0 : 1));
  }
};

/// Finds the sources.
///
/// places   curves::sample_stop_places() on the curves of `mesh`
/// scene    of both
/// values   RowOptions::values
/// Errors   limit (memory), cancelled
Result<RowSources> find_row_sources(Context& context, const mesh::TriangleMesh& mesh,
                                    const curves::SegmentAttributes& places, const Scene& scene,
                                    const curves::SegmentAttributes* values = nullptr);

}  // namespace sfumato::gather
