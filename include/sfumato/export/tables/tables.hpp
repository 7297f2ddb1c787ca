#pragma once

#include <cstdint>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/export/export_notes.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato {

/// @name The solution as tables
/// Picture → its vertices, triangles, nodes and values, for programs of one's own
/// (docs/outputs.md has the names and shapes). Coordinates, orders and values are those of
/// PatchLayer. `notes`, unless null, receives what the tables leave out and the number of
/// triangles.
///
/// Errors: bad_input (an invalid picture, an empty viewport), limit (memory; 4 GiB in an NPZ and a
/// PLY), cancelled, out_of_memory.
/// @{

/// As NumPy reads it: an uncompressed ZIP archive of arrays. The same picture gives the same bytes.
Result<std::vector<std::uint8_t>> export_npz(Context& context, const Picture& picture,
                                             ExportNotes* notes = nullptr);

/// As JSON: the same tables as lists of rows, in shortest decimals that read back as the same
/// numbers. Values that are not finite are null.
Result<std::vector<std::uint8_t>> export_json(Context& context, const Picture& picture,
                                              ExportNotes* notes = nullptr);

/// As a binary PLY for programs that show meshes: nodes as vertices, with y up, sRGB colours and
/// alpha, and nine faces for each patch. Each instance is stored at its place, z by its order.
Result<std::vector<std::uint8_t>> export_ply(Context& context, const Picture& picture,
                                             ExportNotes* notes = nullptr);
/// @}

}  // namespace sfumato
