#include "codecs/png/png_code_lengths.hpp"

#include <algorithm>

namespace sfumato::codecs {
namespace {

// Symbols above the symbols of the lengths.
constexpr std::size_t kRepeat = 16;     // 3 to 6 times more, 2 extra bits
constexpr std::size_t kZeros = 17;      // 3 to 10, 3 extra bits
constexpr std::size_t kManyZeros = 18;  // 11 to 138, 7 extra bits

constexpr int kMostWordBits = 7;
constexpr std::size_t kFewestListed = 4;
constexpr std::size_t kFewestLiterals = 257;

/// The order of the lengths of item words in the head, chosen so that the last ones are often 0.
constexpr std::uint8_t kOrder[] = {kRepeat, kZeros, kManyZeros, 0, 8,  7, 9,  6, 10, 5,
                                   11,      4,      12,         3, 13, 2, 14, 1, 15};

}  // namespace

CodeLengths::CodeLengths(std::span<const HuffmanWord> words) : literal_count_(words.size()) {
  while (words[literal_count_ - 1].bit_count == 0) --literal_count_;
  std::array<std::uint16_t, kMostLengths> lengths;
  for (std::size_t i = 0; i < literal_count_; ++i) lengths[i] = words[i].bit_count;
  const std::size_t length_count = literal_count_ + kDistances;
  std::fill(&lengths[literal_count_], lengths.data() + length_count, std::uint16_t{1});
  for (std::size_t begin = 0, end = 0; begin < length_count; begin = end) {
    while (end < length_count && lengths[end] == lengths[begin]) ++end;
    add_run(lengths[begin], end - begin);
  }
  std::array<std::uint32_t, kSymbols> counts{};
  for (std::size_t i = 0; i < item_count_; ++i) ++counts[items_[i].symbol];
  make_huffman_code(counts, kMostWordBits, item_words_);
  while (listed_count_ > kFewestListed && item_words_[kOrder[listed_count_ - 1]].bit_count == 0) {
    --listed_count_;
  }
}

int CodeLengths::extra_bits(std::size_t symbol) {
  constexpr int kExtraBits[] = {2, 3, 7};
  return symbol < kRepeat ? 0 : kExtraBits[symbol - kRepeat];
}

void CodeLengths::add(std::size_t symbol, std::size_t extra) {
  items_[item_count_++] = {static_cast<std::uint8_t>(symbol), static_cast<std::uint8_t>(extra)};
}

void CodeLengths::add_run(std::size_t length, std::size_t count) {
  if (length > 0) {
    add(length);
    --count;
  }
  while (count >= 3) {
    const std::size_t part = std::min<std::size_t>(count, length > 0 ? 6 : 138);
    if (length > 0) {
      add(kRepeat, part - 3);
    } else if (part < 11) {
      add(kZeros, part - 3);
    } else {
      add(kManyZeros, part - 11);
    }
    count -= part;
  }
  for (; count > 0; --count) add(length);
}

std::size_t CodeLengths::bit_count() const {
  std::size_t bits = 5 + 5 + 4 + 3 * listed_count_;
  for (const Item& item : std::span(items_).first(item_count_)) {
    bits += item_words_[item.symbol].bit_count + static_cast<std::size_t>(extra_bits(item.symbol));
  }
  return bits;
}

void CodeLengths::write(BitWriter& bits) const {
  bits.put(literal_count_ - kFewestLiterals, 5);
  bits.put(kDistances - 1, 5);
  bits.put(listed_count_ - kFewestListed, 4);
  for (const std::uint8_t symbol : std::span(kOrder).first(listed_count_)) {
    bits.flush();
    bits.put(item_words_[symbol].bit_count, 3);
  }
  for (const Item& item : std::span(items_).first(item_count_)) {
    bits.flush();
    bits.put(item_words_[item.symbol].bits, item_words_[item.symbol].bit_count);
    bits.put(item.extra, extra_bits(item.symbol));
  }
  bits.flush();
}

}  // namespace sfumato::codecs
