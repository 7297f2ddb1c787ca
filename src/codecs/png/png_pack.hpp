#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace sfumato::codecs {

/// The most bytes that one Huffman code packs, the largest size of a stored deflate block.
inline constexpr std::size_t kPackBlockBytes = 65'535;

/// Returns the room that pack_runs() needs for this many bytes, an upper bound of the packed size.
std::size_t packed_bound(std::size_t byte_count);

/// Appends deflate blocks (RFC 1951). No block is the last, and they end on a whole byte, so that
/// separately packed parts can be joined. Repeated bytes become runs, and Huffman codes do the
/// rest. The filtered bytes of a smooth picture, dithered or not, hardly repeat in another way, and
/// a general packer loses time and bytes by searching for repetitions. The result is the same on
/// every machine.
///
/// out: has room for packed_bound(bytes.size()) more. Cost: about 2 ns a byte.
void pack_runs(std::span<const std::uint8_t> bytes, std::vector<std::uint8_t>& out);

}  // namespace sfumato::codecs
