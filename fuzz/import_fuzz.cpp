// Converts ordinary SVG to diffusion curves, as `sfumato init --from` does.
#include <string>

#include "fuzz.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/formats/read_document.hpp"
#include "sfumato/formats/svg/svg_write.hpp"
#include "sfumato/import/import_svg.hpp"

using namespace sfumato;

namespace {

/// Requires that the result is valid, and can be written as a drawing.
void check(Context& context, const ImportedSvg& made) {
  fuzz::require_ok(validate(context, made.document), "a document that is not valid");
  fuzz::require(made.warnings.size() <= limits::kWarnings + 1, "too many warnings");
  const Result<std::string> text = write_svg(context, made.document);
  if (!text) {
    fuzz::require_honest(text.status());
    return;
  }
  const Result<ReadDocument> again = read_document(context, *text, "made.svg");
  if (!again) fuzz::require_honest(again.status());
  if (!again && again.status().code == StatusCode::bad_input) {
    fuzz::require_ok(again.status(), "a drawing that cannot be read");
  }
}

/// Replaces the solver, which has its own targets: a tile is a valid document, and its image has
/// transparent parts.
Result<Image> painted(Context& context, const Document& tile, int width, int height) {
  fuzz::require_ok(validate(context, tile), "a tile that is not valid");
  fuzz::require(width > 0 && height > 0, "a tile without texels");
  const auto bytes = 4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  Image image;
  image.width = width;
  image.height = height;
  image.format = PixelFormat::rgba8;
  image.bytes.resize(bytes);
  for (std::size_t i = 0; i < bytes; ++i) image.bytes[i] = static_cast<std::uint8_t>(37 * i);
  return image;
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Context context{.budget = Budget(fuzz::kBudgetBytes)};
  {
    const Result<ImportedSvg> made =
        import_svg(context, fuzz::as_text({data, size}), "fuzz.svg", nullptr,
                   [](auto&&... tile) { return painted(tile...); });
    if (made) {
      check(context, *made);
    } else {
      fuzz::require_honest(made.status());
    }
  }
  fuzz::require(context.budget.used() == 0, "the import keeps what it charged");
  return 0;
}
