#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "base/charge.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"

namespace sfumato::tracing {

/// Returns a drawing as it is rendered, in rgba16, its artboard over an image of this size.
/// max_error   as DiffuseOptions::max_error
/// charge      for the image's bytes; its earlier amount is released
/// Errors      limit, cancelled
/// Progress    not reported
/// Cost        diffuse() and rasterize() of the drawing
Result<Image> drawn_image(Context& context, const Document& drawing, int width, int height,
                          double max_error, ScopedCharge& charge);

/// Access to an image in rgba16.
inline float wide_value(const Image& image, std::size_t pixel, std::size_t channel) {
  std::uint16_t value;
  std::memcpy(&value, image.bytes.data() + 2 * (4 * pixel + channel), sizeof value);
  return static_cast<float>(value) / 65535.0f;
}

}  // namespace sfumato::tracing
