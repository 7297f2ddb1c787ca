#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/charge.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato::outputs {

/// Items of a picture's stack as pixels, for formats that cannot store them otherwise.
struct PixelRun {
  Box box;  ///< the area of the pixels, artboard frame; empty: nothing is visible
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> png;  ///< with alpha
  ScopedCharge charge;            ///< for the file
};

/// Returns whether an item cannot be shown by meshes of colours: a local curve, or a layer filled
/// by image-domain shaders.
bool needs_pixels(const Picture& picture, const PictureItem& item);

/// Returns the end of the run of items from `first` on that one image can replace; the item `first`
/// needs pixels. An item with a blend mode other than normal is a run of its own.
std::size_t pixel_run_end(const Picture& picture, std::size_t first);

/// The blend mode with which the image of a run is to be painted.
BlendMode run_blend(const Picture& picture, std::size_t first);

/// Paints the items [first, last) of such a run onto transparency, on the grid of pixels that
/// begins at the viewport's upper left corner. Precondition: picture::check_picture() has accepted
/// the picture. Errors: limit (size, memory), cancelled. Memory: a copy of the layers, and the
/// pixels.
Result<PixelRun> paint_run(Context& context, const Picture& picture, std::size_t first,
                           std::size_t last, double pixels_per_unit);

}  // namespace sfumato::outputs
