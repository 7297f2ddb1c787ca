#pragma once

#include <cstdint>

#include "export/pdf/pdf_file.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/export/export_notes.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato::outputs {

/// How a layer is written.
struct PdfLayerOptions {
  double max_error = 0.5 / 255;
  double points_per_unit = 0.75;  ///< for the instance that shows the layer largest
  double dpi = 300;
  bool is_group = false;   ///< some instance composites it as a group
  bool as_pixels = false;  ///< stored as one image
};

/// A layer as a form XObject in its own frame; 0 if it shows nothing, or after an error, which is
/// then in the file's status. Its facets are added to `notes`.
PdfRef add_layer(Context& context, PdfFile* file, const Picture& picture, std::uint32_t layer,
                 const PdfLayerOptions& options, ExportNotes* notes);

}  // namespace sfumato::outputs
