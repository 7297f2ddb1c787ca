#pragma once

#include <string>

#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"
#include "sfumato/raster/rasterize.hpp"

namespace sfumato {

/// rasterize() by OpenGL ES 3 without a window: the shaders of the viewer, on a GPU or, where there
/// is none, Mesa's software driver. Nothing stays behind but the driver's libraries.
///
/// By the same rules, in single precision: docs/gpu.md says how near ("How near to the CPU").
///
/// Errors: those of rasterize(), and unavailable: no context of OpenGL ES 3 can be had, or it
/// cannot draw to floating point; limit also where a table is more than the device's textures hold.
/// Memory: of the device's, charged here: tables of 100 to 300 bytes a triangle, 110 bytes a pixel
/// of a tile of 1024², 16 more for each group within a group.
Result<Image> render_on_gpu(Context& context, const Picture& picture, const RasterOptions& options);

/// The device that render_on_gpu would use, in its driver's words. Errors: unavailable.
Result<std::string> gpu_name();

}  // namespace sfumato
