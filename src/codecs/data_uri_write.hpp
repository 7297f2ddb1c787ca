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

/// Returns "image/png" or "image/jpeg" by a file's first bytes; empty if it is neither.
std::string_view image_media_type(std::span<const std::uint8_t> file);

/// Returns a texture's texels as PNG. Errors: limit, cancelled; unavailable in WebAssembly, which
/// has no encoder.
Result<std::vector<std::uint8_t>> texture_png(Context& context, const Texture& texture);

/// Appends "data:TYPE;base64,…" on one line.
void append_data_uri(const Context& context, std::string_view media_type,
                     std::span<const std::uint8_t> bytes, OutputBuffer& text);

/// Returns the texture's own file if it is a PNG or JPEG, else its texels encoded as PNG. The text
/// is charged to `memory`. Errors: as texture_png.
Result<std::string> data_uri(Context& context, const Texture& texture, TableMemory& memory);

}  // namespace sfumato::codecs
