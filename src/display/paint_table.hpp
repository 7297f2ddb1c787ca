#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/table_memory.hpp"
#include "sfumato/base/affine.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato::display {

/// The gradients and textures of a picture in the layout that the shaders of web/viewer/shaders
/// read (docs/gpu.md, "The table of paints").
struct PaintTable {
  std::vector<float> values;               ///< four to a texel of `paint_table`
  std::size_t texel_count = 0;             ///< of `paint_texels`
  std::vector<std::uint16_t> texels;       ///< four to a texel; empty unless kept
  std::vector<std::uint32_t> first_value;  ///< per shader of the picture: its first texel
  std::vector<Affine> paint_from_layer;    ///< per shader
  TableMemory memory{"the table of paints"};
};

/// Whether a table contains the texels of its textures or only their number. The viewer of a page
/// makes the texels from the textures' files.
enum class PaintTexels : bool { counted, kept };

/// Makes the table of the shaders that a layer uses; the others have no values.
///
/// Precondition: picture::check_picture() has accepted the picture.
/// Errors: limit (memory), cancelled. Cost: O(stops + texels).
Result<PaintTable> make_paint_table(Context& context, const Picture& picture, PaintTexels texels);

}  // namespace sfumato::display
