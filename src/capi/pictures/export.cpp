#include <algorithm>
#include <utility>
#include <vector>

#include "base/charge.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "capi/bytes.hpp"
#include "capi/documents/read_options.hpp"
#include "capi/pictures/file_format.hpp"
#include "capi/pictures/picture.hpp"
#include "capi/pictures/pixels.hpp"
#include "options/settle.hpp"
#include "options/tables.hpp"
#include "output/export_picture.hpp"
#include "output/image_output.hpp"
#include "output/output_size.hpp"
#include "raster/rasterize_into.hpp"

namespace sfumato::capi {
namespace {

using options::OutputKind;
using Bytes = std::vector<std::uint8_t>;

constexpr const char* kDefaultTitle = "Sfumato";

Outcome hand_out_bytes(Result<Bytes> file, sfumato_bytes** out) {
  SFUMATO_TRY(file);
  *out = new sfumato_bytes{std::move(*file)};
  return {};
}

/// Reads the options of a call that makes a file, and sets all other options to their defaults.
Outcome read_file_options(const char* text, options::Call call, OutputKind kind,
                          options::Settings& settings) {
  SFUMATO_TRY(read_options(text, call, options::render_options(), settings));
  SFUMATO_TRY(expect_none(options::find_conflict(settings, kind)));
  if (settings.diffuse.viewport && !options::is_image(kind)) {
    return bad_usage("viewport: works with images only; others show what was solved");
  }
  options::settle(settings, kind);
  return {};
}

/// Returns the background of the file: the requested one, else the document's own, else white in
/// formats without alpha.
std::optional<Rgb> background_of(const options::Settings& settings, OutputKind kind,
                                 const Picture& picture) {
  std::optional<Rgb> background = picture.background;
  if (settings.raster.background) background = settings.raster.background;
  if (settings.no_background) background.reset();
  return !options::knows_alpha(kind) && !background ? Rgb{1, 1, 1} : background;
}

Result<Bytes> make_image(Context& context, const sfumato_picture& handle, OutputKind kind,
                         const options::Settings& settings) {
  const Picture& picture = handle.picture();
  const std::optional<Rgb> background = background_of(settings, kind, picture);
  const Box viewport = settings.diffuse.viewport.value_or(picture.viewport);
  SFUMATO_TRY_ASSIGN(const output::OutputSize& size,
                     output::output_size(context.limits, settings.size, viewport, handle.own_scale,
                                         settings.window.has_value()));
  RasterOptions options = settings.raster;
  options.format = output::drawn_format(options.format, kind, background.has_value());
  const bool drops_alpha = output::drops_opaque_alpha(settings, kind);
  if (drops_alpha) options.format = output::needed_format(options.format, picture, viewport);
  options.viewport = viewport;
  output::set_size(size, settings.window, options);
  SFUMATO_TRY_ASSIGN(auto&& image, raster::rasterize_on(context, picture, options, background));
  ScopedCharge charge;
  SFUMATO_TRY(charge.add(context, capacity_bytes(image.bytes), "the image"));
  if (drops_alpha) SFUMATO_TRY(output::drop_opaque_alpha(context, image));
  return output::encode_image(context, image, kind, settings.output);
}

/// Adds the exact fields of every layer to the picture; exact pixels are computed from them.
Status add_exact_layers(Context& context, const Solution& solution, ScopedCharge& charge,
                        Picture& picture) {
  for (std::uint32_t i = 0; i < picture.layers.size(); ++i) {
    SFUMATO_TRY_ASSIGN(auto&& exact, solution.exact_layer(context, i));
    SFUMATO_TRY(charge.add(context, bytes_of(exact), "exact fields"));
    picture.layers[i].exact = std::move(exact);
  }
  return ok_status();
}

/// The exporters read everything from the picture. If it lacks something, they read a completed
/// copy.
Result<Bytes> make_drawing(Context& context, const sfumato_picture& handle, OutputKind kind,
                           const options::Settings& settings, ExportNotes& notes) {
  const Picture& picture = handle.picture();
  output::DrawingOptions drawing{kind, settings.output};
  drawing.scale = output::output_scale(settings.size, picture.viewport, handle.own_scale);
  drawing.max_error = handle.settings.diffuse.max_error;
  if (drawing.output.title.empty()) drawing.output.title = kDefaultTitle;
  const std::optional<Rgb> background = background_of(settings, kind, picture);
  const bool is_exact = kind == OutputKind::html && handle.solution;
  if (background == picture.background && !is_exact) {
    return output::export_picture(context, picture, drawing, &notes);
  }
  ScopedCharge charge;
  SFUMATO_TRY(charge.add(context, bytes_of(picture), "a copy of the picture"));
  Picture copy = picture;
  copy.background = background;
  if (is_exact) SFUMATO_TRY(add_exact_layers(context, *handle.solution, charge, copy));
  return output::export_picture(context, copy, drawing, &notes);
}

Outcome export_file(sfumato_context* context, const sfumato_picture* handle, const char* format,
                    const char* text, sfumato_bytes** out) {
  context->warnings.clear();
  if (!handle) return bad_usage("NULL given; pass a picture");
  OutputKind kind{};
  SFUMATO_TRY(read_format(format, kind));
  options::Settings settings;
  SFUMATO_TRY(read_file_options(text, options::kExport, kind, settings));
  Context& work = context->workshop->context;
  if (options::is_image(kind))
    return hand_out_bytes(make_image(work, *handle, kind, settings), out);
  ExportNotes notes;
  Result<Bytes> file = make_drawing(work, *handle, kind, settings, notes);
  if (file) context->warnings = std::move(notes.lost);
  return hand_out_bytes(std::move(file), out);
}

Outcome encode(Workshop& workshop, const sfumato_image* pixels, const char* format_name,
               const char* text, sfumato_bytes** out) {
  const std::optional<PixelFormat> format = format_of(pixels);
  if (!format) return bad_usage(kNoImage);
  OutputKind kind{};
  SFUMATO_TRY(read_format(format_name, kind));
  if (!options::is_image(kind)) return bad_usage("the format is not an image format");
  options::Settings settings;
  SFUMATO_TRY(read_file_options(text, options::kEncode, kind, settings));
  TableMemory memory("the image");
  SFUMATO_TRY_ASSIGN(auto&& image, copy_image(workshop.context, *pixels, *format, memory));
  return hand_out_bytes(output::encode_image(workshop.context, image, kind, settings.output), out);
}

}  // namespace
}  // namespace sfumato::capi

int32_t sfumato_export(sfumato_context* context, const sfumato_picture* picture, const char* format,
                       const char* options, sfumato_bytes** bytes) {
  return sfumato::capi::make(context, bytes, [&](sfumato::capi::Workshop&) {
    return sfumato::capi::export_file(context, picture, format, options, bytes);
  });
}

int32_t sfumato_encode(sfumato_context* context, const sfumato_image* image, const char* format,
                       const char* options, sfumato_bytes** bytes) {
  return sfumato::capi::make(context, bytes, [&](sfumato::capi::Workshop& workshop) {
    return sfumato::capi::encode(workshop, image, format, options, bytes);
  });
}
