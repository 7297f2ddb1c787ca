#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/charge.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato::outputs {

/// Items of a picture's stack as pixels, for formats that cannot hold them otherwise.
struct PixelRun {
  Box box;  ///< what the pixels cover, artboard frame; empty: nothing is seen
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> png;  ///< with alpha
  ScopedCharge charge;            ///< of the file
};

/// Whether an item is a local curve, or a layer that image-domain shaders fill: what meshes of
/// colours cannot show.
bool needs_pixels(const Picture& picture, const PictureItem& item);

/// The end of the run of items from `first` on, which needs pixels, that one image can stand for: a
/// blend mode other than normal stands alone.
std::size_t pixel_run_end(const Picture& picture, std::size_t first);

/// The blend mode with which the image of a run is to be painted.
BlendMode run_blend(const Picture& picture, std::size_t first);

/// Paints the items [first, last) of such a run onto nothing, on the grid of pixels that begins at
/// the viewport's upper left corner. Precondition: raster::check_picture. Errors: limit (size,
/// memory), cancelled. Memory: a copy of the layers, the pixels.
Result<PixelRun> paint_run(Context& context, const Picture& picture, std::size_t first,
                           std::size_t last, double pixels_per_unit);

}  // namespace sfumato::outputs
