#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::codecs {

/// `bytes` in zlib's format (RFC 1950), level 9: what PDF calls FlateDecode, and a browser
/// "deflate". Errors: limit (memory), out_of_memory, cancelled. Memory: as much as the result.
Result<std::vector<std::uint8_t>> deflated(Context& context, std::span<const std::uint8_t> bytes);

}  // namespace sfumato::codecs
