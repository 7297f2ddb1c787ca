#pragma once

#include <string>

#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"
#include "sfumato/raster/rasterize.hpp"

namespace sfumato {

/// Does rasterize() by OpenGL ES 3 without a window: with the shaders of the HTML viewer, on a GPU,
/// or without one by Mesa's software driver. Afterwards only the driver's libraries remain loaded.
///
/// It follows the same rules in single precision, so that a few pixels differ and the bytes depend
/// on the device; docs/gpu.md has measurements ("How near to the CPU").
///
/// Errors: as rasterize(); unavailable where there is no OpenGL ES 3, or it cannot draw to floating
/// point; limit also where a table exceeds the device's textures.
/// Memory on the device, charged to the Budget: tables of 100 to 300 bytes a triangle, 110 bytes a
/// pixel of a tile of 1024², and 16 more for each group within a group.
/// Cost: O(triangles + pixels) on the device. By Mesa's software driver about 13 times that of
/// rasterize(), and 13 ms for the context and the programs (docs/gpu.md).
Result<Image> render_on_gpu(Context& context, const Picture& picture, const RasterOptions& options);

/// Returns the name of the device that render_on_gpu() would use, from its driver. Errors:
/// unavailable, out_of_memory.
Result<std::string> gpu_name();

}  // namespace sfumato
