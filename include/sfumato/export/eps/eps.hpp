#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/export/export_notes.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato {

/// Options of export_eps().
struct EpsOptions {
  /// Width of the picture in points (1/72 inch); default: 3/4 of a point to a user unit.
  std::optional<double> page_width_pt{};
  /// Resolution of pictures that are stored as pixels; facets are made no finer than its pixels.
  double dpi = 300;
  double max_error = 0.5;  ///< tolerated in the facets' colours, in code values of 255
  std::string title{};     ///< its printable ASCII characters, at most 200, are written
};

/// Exports a picture as Encapsulated PostScript, language level 3 (docs/pdf.md), of the picture's
/// viewport.
///
/// Layers are triangle meshes with linear colours, each stored once however often it is painted. A
/// picture that needs compositing (opacity, blend modes, textures, gradients, local curves) is
/// stored as pixels as a whole, on its background or white; `notes`, unless null, then reports it.
///
/// Errors: bad_input (an empty viewport, an invalid picture, options that are not positive
/// numbers), limit (memory, pixels), cancelled, out_of_memory.
/// Cost: about 1.4 µs and 10 bytes of the file a facet (docs/benchmarks.md); for a picture stored
/// as pixels that of rasterize().
Result<std::vector<std::uint8_t>> export_eps(Context& context, const Picture& picture,
                                             const EpsOptions& options,
                                             ExportNotes* notes = nullptr);

}  // namespace sfumato
