#include "raster/kernels/texture_kernel.hpp"

namespace sfumato::raster {

const TextureKernels kTextureKernelsBase{magnify_texture<4>, minify_texture<4>};

}  // namespace sfumato::raster
