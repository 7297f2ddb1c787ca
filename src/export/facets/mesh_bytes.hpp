#pragma once

#include <cstdint>
#include <vector>

#include "base/table_memory.hpp"
#include "export/facets/facets.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::outputs {

/// Returns the bounding box of the triangles of a layer. Vertices that no triangle uses do not
/// count.
Box triangles_box(const PatchLayer& layer);

/// A mesh's coordinates are fractions of this rectangle, which contains every vertex.
Box decode_box(const std::vector<Vec2>& positions);
/// The same for the content of a box; sides of length 0 become short.
Box decode_box(Box box);

/// Facets as the data of a shading of type 4 (ISO 32000-1, 8.7.4.5.5), which PDF and PostScript
/// share: a byte of flag, 24 bits for each coordinate, a byte for each channel. Consecutive facets
/// with a common side form strips. `box` is not empty. The bytes are a table of `memory`. Errors:
/// limit (memory), cancelled.
Result<std::vector<std::uint8_t>> mesh_bytes(Context& context, const FacetMesh& mesh,
                                             const Box& box, TableMemory& memory);

}  // namespace sfumato::outputs
