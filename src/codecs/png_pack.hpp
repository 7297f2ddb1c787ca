#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace sfumato::codecs {

/// What is packed by one Huffman code: a deflate block that may be stored holds no more.
inline constexpr std::size_t kPackBlockBytes = 65'535;

/// The room that pack_runs() asks for, more than so many bytes become.
std::size_t packed_bound(std::size_t byte_count);

/// Appends deflate blocks (RFC 1951) of which none is the last, ended on a whole byte, so that what
/// was packed apart may be joined. Repeated bytes become runs, and Huffman codes do the rest: what
/// PNG's filters leave of a smooth picture, dithered or not, hardly repeats in another way, and a
/// general packer loses time and bytes by looking for it. The same bytes on every machine.
///
/// out    has room for packed_bound(bytes.size()) more
/// Cost   about 2 ns a byte
void pack_runs(std::span<const std::uint8_t> bytes, std::vector<std::uint8_t>& out);

}  // namespace sfumato::codecs
