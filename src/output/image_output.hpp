#pragma once

#include <cstdint>
#include <vector>

#include "options/output_kind.hpp"
#include "options/settings.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::output {

/// The format with alpha and the same number of bits.
PixelFormat with_alpha(PixelFormat format);

/// Removes the alpha channel if the image is opaque everywhere. Errors: cancelled.
Status drop_opaque_alpha(Context& context, Image& image);

/// Encodes an image as a file of a pixel format. options: settled. Errors: limit, out_of_memory,
/// cancelled.
Result<std::vector<std::uint8_t>> encode_image(Context& context, const Image& image,
                                               options::OutputKind kind,
                                               const options::OutputOptions& options);

}  // namespace sfumato::output
