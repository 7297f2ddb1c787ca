#include "raster/kernels/blend_kernel.hpp"
#include "raster/kernels/quantize_kernel.hpp"
#include "raster/kernels/span_kernel.hpp"
#include "raster/kernels/span_kernels.hpp"

namespace sfumato::raster {

const SpanKernels kSpanKernelsBase{
    place_triangles,   box_of_triangles, draw_triangles<4>, draw_color_opacity<4>, draw_weights<4>,
    finish_shading<4>, blend<4>,         unpremultiply<4>,  write_pixels<4>};

}  // namespace sfumato::raster
