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

/// Copies ARGB, for lossless encoding.
Status import_argb(Context& context, const Image& image, WebPPicture& picture);

/// Converts to luma, and to chroma at half resolution by libwebp's "sharp" conversion, which
/// prevents dark edges; adds alpha if any pixel is not opaque. Each part is converted until it
/// converges, in at most four rounds. Runs on the pool. The parts, and therefore the bits, do not
/// depend on the number of threads.
Status import_yuv(Context& context, const Image& image, WebPPicture& picture);

/// Returns the bytes that import_yuv allocates for its parts on `thread_count` threads, in addition
/// to the picture.
std::size_t import_bytes(int thread_count);

}  // namespace sfumato::codecs
