#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/output_buffer.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/shader.hpp"

namespace sfumato::codecs {

/// "image/png" or "image/jpeg" by a file's first bytes; empty if it is neither.
std::string_view image_media_type(std::span<const std::uint8_t> file);

/// A texture's texels as PNG. Errors: limit, cancelled; in WebAssembly, which has no encoder,
/// unavailable.
Result<std::vector<std::uint8_t>> texture_png(Context& context, const Texture& texture);

/// Appends "data:TYPE;base64,…" on one line.
void append_data_uri(const Context& context, std::string_view media_type,
                     std::span<const std::uint8_t> bytes, OutputBuffer& text);

/// The texture's own file if it is a PNG or JPEG, else its texels encoded as PNG. The text is
/// charged to `memory`. Errors: those of texture_png.
Result<std::string> data_uri(Context& context, const Texture& texture, TableMemory& memory);

}  // namespace sfumato::codecs
