#pragma once

#include <cstdint>
#include <vector>

#include "base/table_memory.hpp"
#include "curves/attributes.hpp"
#include "gather/free_ends.hpp"
#include "gather/rows.hpp"
#include "mesh/triangle_mesh.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::gather {

/// In place of a source, at a half-edge of the mesh.
inline constexpr std::int32_t kNoSource = -1;  ///< rays pass
inline constexpr std::int32_t kBarrierSource = -2;

/// The sources of a mesh's rows, and where they lie.
struct RowSources {
  std::vector<RowSource> source;
  std::vector<float> weight;               ///< k, per source of an edge
  std::vector<std::int32_t> at_half_edge;  ///< a source, or one of the above
  FreeEnds ends;                           ///< positions in the layer frame, weights as they are
  std::uint32_t first_end = 0;  ///< behind the edges' sources come, for each of ends.all(), that of
                                ///< points on its positive side, then that of the others
  TableMemory memory{"rows of the gather"};

  std::uint32_t of_end(std::size_t end, bool is_positive) const {
    return first_end + 2 * static_cast<std::uint32_t>(end) + (is_positive ? 0 : 1);
  }
};

/// places   curves::sample_stop_places() on the curves of `mesh`. Errors: limit (memory),
/// cancelled.
Result<RowSources> find_row_sources(Context& context, const mesh::TriangleMesh& mesh,
                                    const curves::SegmentAttributes& places);

}  // namespace sfumato::gather
