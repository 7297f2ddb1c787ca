#include "output/export_vector.hpp"

#include <algorithm>

#include "sfumato/export/pdf/pdf.hpp"
#include "sfumato/export/svg/svg.hpp"

namespace sfumato::output {
namespace {

using Bytes = std::vector<std::uint8_t>;

Result<Bytes> make_svg(Context& context, const Picture& picture, const DrawingOptions& drawing,
                       ExportNotes* notes) {
  SvgOptions options{.mode = drawing.output.svg.value_or(SvgMode::image),
                     .force = drawing.output.force};
  options.scale = drawing.scale;
  options.dpi = drawing.output.dpi.value_or(options.dpi);
  options.max_error = std::max(options.max_error, drawing.max_error);
  return export_svg(context, picture, options, notes);
}

Result<Bytes> make_pdf(Context& context, const Picture& picture, const DrawingOptions& drawing,
                       ExportNotes* notes) {
  const options::OutputOptions& output = drawing.output;
  PdfOptions options{.title = output.title, .flatten = output.pdf_flatten};
  options.dpi = output.dpi.value_or(options.dpi);
  options.page_width_pt = page_width_pt(picture, drawing);
  return export_pdf(context, picture, options, notes);
}

}  // namespace

double page_width_pt(const Picture& picture, const DrawingOptions& drawing) {
  return 0.75 * drawing.scale * picture.viewport.width();
}

Result<Bytes> export_vector(Context& context, const Picture& picture, const DrawingOptions& drawing,
                            ExportNotes* notes) {
  const bool is_pdf = drawing.kind == options::OutputKind::pdf;
  return is_pdf ? make_pdf(context, picture, drawing, notes)
                : make_svg(context, picture, drawing, notes);
}

}  // namespace sfumato::output
