#pragma once

#include <cstdint>
#include <vector>

#include "cli/arguments.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::cli {

/// The format of as many bits that has alpha.
PixelFormat with_alpha(PixelFormat format);

/// Takes the alpha channel from an image that is opaque everywhere. Errors: cancelled.
Status drop_opaque_alpha(Context& context, Image& image);

/// The file of an image, of a kind that is made of pixels. Errors: limit, out_of_memory, cancelled.
Result<std::vector<std::uint8_t>> encode_image(Context& context, const Image& image,
                                               const OutputOptions& options);

}  // namespace sfumato::cli
