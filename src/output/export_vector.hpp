#pragma once

#include <cstdint>
#include <vector>

#include "output/export_picture.hpp"

namespace sfumato::output {

/// Returns the width of the page that a picture fills, points.
double page_width_pt(const Picture& picture, const DrawingOptions& drawing);

/// export_picture() for PDF and SVG alone. It needs no other exporters, which a module for browsers
/// leaves out.
Result<std::vector<std::uint8_t>> export_vector(Context& context, const Picture& picture,
                                                const DrawingOptions& drawing, ExportNotes* notes);

}  // namespace sfumato::output
