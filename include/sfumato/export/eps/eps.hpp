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

struct EpsOptions {
  /// Width in points (1/72 inch); default three quarters of a point to a user unit.
  std::optional<double> page_width_pt{};
  double dpi = 300;        ///< of a picture that has to be pixels, and of the finest facets
  double max_error = 0.5;  ///< of colours in the facets, code values of 255
  std::string title{};     ///< what is not printable ASCII is left out
};

/// Picture → Encapsulated PostScript, language level 3 (docs/pdf.md). Opaque layers are meshes,
/// each stored once; a picture with anything that must be composited (opacity, blend modes,
/// textures, gradients, local curves) is pixels as a whole, on its background or white, which
/// `notes` says.
///
/// Errors: bad_input (an empty viewport, a picture whose tables do not fit, options that are no
/// positive numbers), limit (memory, pixels), cancelled, out_of_memory.
Result<std::vector<std::uint8_t>> export_eps(Context& context, const Picture& picture,
                                             const EpsOptions& options,
                                             ExportNotes* notes = nullptr);

}  // namespace sfumato
