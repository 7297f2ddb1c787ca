#pragma once

#include <webp/encode.h>

#include <cstddef>

#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::codecs {

/// Copies pixels to a picture of libwebp in parts, because the library's own functions take a whole
/// image at once and cannot check the cancel flag. The picture's width and height are already set.
/// Errors: out_of_memory, cancelled.

/// ARGB, for lossless encoding.
Status import_argb(Context& context, const Image& image, WebPPicture& picture);

/// Luma, and chroma at half resolution by libwebp's "sharp" conversion, which prevents dark edges;
/// alpha if any pixel is not opaque. Each part is converted until it converges, at most four
/// rounds. Runs on the pool; the parts, and so the bits, do not depend on the number of threads.
Status import_yuv(Context& context, const Image& image, WebPPicture& picture);

/// Bytes that import_yuv allocates for its parts on `thread_count` threads, in addition to the
/// picture.
std::size_t import_bytes(int thread_count);

}  // namespace sfumato::codecs
