#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/output_buffer.hpp"
#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::codecs {

/// Encodes base64 (RFC 4648, section 4) on one line, padded, and computes its length.
std::string encode_base64(std::span<const std::uint8_t> bytes);
std::size_t base64_length(std::size_t byte_count);

/// Appends the base64 of bytes in parts and polls the cancel flag before each.
void append_base64(const Context& context, std::span<const std::uint8_t> bytes, OutputBuffer& text);

/// Writes the base64 of bytes to a table of `memory`. Errors: limit (memory), cancelled.
Status append_base64(const Context& context, std::span<const std::uint8_t> bytes,
                     TableMemory& memory, std::string& text);

/// Decodes base64 (RFC 4648, section 4) into `bytes`, which must be empty; blanks are skipped,
/// padding may be missing. Errors: bad_input, limit, cancelled, without a place.
Status decode_base64(const Context& context, std::string_view text, TableMemory& memory,
                     std::vector<std::uint8_t>& bytes);

/// Decodes percent codes such as %41; a percent sign without two digits is kept.
std::vector<std::uint8_t> decode_percent(std::string_view text);

/// Decodes "data:[type][;base64],…" (RFC 2397) into `bytes`, which must be empty. Blanks in base64
/// may be percent-coded too. Errors: bad_input, limit, cancelled, without a place.
Status decode_data_uri(const Context& context, std::string_view uri, TableMemory& memory,
                       std::vector<std::uint8_t>& bytes);

}  // namespace sfumato::codecs
