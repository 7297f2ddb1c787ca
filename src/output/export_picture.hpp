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

/// What a file that can be enlarged is made from besides the picture.
struct DrawingOptions {
  options::OutputKind kind = options::OutputKind::html;  ///< no image
  options::OutputOptions output;                         ///< settled
  double scale = 1;      ///< output pixels per user unit, by which a page has its size
  double max_error = 1;  ///< with which the picture was solved
};

/// A solved picture as a file of any kind but images. Notes, unless null, are added to.
/// Errors: those of the exporters, and of rasterize() for the picture that an HTML page begins
/// with.
Result<std::vector<std::uint8_t>> export_picture(Context& context, const Picture& picture,
                                                 const DrawingOptions& options, ExportNotes* notes);

}  // namespace sfumato::output
