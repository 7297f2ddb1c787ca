#if defined(__x86_64__)

#include "raster/kernels/texture_kernel.hpp"

namespace sfumato::raster {

const TextureKernels kTextureKernelsAvx2{magnify_texture<8>, minify_texture<8>};

}  // namespace sfumato::raster

#endif
