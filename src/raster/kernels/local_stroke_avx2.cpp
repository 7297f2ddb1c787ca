#if defined(__x86_64__)

#include "raster/kernels/local_stroke_kernel.hpp"

namespace sfumato::raster {

const StrokeKernels kStrokeKernelsAvx2{add_stroke_segments<8>, finish_stroke<8>};

}  // namespace sfumato::raster

#endif
