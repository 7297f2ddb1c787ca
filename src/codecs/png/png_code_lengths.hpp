#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "codecs/png/png_bits.hpp"
#include "codecs/png/png_huffman.hpp"

namespace sfumato::codecs {

/// The head of a deflate block with its own codes (RFC 1951, 3.2.7): the lengths of the code words,
/// in runs, in a Huffman code that precedes them. The code of distances has two words of one bit:
/// matches are at distance 1 alone, but some readers refuse a code of one word.
class CodeLengths {
 public:
  /// words: for literals, the end of a block and lengths. They include a word for the end.
  explicit CodeLengths(std::span<const HuffmanWord> words);

  std::size_t bit_count() const;
  void write(BitWriter& bits) const;

 private:
  static constexpr std::size_t kSymbols = 19;
  static constexpr std::size_t kDistances = 2;
  static constexpr std::size_t kMostLengths = kMostHuffmanSymbols + kDistances;

  /// A length, or the number of repetitions of one.
  struct Item {
    std::uint8_t symbol, extra;
  };

  static int extra_bits(std::size_t symbol);
  void add(std::size_t symbol, std::size_t extra = 0);
  void add_run(std::size_t length, std::size_t count);

  std::array<Item, kMostLengths> items_;
  std::size_t item_count_ = 0;
  std::array<HuffmanWord, kSymbols> item_words_;
  std::size_t literal_count_ = 0;
  std::size_t listed_count_ = kSymbols;  ///< of item_words_, in the order of the head
};

}  // namespace sfumato::codecs
