#include "raster/kernels/local_stroke_kernel.hpp"

namespace sfumato::raster {

const StrokeKernels kStrokeKernelsBase{add_stroke_segments<4>, finish_stroke<4>};

}  // namespace sfumato::raster
