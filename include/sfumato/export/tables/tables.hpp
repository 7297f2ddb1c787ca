#pragma once

#include <cstdint>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/export/export_notes.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato {

/// @name The solution as tables
/// Functions that export a picture as its vertices, triangles, nodes and values, for your own
/// programs (docs/outputs.md has the names and shapes). Coordinates, orders and values are as in
/// PatchLayer. `notes`, unless null, receives the content that the tables leave out and the number
/// of triangles.
///
/// Errors: bad_input (an invalid picture, an empty viewport), limit (memory; 4 GiB in an NPZ and a
/// PLY), cancelled, out_of_memory.
/// @{

/// Writes an uncompressed ZIP archive of arrays, for NumPy. The same picture gives the same bytes.
Result<std::vector<std::uint8_t>> export_npz(Context& context, const Picture& picture,
                                             ExportNotes* notes = nullptr);

/// Writes JSON: the same tables as lists of rows, in shortest decimals that read back as the same
/// numbers. Values that are not finite are null.
Result<std::vector<std::uint8_t>> export_json(Context& context, const Picture& picture,
                                              ExportNotes* notes = nullptr);

/// Writes a binary PLY for programs that show meshes: nodes as vertices, with y up, sRGB colours
/// and alpha, and nine faces for each patch. Each instance is stored at its place, z by its order.
Result<std::vector<std::uint8_t>> export_ply(Context& context, const Picture& picture,
                                             ExportNotes* notes = nullptr);
/// @}

}  // namespace sfumato
