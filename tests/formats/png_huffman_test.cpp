#include "codecs/png/png_huffman.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <queue>
#include <random>
#include <vector>

namespace sfumato {
namespace {

using Counts = std::vector<std::uint32_t>;
using Words = std::vector<codecs::HuffmanWord>;

Words huffman_code_of(const Counts& counts, int most_bits = codecs::kMostHuffmanBits) {
  Words words(counts.size());
  codecs::make_huffman_code(counts, most_bits, words);
  return words;
}

/// Returns the weights of all joints of a tree built by the textbook algorithm.
std::uint64_t fewest_bits(const Counts& counts) {
  std::priority_queue<std::uint64_t, std::vector<std::uint64_t>, std::greater<>> weights;
  for (const std::uint32_t count : counts) {
    if (count > 0) weights.push(count);
  }
  std::uint64_t bits = 0;
  while (weights.size() > 1) {
    std::uint64_t joint = weights.top();
    weights.pop();
    joint += weights.top();
    weights.pop();
    weights.push(joint);
    bits += joint;
  }
  return bits;
}

std::uint64_t bits_of(const Counts& counts, const Words& words) {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    bits += std::uint64_t{counts[i]} * words[i].bit_count;
  }
  return bits;
}

void expect_complete(const Counts& counts, const Words& words, int most_bits) {
  std::uint64_t taken = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    EXPECT_EQ(words[i].bit_count > 0, counts[i] > 0) << i;
    EXPECT_LE(words[i].bit_count, most_bits) << i;
    if (counts[i] > 0) taken += std::uint64_t{1} << (most_bits - words[i].bit_count);
  }
  EXPECT_EQ(taken, std::uint64_t{1} << most_bits);
}

/// Expects that no word is the beginning of another one; the first bit of a word is its lowest.
void expect_prefix_free(const Words& words) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    for (std::size_t k = 0; k < words.size(); ++k) {
      if (i == k || words[i].bit_count == 0 || words[i].bit_count > words[k].bit_count) continue;
      const unsigned mask = (1u << words[i].bit_count) - 1;
      EXPECT_NE(words[k].bits & mask, words[i].bits) << i << " and " << k;
    }
  }
}

/// Returns counts of many kinds: even, steep, sparse.
Counts random_counts(std::mt19937& random) {
  Counts counts(2 + random() % (codecs::kMostHuffmanSymbols - 1));
  const unsigned shift_range = 1 + random() % 16, share = 1 + random() % 4;
  for (std::uint32_t& count : counts) {
    if (random() % share == 0) count = (random() & 0xffff) >> (random() % shift_range);
  }
  counts.front() += 1;
  counts.back() += 1;
  return counts;
}

TEST(PngHuffman, has_the_fewest_bits_and_no_word_begins_another) {
  std::mt19937 random(1);
  for (int i = 0; i < 300; ++i) {
    SCOPED_TRACE(i);
    const Counts counts = random_counts(random);
    const Words words = huffman_code_of(counts);
    expect_complete(counts, words, codecs::kMostHuffmanBits);
    expect_prefix_free(words);
    const std::uint64_t fewest = fewest_bits(counts);
    EXPECT_GE(bits_of(counts, words), fewest);
    EXPECT_LE(bits_of(counts, words), fewest + fewest / 100);  // long words were shortened
  }
}

TEST(PngHuffman, fewest_bits_are_reached_where_no_word_is_shortened) {
  std::mt19937 random(2);
  for (int i = 0; i < 300; ++i) {
    Counts counts(2 + random() % 200);
    for (std::uint32_t& count : counts) count = 50 + random() % 100;
    EXPECT_EQ(bits_of(counts, huffman_code_of(counts)), fewest_bits(counts)) << i;
  }
}

TEST(PngHuffman, deepest_tree_is_cut_to_the_longest_word) {
  Counts counts{1, 1};  // Fibonacci numbers: each joint is the sibling of one leaf
  while (counts.size() < 40) counts.push_back(counts.back() + counts[counts.size() - 2]);
  for (const int most_bits : {6, 7, 9, codecs::kMostHuffmanBits}) {
    const Words words = huffman_code_of(counts, most_bits);
    expect_complete(counts, words, most_bits);
    expect_prefix_free(words);
  }
}

TEST(PngHuffman, rarer_symbols_have_no_shorter_words) {
  std::mt19937 random(3);
  const Counts counts = random_counts(random);
  const Words words = huffman_code_of(counts);
  for (std::size_t i = 0; i < counts.size(); ++i) {
    for (std::size_t k = 0; k < counts.size(); ++k) {
      if (counts[i] == 0 || counts[i] >= counts[k]) continue;
      EXPECT_GE(words[i].bit_count, words[k].bit_count) << i << " and " << k;
    }
  }
}

TEST(PngHuffman, two_symbols_have_a_bit_each) {
  const Words words = huffman_code_of({0, 9, 0, 1, 0});
  EXPECT_EQ(words[1].bit_count, 1);
  EXPECT_EQ(words[3].bit_count, 1);
  EXPECT_NE(words[1].bits, words[3].bits);
}

}  // namespace
}  // namespace sfumato
