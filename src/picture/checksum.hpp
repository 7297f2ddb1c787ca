#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::picture {

/// XXH64 (Yann Collet), the checksum of picture files, with seed 0. It keeps up with reading, as
/// zlib's CRC-32 would not, and compiles to WebAssembly as it is, where no library is. Error:
/// cancelled.
Result<std::uint64_t> checksum(const Context& context, std::span<const std::uint8_t> bytes);

}  // namespace sfumato::picture
