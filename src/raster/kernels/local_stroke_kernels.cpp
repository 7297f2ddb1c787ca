#include "raster/kernels/local_stroke_kernels.hpp"

namespace sfumato::raster {

const StrokeKernels& stroke_kernels(SimdLevel level) {
#if defined(__x86_64__)
  if (level == SimdLevel::avx512) return kStrokeKernelsAvx512;
  if (level == SimdLevel::avx2) return kStrokeKernelsAvx2;
#endif
  static_cast<void>(level);
  return kStrokeKernelsBase;
}

}  // namespace sfumato::raster
