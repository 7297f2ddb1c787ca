#pragma once

#include <cstdint>
#include <span>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::picture {

/// Returns XXH64 (Yann Collet), the checksum of picture files, with seed 0. It is as fast as
/// reading, which zlib's CRC-32 is not, and it compiles to WebAssembly without a library. Error:
/// cancelled.
Result<std::uint64_t> checksum(const Context& context, std::span<const std::uint8_t> bytes);

}  // namespace sfumato::picture
