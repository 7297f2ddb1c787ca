#include "raster/quantize_kernel.hpp"
#include "raster/span_kernel.hpp"
#include "raster/span_kernels.hpp"

namespace sfumato::raster {

const SpanKernels kSpanKernelsBase{draw_triangles<4>, write_pixels<4>};

}  // namespace sfumato::raster
