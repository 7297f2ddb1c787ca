#pragma once

#include <webp/encode.h>

#include <cstddef>

#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::codecs {

/// Gives a picture of libwebp its pixels, part by part: the library's own functions take a whole
/// image at once, and do not look at the cancel flag on the way. The picture has its width and
/// height. Errors: out_of_memory, cancelled.

/// ARGB, for what is lossless.
Status import_argb(Context& context, const Image& image, WebPPicture& picture);

/// Luma, and chroma at half resolution by libwebp's "sharp" conversion, which keeps edges from
/// darkening; alpha where any pixel is not opaque. The conversion runs until it has settled, four
/// rounds at the most, and stops for each part by itself. Runs on the pool; the parts, and so the
/// bits, do not depend on the number of threads.
Status import_yuv(Context& context, const Image& image, WebPPicture& picture);

/// Bytes that import_yuv takes for its parts on so many threads, beside the picture's own.
std::size_t import_bytes(int thread_count);

}  // namespace sfumato::codecs
