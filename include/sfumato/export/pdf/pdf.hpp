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
  /// None, unless the picture paints so many triangles, counting every instance, that some programs
  /// would take minutes: then the layers that paint most of them.
  automatic,
  always,  ///< all of them
  never    ///< none
};

/// Options of export_pdf().
struct PdfOptions {
  /// Width of the page in points (1/72 inch); default: 3/4 of a point to a user unit, as in CSS.
  std::optional<double> page_width_pt{};
  double dpi = 300;        ///< of parts stored as pixels: textures, gradients, local curves
  double max_error = 0.5;  ///< tolerated in the facets' colours, in code values of 255
  std::string title{};     ///< UTF-8; empty: none
  PdfFlatten flatten = PdfFlatten::automatic;  ///< which layers are images at `dpi`
};

/// Exports a picture as PDF 1.7: one page that shows the picture's viewport (docs/pdf.md).
///
/// Colours and opacities are triangle meshes with linear colours; a triangle is called a facet.
/// Curves are antialiased. Each layer is stored once however often it is painted. `notes`, unless
/// null, receives the number of facets, and how many layers PdfFlatten::automatic stored as pixels.
///
/// Errors: bad_input (an empty viewport, an invalid picture, options that are not positive
/// numbers), limit (memory, pixels), cancelled, out_of_memory.
/// Memory: about 40 bytes a facet of the largest layer, and the file. Cost: 2 µs a facet.
Result<std::vector<std::uint8_t>> export_pdf(Context& context, const Picture& picture,
                                             const PdfOptions& options,
                                             ExportNotes* notes = nullptr);

}  // namespace sfumato
