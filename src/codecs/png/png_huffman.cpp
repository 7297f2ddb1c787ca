#include "codecs/png/png_huffman.hpp"

#include <algorithm>
#include <array>

namespace sfumato::codecs {
namespace {

/// A symbol that occurs: its count above its number, so that leaves are sorted by both.
using Leaf = std::uint64_t;
constexpr int kSymbolBits = 16;

using Leaves = std::array<Leaf, kMostHuffmanSymbols>;
/// Code words of each length in bits.
using LengthCounts = std::array<std::uint32_t, kMostHuffmanBits + 1>;

std::uint64_t weight(Leaf leaf) {
  return leaf >> kSymbolBits;
}

/// Returns the symbols that occur, the rarest first.
std::span<const Leaf> collect_leaves(std::span<const std::uint32_t> counts, Leaves& leaves) {
  std::size_t leaf_count = 0;
  for (std::size_t symbol = 0; symbol < counts.size(); ++symbol) {
    if (counts[symbol] > 0) leaves[leaf_count++] = Leaf{counts[symbol]} << kSymbolBits | symbol;
  }
  std::sort(leaves.begin(), leaves.begin() + static_cast<std::ptrdiff_t>(leaf_count));
  return std::span(leaves).first(leaf_count);
}

/// The joint above each leaf, followed by the joint above each joint except the last, which is the
/// root.
using Parents = std::array<std::uint16_t, 2 * kMostHuffmanSymbols>;

/// Builds Huffman's tree: the two lightest leaves or joints become one joint until one is left.
/// Both lists are in the order of their weights, since no joint is lighter than an earlier one.
Parents join_leaves(std::span<const Leaf> leaves) {
  Parents parent;
  std::array<std::uint64_t, kMostHuffmanSymbols> joint_weight;
  std::size_t leaf = 0, joint = 0;
  for (std::size_t made = 0; made + 1 < leaves.size(); ++made) {
    joint_weight[made] = 0;
    for (int child = 0; child < 2; ++child) {
      const bool takes_leaf =
          joint == made || (leaf < leaves.size() && weight(leaves[leaf]) <= joint_weight[joint]);
      joint_weight[made] += takes_leaf ? weight(leaves[leaf]) : joint_weight[joint];
      parent[takes_leaf ? leaf++ : leaves.size() + joint++] = static_cast<std::uint16_t>(made);
    }
  }
  return parent;
}

/// Counts the leaves at each depth of the tree; deeper leaves than `most_bits` count at
/// `most_bits`.
LengthCounts count_depths(const Parents& parent, std::size_t leaf_count, int most_bits) {
  std::array<int, kMostHuffmanSymbols> depth;  // of joints
  const std::size_t root = leaf_count - 2;
  depth[root] = 0;
  for (std::size_t joint = root; joint-- > 0;) {
    depth[joint] = depth[parent[leaf_count + joint]] + 1;
  }
  LengthCounts length_count{};
  for (std::size_t leaf = 0; leaf < leaf_count; ++leaf) {
    ++length_count[static_cast<std::size_t>(std::min(depth[parent[leaf]] + 1, most_bits))];
  }
  return length_count;
}

/// Words that were cut to `most_bits` need room: each step moves one of them beside a shorter word,
/// which becomes a bit longer.
void make_room(LengthCounts& length_count, int most_bits) {
  const auto most = static_cast<std::size_t>(most_bits);
  std::uint32_t taken = 0;  // of 2^most_bits words
  for (std::size_t bits = 1; bits <= most; ++bits) taken += length_count[bits] << (most - bits);
  for (; taken > std::uint32_t{1} << most; --taken) {
    std::size_t bits = most - 1;
    while (length_count[bits] == 0) --bits;
    --length_count[bits];
    length_count[bits + 1] += 2;
    --length_count[most];
  }
}

/// The rarest symbols have the longest words.
void set_lengths(std::span<const Leaf> leaves, const LengthCounts& length_count,
                 std::span<HuffmanWord> words) {
  std::fill(words.begin(), words.end(), HuffmanWord{});
  std::size_t leaf = 0;
  for (std::size_t bits = length_count.size(); bits-- > 1;) {
    for (std::uint32_t i = 0; i < length_count[bits]; ++i) {
      const Leaf symbol = leaves[leaf++] & ((Leaf{1} << kSymbolBits) - 1);
      words[symbol].bit_count = static_cast<std::uint16_t>(bits);
    }
  }
}

std::uint16_t mirrored(std::uint32_t word, int bit_count) {
  std::uint32_t result = 0;
  for (int i = 0; i < bit_count; ++i) result |= (word >> i & 1) << (bit_count - 1 - i);
  return static_cast<std::uint16_t>(result);
}

/// Words of one length are consecutive numbers, after the numbers of shorter words.
void set_bits(const LengthCounts& length_count, std::span<HuffmanWord> words) {
  std::array<std::uint32_t, kMostHuffmanBits + 1> next{};
  for (std::size_t bits = 2; bits < next.size(); ++bits) {
    next[bits] = (next[bits - 1] + length_count[bits - 1]) << 1;
  }
  for (HuffmanWord& word : words) {
    if (word.bit_count > 0) word.bits = mirrored(next[word.bit_count]++, word.bit_count);
  }
}

}  // namespace

void make_huffman_code(std::span<const std::uint32_t> counts, int most_bits,
                       std::span<HuffmanWord> words) {
  Leaves room;
  const std::span<const Leaf> leaves = collect_leaves(counts, room);
  LengthCounts length_count = count_depths(join_leaves(leaves), leaves.size(), most_bits);
  make_room(length_count, most_bits);
  set_lengths(leaves, length_count, words);
  set_bits(length_count, words);
}

}  // namespace sfumato::codecs
