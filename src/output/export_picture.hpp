#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "options/output_kind.hpp"
#include "options/settings.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/export/export_notes.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato::output {

/// Holds the other inputs, besides the picture, of a file that can be enlarged.
struct DrawingOptions {
  options::OutputKind kind = options::OutputKind::html;  ///< no image
  options::OutputOptions output;                         ///< settled
  double scale = 1;      ///< output pixels per user unit, which sets the size of a page
  double max_error = 1;  ///< with which the picture was solved
};

/// Exports a solved picture as a file of any kind except images. Appends to notes unless null.
/// Errors: as the exporters, and as rasterize() for the first picture of an HTML page.
Result<std::vector<std::uint8_t>> export_picture(Context& context, const Picture& picture,
                                                 const DrawingOptions& options, ExportNotes* notes);

}  // namespace sfumato::output
