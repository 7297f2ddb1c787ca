#pragma once

#include <cstdint>
#include <span>

namespace sfumato {

/// Lengths of an optimal prefix code for symbols that occur counts[i] times, shortened to at most
/// max_length bits. 0 for a symbol that does not occur. At least two symbols get a code, as deflate
/// readers like it. Ties go by symbol: the same counts give the same lengths everywhere.
///
/// counts, lengths: the same size, 2 to 65,536, and at most 2^max_length.
void code_lengths(std::span<const std::uint32_t> counts, int max_length,
                  std::span<std::uint8_t> lengths);

/// The canonical code of these lengths (RFC 1951, 3.2.2), with the first bit lowest.
void canonical_codes(std::span<const std::uint8_t> lengths, std::span<std::uint16_t> codes);

}  // namespace sfumato
