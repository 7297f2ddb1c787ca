#pragma once

#include <span>

#include "curves/attributes.hpp"
#include "gather/rows/rows.hpp"
#include "mesh/triangle_mesh.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/base/vec2.hpp"

namespace sfumato::gather {

/// Does gather_rows() slowly and readably: one point after another, in double precision, by the
/// walk of gather_reference(). Times the stops' values the rows equal that gather. Its tables are
/// not charged. Errors: limit (memory), cancelled. Cost: 10 to 20 microseconds a point, and
/// O(triangles).
Result<Rows> rows_reference(Context& context, const mesh::TriangleMesh& mesh,
                            const curves::SegmentAttributes& places, std::span<const Vec2> points,
                            const RowOptions& options = {});

}  // namespace sfumato::gather
