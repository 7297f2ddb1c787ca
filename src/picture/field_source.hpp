#pragma once

#include <cstdint>
#include <vector>

#include "base/pixel_rect.hpp"
#include "sfumato/base/affine.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::picture {

/// A layer's fields at pixel centres, row by row. Channels as in PatchLayer.
struct FieldPixels {
  std::vector<float> color;       ///< color.channel_count floats a pixel
  std::vector<float> opacity;     ///< opacity.channel_count floats a pixel; empty: opaque
  std::vector<std::uint8_t> hit;  ///< 0: no colour is seen, the pixel is transparent
};

/// A source of the fields of layers, used instead of their patches. Called from several threads.
class FieldSource {
 public:
  virtual ~FieldSource() = default;

  /// Returns the fields of Picture::layers[layer] at the pixel centres of `rect`.
  virtual Status read(std::uint32_t layer, const Affine& layer_from_image, const PixelRect& rect,
                      FieldPixels* out) const = 0;
};

}  // namespace sfumato::picture
