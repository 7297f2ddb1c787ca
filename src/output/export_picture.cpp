#include "output/export_picture.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/try.hpp"
#include "output/export_vector.hpp"
#include "sfumato/codecs/jpeg_encode.hpp"
#include "sfumato/codecs/png.hpp"
#include "sfumato/export/eps/eps.hpp"
#include "sfumato/export/glb/glb.hpp"
#include "sfumato/export/html/html.hpp"
#include "sfumato/export/tables/tables.hpp"
#include "sfumato/raster/rasterize.hpp"

namespace sfumato::output {
namespace {

using Bytes = std::vector<std::uint8_t>;
using options::OutputKind;

/// The longer side in pixels, and the quality, of the picture for browsers without WebGL 2. It
/// fills the window as the drawing would, whatever the size of the window.
#if defined(__wasm__)
constexpr int kFallbackSide = 320;  // as a PNG, which is larger
constexpr const char* kFallbackType = "image/png";
#else
constexpr int kFallbackSide = 640;
constexpr int kFallbackQuality = 80;
constexpr const char* kFallbackType = "image/jpeg";
#endif
/// The most pixels that all items of the stack paint together, about a second of work. A picture of
/// many items is smaller.
constexpr double kMostFallbackPixels = 3e8;
constexpr double kLeastFallbackSide = 64;

Result<Bytes> encode_fallback(Context& context, const Image& image) {
#if defined(__wasm__)
  return encode_png(context, image);
#else
  return encode_jpeg(context, image, kFallbackQuality);
#endif
}

Result<Bytes> make_html(Context& context, const Picture& picture, const std::string& title,
                        ExportNotes* notes) {
  RasterOptions small;
  const Box& viewport = picture.viewport;
  const double items = std::max<double>(1, static_cast<double>(picture.stack.size()));
  const double side =
      std::clamp(std::sqrt(kMostFallbackPixels / items), kLeastFallbackSide, kFallbackSide * 1.0);
  const double scale = side / std::max(viewport.width(), viewport.height());
  small.width = std::max(1, static_cast<int>(std::round(viewport.width() * scale)));
  small.height = std::max(1, static_cast<int>(std::round(viewport.height() * scale)));
  SFUMATO_TRY_ASSIGN(const Image& image, rasterize(context, picture, small));
  SFUMATO_TRY_ASSIGN(auto&& fallback, encode_fallback(context, image));
  return export_html(
      context, picture,
      {.title = title, .fallback = std::move(fallback), .fallback_type = kFallbackType}, notes);
}

}  // namespace

Result<Bytes> export_picture(Context& context, const Picture& picture,
                             const DrawingOptions& drawing, ExportNotes* notes) {
  const options::OutputOptions& output = drawing.output;
  switch (drawing.kind) {
    case OutputKind::html:
      return make_html(context, picture, output.title, notes);
    case OutputKind::eps: {
      EpsOptions options{.title = output.title};
      options.dpi = output.dpi.value_or(options.dpi);
      options.page_width_pt = page_width_pt(picture, drawing);
      return export_eps(context, picture, options, notes);
    }
    case OutputKind::glb: {
      GlbOptions options;
      options.dpi = output.dpi.value_or(options.dpi);
      return export_glb(context, picture, options, notes);
    }
    case OutputKind::sfv:
      return export_sfv(context, picture, {}, notes);
    case OutputKind::npz:
      return export_npz(context, picture, notes);
    case OutputKind::ply:
      return export_ply(context, picture, notes);
    case OutputKind::json:
      return export_json(context, picture, notes);
    default:
      return export_vector(context, picture, drawing, notes);
  }
}

}  // namespace sfumato::output
