#include "sfumato/picture/picture_file.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "base/charge.hpp"
#include "base/try.hpp"
#include "capi/bytes.hpp"
#include "capi/pictures/picture.hpp"
#include "picture/picture_counts.hpp"

namespace sfumato::capi {
namespace {

Outcome write(Workshop& workshop, const sfumato_picture* handle, sfumato_bytes** out) {
  if (!handle) return bad_usage("NULL given; pass a picture");
  const PictureOrigin origin{handle->own_scale, handle->pixels_per_unit,
                             handle->settings.diffuse.max_error};
  SFUMATO_TRY_ASSIGN(auto&& bytes, write_picture(workshop.context, handle->picture(), origin));
  *out = new sfumato_bytes{std::move(bytes)};
  return {};
}

Outcome read(sfumato_context* context, const void* data, std::size_t size, sfumato_picture** out) {
  if (!data && size > 0) return bad_usage("NULL given; pass a picture file");
  const Context& work = context->workshop->context;
  PictureOrigin origin;
  Result<Picture> picture =
      read_picture(work, {static_cast<const std::uint8_t*>(data), size}, &origin);
  SFUMATO_TRY(picture);
  ScopedCharge charge;
  SFUMATO_TRY(charge.add(work, bytes_of(*picture), "a picture"));
  PictureDelta all;
  for (std::uint32_t i = 0; i < picture->layers.size(); ++i) all.layers.push_back(i);
  std::vector<ChangedRows> changed(picture->layers.size());
  note_changes(*picture, all, changed);
  auto handle =
      std::make_unique<sfumato_picture>(context->workshop, std::move(charge), std::move(*picture));
  handle->settings.diffuse.max_error = origin.max_error;
  handle->pixels_per_unit = origin.pixels_per_unit;
  handle->own_scale = origin.own_scale;
  handle->changed = std::move(changed);
  const picture::PictureCounts counts = picture::count_tables(handle->read);
  handle->stats.triangles = counts.triangles;
  handle->stats.vertices = counts.vertices;
  handle->stats.nodes = counts.nodes;
  *out = handle.release();
  return {};
}

}  // namespace
}  // namespace sfumato::capi

int32_t sfumato_picture_write(sfumato_context* context, const sfumato_picture* picture,
                              sfumato_bytes** bytes) {
  return sfumato::capi::make(context, bytes, [&](sfumato::capi::Workshop& workshop) {
    return sfumato::capi::write(workshop, picture, bytes);
  });
}

int32_t sfumato_picture_read(sfumato_context* context, const void* bytes, size_t size,
                             sfumato_picture** picture) {
  return sfumato::capi::make(context, picture, [&](sfumato::capi::Workshop&) {
    return sfumato::capi::read(context, bytes, size, picture);
  });
}
