#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "base/context.hpp"
#include "base/status.hpp"
#include "document/shader.hpp"

namespace sfumato {

/// "image/png" or "image/jpeg" by a file's first bytes; empty where it is neither.
std::string_view image_media_type(std::span<const std::uint8_t> file);

/// "data:TYPE;base64,…" on one line.
std::string data_uri(std::string_view media_type, std::span<const std::uint8_t> bytes);

/// The texture's own file where it is a PNG or JPEG, else its texels encoded as PNG.
/// Errors: limit, cancelled; in WebAssembly, which has no encoder, bad_input where one is needed.
Result<std::string> data_uri(Context& context, const Texture& texture);

}  // namespace sfumato
