#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace sfumato::codecs {

/// Symbols of deflate's largest alphabet: literals, the end of a block, lengths of matches.
inline constexpr std::size_t kMostHuffmanSymbols = 286;
/// Bits of the longest code word. Deflate allows 15, but four words of 14 bits fit in a machine
/// word.
inline constexpr int kMostHuffmanBits = 14;

/// A code word as it is written, with its first bit lowest.
struct HuffmanWord {
  std::uint16_t bits = 0;
  std::uint16_t bit_count = 0;  ///< 0: the symbol never occurs
};

/// Computes the canonical Huffman code (RFC 1951, 3.2.2) of symbols with these counts. No code word
/// is longer than `most_bits`: longer words are shortened at the cost of others.
///
/// counts: at least two are not 0; their sum is below 2^32. most_bits: at most kMostHuffmanBits,
/// with room for all symbols. words: written; as many as counts, at most kMostHuffmanSymbols.
void make_huffman_code(std::span<const std::uint32_t> counts, int most_bits,
                       std::span<HuffmanWord> words);

}  // namespace sfumato::codecs
