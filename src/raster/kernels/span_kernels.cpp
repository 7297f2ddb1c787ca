#include "raster/kernels/span_kernels.hpp"

namespace sfumato::raster {

const SpanKernels& span_kernels(SimdLevel level) {
#if defined(__x86_64__)
  if (level == SimdLevel::avx512) return kSpanKernelsAvx512;
  if (level == SimdLevel::avx2) return kSpanKernelsAvx2;
#endif
  static_cast<void>(level);
  return kSpanKernelsBase;
}

}  // namespace sfumato::raster
