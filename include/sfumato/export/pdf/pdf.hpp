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

/// Which layers of a PDF are stored as pixels instead of triangles.
enum class PdfFlatten : std::uint8_t {
  automatic,  ///< the dearest, of pictures whose triangles would take some programs minutes
  always,
  never
};

struct PdfOptions {
  /// Width of the page in points (1/72 inch); default three quarters of a point to a user unit, as
  /// CSS has it.
  std::optional<double> page_width_pt{};
  double dpi = 300;        ///< of what is drawn as pixels: textures, gradients, local curves
  double max_error = 0.5;  ///< of colours in the facets, code values of 255
  std::string title{};     ///< UTF-8
  PdfFlatten flatten = PdfFlatten::automatic;
};

/// Picture → PDF 1.7: one page that shows the viewport (docs/pdf.md). Colours and opacities are
/// triangle meshes, curves are antialiased, layers are stored once however often they are painted.
/// Layers that `options.flatten` has as pixels are images at `dpi`; what `automatic` has chosen is
/// told in ExportNotes::lost.
///
/// Errors: bad_input (an empty viewport, a picture whose tables do not fit, options that are no
/// positive numbers), limit (memory, pixels), cancelled, out_of_memory.
/// Memory: about 40 bytes a facet of the largest layer, and the file. Cost: 2 µs a facet.
Result<std::vector<std::uint8_t>> export_pdf(Context& context, const Picture& picture,
                                             const PdfOptions& options,
                                             ExportNotes* notes = nullptr);

}  // namespace sfumato
