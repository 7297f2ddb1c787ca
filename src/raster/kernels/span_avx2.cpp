#if defined(__x86_64__)

#include "raster/kernels/blend_kernel.hpp"
#include "raster/kernels/quantize_kernel.hpp"
#include "raster/kernels/span_kernel.hpp"
#include "raster/kernels/span_kernels.hpp"

namespace sfumato::raster {

const SpanKernels kSpanKernelsAvx2{
    place_triangles,   box_of_triangles, draw_triangles<8>, draw_color_opacity<8>, draw_weights<8>,
    finish_shading<8>, blend<8>,         unpremultiply<8>,  write_pixels<8>};

}  // namespace sfumato::raster

#endif
