#include <cstdint>
#include <utility>
#include <vector>

#include "base/try.hpp"
#include "capi/bytes.hpp"
#include "capi/documents/read_options.hpp"
#include "capi/pictures/picture.hpp"
#include "export/html/viewer_exact.hpp"
#include "export/html/viewer_payload.hpp"
#include "options/tables.hpp"

namespace sfumato::capi {
namespace {

using Writer = Result<std::vector<std::uint8_t>> (*)(Context&, const Picture&, const Rgb&);

Outcome make_payload(Writer write, Workshop& workshop, const sfumato_picture* handle,
                     const char* text, sfumato_bytes** out) {
  if (!handle) return bad_usage("NULL given; pass a picture");
  options::Settings settings;
  SFUMATO_TRY(read_options(text, options::kPayload, options::render_options(), settings));
  const Picture& picture = handle->picture();
  const Rgb background = settings.no_background
                             ? Rgb{1, 1, 1}
                             : outputs::viewer_background(picture, settings.raster.background);
  SFUMATO_TRY_ASSIGN(auto&& payload, write(workshop.context, picture, background));
  *out = new sfumato_bytes{std::move(payload)};
  return {};
}

Outcome make_exact_layer(Context& context, const sfumato_picture* handle, std::uint32_t layer,
                         sfumato_bytes** out) {
  if (!handle) return bad_usage("NULL given; pass a picture");
  if (!handle->solution) return no_solution();
  SFUMATO_TRY_ASSIGN(const ExactLayer& exact, handle->solution->exact_layer(context, layer));
  ScopedCharge charge;
  SFUMATO_TRY(charge.add(context, bytes_of(exact), "exact fields"));
  SFUMATO_TRY_ASSIGN(auto&& bytes,
                     outputs::exact_alone(context, exact, handle->picture().interpolation));
  *out = new sfumato_bytes{std::move(bytes)};
  return {};
}

}  // namespace
}  // namespace sfumato::capi

int32_t sfumato_exact_layer(sfumato_context* context, const sfumato_picture* picture,
                            uint32_t layer, sfumato_bytes** bytes) {
  return sfumato::capi::make(context, bytes, [&](sfumato::capi::Workshop& workshop) {
    return sfumato::capi::make_exact_layer(workshop.context, picture, layer, bytes);
  });
}

int32_t sfumato_viewer_payload(sfumato_context* context, const sfumato_picture* picture,
                               const char* options, sfumato_bytes** bytes) {
  return sfumato::capi::make(context, bytes, [&](sfumato::capi::Workshop& workshop) {
    return sfumato::capi::make_payload(sfumato::outputs::viewer_payload, workshop, picture, options,
                                       bytes);
  });
}

int32_t sfumato_picture_stack(sfumato_context* context, const sfumato_picture* picture,
                              const char* options, sfumato_bytes** bytes) {
  return sfumato::capi::make(context, bytes, [&](sfumato::capi::Workshop& workshop) {
    return sfumato::capi::make_payload(sfumato::outputs::viewer_stack, workshop, picture, options,
                                       bytes);
  });
}
