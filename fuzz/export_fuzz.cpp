// Writes pictures to every kind of file, small and coarse: the exporter refuses with a reason, or
// gives bytes.
#include <algorithm>
#include <string>
#include <vector>

#include "drawn_document.hpp"
#include "fuzz.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/export/eps/eps.hpp"
#include "sfumato/export/glb/glb.hpp"
#include "sfumato/export/html/html.hpp"
#include "sfumato/export/pdf/pdf.hpp"
#include "sfumato/export/svg/svg.hpp"
#include "sfumato/export/tables/tables.hpp"
#include "sfumato/solve/diffuse.hpp"

using namespace sfumato;

namespace {

constexpr double kPixels = 32;
constexpr double kMaxError = 16;
constexpr std::size_t kCurves = 12;
constexpr std::size_t kItems = 12;
constexpr std::size_t kTitleBytes = 24;

bool is_small(const Document& document) {
  std::size_t curves = 0;
  for (const Layer& layer : document.layers) curves += layer.curves.size();
  return curves <= kCurves && document.stack.size() <= kItems;
}

using File = Result<std::vector<std::uint8_t>>;

void check(const File& file) {
  if (!file) return fuzz::require_honest(file.status());
  fuzz::require(!file->empty(), "a file of no bytes");
}

/// Exports a picture. The first byte of the input chooses the file; its beginning is the title, if
/// there is one.
File exported(Context& context, const Picture& picture, unsigned kind, const std::string& title) {
  const double side = std::max(picture.artboard.width(), picture.artboard.height());
  // A page of 72 points has kPixels.
  const double points = 72, dpi = kPixels;
  switch (kind) {
    case 0:
      return export_html(context, picture, {.title = title});
    case 1:
      return export_pdf(
          context, picture,
          {.page_width_pt = points, .dpi = dpi, .max_error = kMaxError, .title = title});
    case 2:
      return export_eps(context, picture,
                        {.page_width_pt = points, .dpi = dpi, .max_error = kMaxError});
    case 3:
      return export_svg(context, picture, {.scale = kPixels / side, .dpi = 96});
    case 4:
      return export_svg(
          context, picture,
          {.mode = SvgMode::vector, .scale = kPixels / side, .dpi = 96, .max_error = kMaxError});
    case 5:
      return export_npz(context, picture);
    case 6:
      return export_json(context, picture);
    case 7:
      return export_ply(context, picture);
    default:
      return export_glb(context, picture, {.max_error = kMaxError, .dpi = 96 * kPixels / side});
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::ByteReader reader({data, size});
  const std::string title(fuzz::as_text({data, std::min(size, kTitleBytes)}));
  const unsigned kind = reader.below(9);
  Context context{.budget = Budget(fuzz::kBudgetBytes)};
  const std::optional<Document> document = fuzz::drawn_document(context, reader.rest());
  if (!document || !is_small(*document)) return 0;
  {
    DiffuseOptions options;
    options.pixels_per_unit =
        kPixels / std::max(document->artboard.width(), document->artboard.height());
    options.max_error = kMaxError;
    const Result<Picture> picture = diffuse(context, *document, options);
    if (!picture) {
      fuzz::require_honest(picture.status());
      return 0;
    }
    check(exported(context, *picture, kind, title));
  }
  fuzz::require(context.budget.used() == 0, "a picture keeps what it charged");
  return 0;
}
