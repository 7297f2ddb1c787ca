#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "codecs/png_bits.hpp"
#include "codecs/png_huffman.hpp"

namespace sfumato::codecs {

/// The head of a deflate block with codes of its own (RFC 1951, 3.2.7): the lengths of the code
/// words, in runs, in a Huffman code that goes before them. The code of distances has two words of
/// one bit, as matches are at distance 1 alone, and some readers refuse a code of one word.
class CodeLengths {
 public:
  /// words: of literals, the end of a block and lengths; a word for the end is there.
  explicit CodeLengths(std::span<const HuffmanWord> words);

  std::size_t bit_count() const;
  void write(BitWriter& bits) const;

 private:
  static constexpr std::size_t kSymbols = 19;
  static constexpr std::size_t kDistances = 2;
  static constexpr std::size_t kMostLengths = kMostHuffmanSymbols + kDistances;

  /// A length, or how often one is repeated.
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
