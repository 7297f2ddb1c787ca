#if defined(__x86_64__)

#include "raster/kernels/texture_kernel.hpp"

namespace sfumato::raster {

const TextureKernels kTextureKernelsAvx512{magnify_texture<16>, minify_texture<16>};

}  // namespace sfumato::raster

#endif
