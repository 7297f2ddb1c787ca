#include "capi/pictures/export_file.hpp"

#include <utility>

#include "base/charge.hpp"
#include "base/try.hpp"
#include "capi/bytes.hpp"
#include "capi/documents/read_options.hpp"
#include "options/settle.hpp"
#include "output/output_size.hpp"

namespace sfumato::capi {
namespace {

using options::OutputKind;

constexpr const char* kDefaultTitle = "Sfumato";

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
Result<FileBytes> make_drawing(Context& context, const sfumato_picture& handle, OutputKind kind,
                               const options::Settings& settings, Exporter exporter,
                               ExportNotes& notes) {
  const Picture& picture = handle.picture();
  output::DrawingOptions drawing{kind, settings.output};
  drawing.scale = output::output_scale(settings.size, picture.viewport, handle.own_scale);
  drawing.max_error = handle.settings.diffuse.max_error;
  if (drawing.output.title.empty()) drawing.output.title = kDefaultTitle;
  const std::optional<Rgb> background = background_of(settings, kind, picture);
  const bool is_exact = kind == OutputKind::html && handle.solution;
  if (background == picture.background && !is_exact) {
    return exporter(context, picture, drawing, &notes);
  }
  ScopedCharge charge;
  SFUMATO_TRY(charge.add(context, bytes_of(picture), "a copy of the picture"));
  Picture copy = picture;
  copy.background = background;
  if (is_exact) SFUMATO_TRY(add_exact_layers(context, *handle.solution, charge, copy));
  return exporter(context, copy, drawing, &notes);
}

}  // namespace

Outcome hand_out_bytes(Result<FileBytes> file, sfumato_bytes** out) {
  SFUMATO_TRY(file);
  *out = new sfumato_bytes{std::move(*file)};
  return {};
}

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

std::optional<Rgb> background_of(const options::Settings& settings, OutputKind kind,
                                 const Picture& picture) {
  std::optional<Rgb> background = picture.background;
  if (settings.raster.background) background = settings.raster.background;
  if (settings.no_background) background.reset();
  return !options::knows_alpha(kind) && !background ? Rgb{1, 1, 1} : background;
}

Outcome export_drawing(sfumato_context* context, const sfumato_picture& handle, OutputKind kind,
                       const options::Settings& settings, Exporter exporter, sfumato_bytes** out) {
  ExportNotes notes;
  Result<FileBytes> file =
      make_drawing(context->workshop->context, handle, kind, settings, exporter, notes);
  if (file) context->warnings = std::move(notes.lost);
  return hand_out_bytes(std::move(file), out);
}

}  // namespace sfumato::capi
