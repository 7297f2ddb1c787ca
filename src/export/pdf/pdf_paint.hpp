#pragma once

#include "export/facets/facets.hpp"
#include "export/pdf/pdf_content.hpp"
#include "export/pdf/pdf_file.hpp"
#include "export/pixel_part.hpp"
#include "sfumato/export/export_notes.hpp"

/// The objects of a PDF's pictures.
namespace sfumato::outputs {

/// A mesh as a shading; 0 if it has no facets. `box` contains its vertices.
PdfRef add_mesh(Context& context, PdfFile* file, const FacetMesh& mesh, const Box& box);

/// Paints a shading twice, the first time moved by `shift` in both directions, because some viewers
/// skip pixels on scanlines through vertices.
void paint_mesh(PdfRef mesh, double shift, PdfContent* content);

/// The colours of an image, three bytes per pixel; its alpha, if any, as its soft mask.
PdfRef add_image(Context& context, PdfFile* file, const Image& image);
/// The alpha of rgba8 alone, as a grey image.
PdfRef add_alpha_image(Context& context, PdfFile* file, const Image& image);

/// Fills `box` with an image; y points down in the frame of the content.
void paint_image(PdfRef image, const Box& box, PdfContent* content);

/// A graphics state whose soft mask is the luminosity of a form of make_mask_form.
PdfRef add_mask(PdfFile* file, PdfRef mask_form);

/// A graphics state for an item that is composited as a whole.
PdfRef add_compositing(PdfFile* file, float opacity, BlendMode blend);

}  // namespace sfumato::outputs
