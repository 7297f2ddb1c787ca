#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::codecs {

/// Packs `bytes` in zlib's format (RFC 1950), level 9. PDF calls this FlateDecode, browsers
/// "deflate". The result is charged to `memory`. Errors: limit (memory), out_of_memory, cancelled.
Result<std::vector<std::uint8_t>> deflated(const Context& context,
                                           std::span<const std::uint8_t> bytes,
                                           TableMemory& memory);

/// Packs bytes as a gzip file (RFC 1952) without a name and a time, so the same input gives the
/// same bytes.
Result<std::vector<std::uint8_t>> gzipped(const Context& context,
                                          std::span<const std::uint8_t> bytes, TableMemory& memory);

}  // namespace sfumato::codecs
