// Documents to pictures of 64 × 64 pixels and to PNG, with the same bytes on every instruction set:
// by patches, by rays, or gathered at every pixel of 16 × 16.
#include <algorithm>
#include <vector>

#include "drawn_document.hpp"
#include "fuzz.hpp"
#include "sfumato/api/render_pixels.hpp"
#include "sfumato/codecs/png.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/lint/lint.hpp"
#include "sfumato/raster/rasterize.hpp"
#include "sfumato/solve/diffuse.hpp"

using namespace sfumato;

namespace {

constexpr int kSide = 64;
constexpr int kGatheredSide = 16;
constexpr int kRays = 8;
/// The targets of the readers cover larger documents, which would only take time here.
constexpr std::size_t kCurves = 8;
constexpr std::size_t kItems = 12;

bool is_small(const Document& document) {
  std::size_t curves = 0;
  for (const Layer& layer : document.layers) curves += layer.curves.size();
  return curves <= kCurves && document.stack.size() <= kItems;
}

/// `way`: how to draw, 0 to 7; from 3 on by patches with default options.
Result<Image> drawn(Context& context, const Document& document, std::size_t way) {
  DiffuseOptions options;
  options.pixels_per_unit = kSide / std::max(document.artboard.width(), document.artboard.height());
  options.max_error = 8;
  RasterOptions raster{.width = kSide, .height = kSide, .format = PixelFormat::rgba8};
  if (way == 0) {
    raster.width = raster.height = kGatheredSide;
    return render_pixels(context, document, options, raster);
  }
  if (way == 1) {
    options.gather.method = gather::Method::rays;
    options.gather.rays_per_node = kRays;
    options.order = PatchOrder::linear;
  }
  if (way == 2) {
    raster.dither = raster.mesh_overlay = true;
    raster.antialias = false;
    raster.background = Rgb{1, 0.5f, 0};
    options.order = PatchOrder::quadratic;
  }
  const Result<Picture> solved = diffuse(context, document, options);
  if (!solved) return solved.status();
  return rasterize(context, *solved, raster);
}

void check_png(Context& context, const Image& image) {
  const Result<std::vector<std::uint8_t>> png = encode_png(context, image);
  fuzz::require_ok(png.status(), "a picture that is no PNG");
  const Result<Image> again = decode_png(context, *png, "again.png");
  fuzz::require_ok(again.status(), "a PNG that cannot be read");
  fuzz::require(again->bytes == image.bytes, "a picture changed on its way through a file");
}

void check_plain(const Document& document, std::size_t way, const Image& image) {
  Context context{.budget = Budget(fuzz::kBudgetBytes), .simd = SimdLevel::sse2};
  const Result<Image> same = drawn(context, document, way);
  fuzz::require_ok(same.status(), "one instruction set draws, another does not");
  fuzz::require(same->bytes == image.bytes, "two instruction sets draw different pictures");
}

void check_lint(Context& context, const Document& document) {
  const Result<std::vector<Hint>> hints = lint(context, document);
  if (!hints) return fuzz::require_honest(hints.status());
  for (const Hint& hint : *hints) fuzz::require(!hint.message.empty(), "a hint that says nothing");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Context context{.budget = Budget(fuzz::kBudgetBytes)};
  const std::optional<Document> document = fuzz::drawn_document(context, {data, size});
  if (!document || !is_small(*document)) return 0;
  fuzz::require_ok(validate(context, *document), "a document that is not valid");
  {
    const std::size_t way = size % 8;
    const Result<Image> image = drawn(context, *document, way);
    if (!image) {
      fuzz::require_honest(image.status());
      return 0;
    }
    check_png(context, *image);
    if (way == 3) check_lint(context, *document);
    // This takes as long again; a quarter of the inputs finds as much.
    if (size / 8 % 4 == 0) check_plain(*document, way, *image);
  }
  fuzz::require(context.budget.used() == 0, "a picture keeps what it charged");
  return 0;
}
