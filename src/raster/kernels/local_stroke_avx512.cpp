#if defined(__x86_64__)

#include "raster/kernels/local_stroke_kernel.hpp"

namespace sfumato::raster {

const StrokeKernels kStrokeKernelsAvx512{add_stroke_segments<16>, finish_stroke<16>};

}  // namespace sfumato::raster

#endif
