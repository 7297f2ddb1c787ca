#pragma once

#include <cstdint>
#include <vector>

#include "options/output_kind.hpp"
#include "options/settings.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato::output {

/// Returns the format with alpha and the same number of bits.
PixelFormat with_alpha(PixelFormat format);

/// Returns the format for drawing an output of this kind: with alpha if the kind always has it, or
/// if there is no background. format: settled.
PixelFormat drawn_format(PixelFormat format, options::OutputKind kind, bool has_background);

/// Returns whether an output loses its alpha channel if the image is opaque everywhere.
bool drops_opaque_alpha(const options::Settings& settings, options::OutputKind kind);

/// Returns the format for drawing such an output: without alpha if the picture is certainly opaque.
PixelFormat needed_format(PixelFormat format, const Picture& picture, const Box& viewport);

/// Removes the alpha channel if the image is opaque everywhere. Errors: cancelled.
Status drop_opaque_alpha(Context& context, Image& image);

/// Encodes an image as a file of a pixel format, or as a raw frame. options: settled. Errors:
/// limit, out_of_memory, cancelled.
Result<std::vector<std::uint8_t>> encode_image(Context& context, const Image& image,
                                               options::OutputKind kind,
                                               const options::OutputOptions& options);

}  // namespace sfumato::output
