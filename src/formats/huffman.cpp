#include "formats/huffman.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace sfumato {
namespace {

constexpr int kMaxLength = 15;

struct Leaf {
  std::uint32_t count;
  std::uint16_t symbol;
};

/// Symbols that occur, rarest first; made up to two.
std::vector<Leaf> sorted_leaves(std::span<const std::uint32_t> counts) {
  std::vector<Leaf> leaves;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] > 0) leaves.push_back({counts[i], static_cast<std::uint16_t>(i)});
  }
  for (std::size_t i = 0; leaves.size() < 2; ++i) {
    if (counts[i] == 0) leaves.push_back({0, static_cast<std::uint16_t>(i)});
  }
  std::ranges::stable_sort(leaves, {}, &Leaf::count);
  return leaves;
}

/// Depth of each leaf in Huffman's tree: two queues, for the leaves come sorted and inner nodes are
/// made in rising order.
std::vector<int> leaf_depths(const std::vector<Leaf>& leaves) {
  const std::size_t leaf_count = leaves.size();
  const std::size_t node_count = 2 * leaf_count - 1;
  std::vector<std::uint64_t> weight(node_count);
  std::vector<std::size_t> parent(node_count);
  for (std::size_t i = 0; i < leaf_count; ++i) weight[i] = leaves[i].count;
  std::size_t next_leaf = 0;
  std::size_t next_inner = leaf_count;
  for (std::size_t node = leaf_count; node < node_count; ++node) {
    for (int child = 0; child < 2; ++child) {
      const bool takes_leaf =
          next_leaf < leaf_count && (next_inner == node || weight[next_leaf] <= weight[next_inner]);
      const std::size_t taken = takes_leaf ? next_leaf++ : next_inner++;
      weight[node] += weight[taken];
      parent[taken] = node;
    }
  }
  std::vector<int> depth(node_count);
  for (std::size_t node = node_count - 1; node-- > 0;) depth[node] = depth[parent[node]] + 1;
  depth.resize(leaf_count);
  return depth;
}

/// How many codes have each length, after codes longer than max_length were moved up: each step
/// splits the longest code that is still short enough (as zlib does), which keeps Kraft's sum at 1.
std::array<int, kMaxLength + 1> limited_counts(const std::vector<int>& depths, int max_length) {
  std::array<int, kMaxLength + 1> length_counts{};
  std::int64_t excess = 0;  // Kraft's sum beyond 1, in units of 2^-max_length
  for (const int depth : depths) {
    const int length = std::min(depth, max_length);
    ++length_counts[static_cast<std::size_t>(length)];
    excess += std::int64_t{1} << (max_length - length);
  }
  excess -= std::int64_t{1} << max_length;
  while (excess > 0) {
    int length = max_length - 1;
    while (length_counts[static_cast<std::size_t>(length)] == 0) --length;
    // A code of that length becomes inner: it and one of the longest hang below it.
    --length_counts[static_cast<std::size_t>(length)];
    length_counts[static_cast<std::size_t>(length) + 1] += 2;
    --length_counts[static_cast<std::size_t>(max_length)];
    --excess;
  }
  return length_counts;
}

std::uint16_t reversed(unsigned code, int length) {
  unsigned result = 0;
  for (int i = 0; i < length; ++i) result |= ((code >> i) & 1) << (length - 1 - i);
  return static_cast<std::uint16_t>(result);
}

}  // namespace

void code_lengths(std::span<const std::uint32_t> counts, int max_length,
                  std::span<std::uint8_t> lengths) {
  std::ranges::fill(lengths, std::uint8_t{0});
  const std::vector<Leaf> leaves = sorted_leaves(counts);
  const auto length_counts = limited_counts(leaf_depths(leaves), max_length);
  // The rarest symbols get the longest codes.
  std::size_t leaf = 0;
  for (int length = max_length; length > 0; --length) {
    for (int i = 0; i < length_counts[static_cast<std::size_t>(length)]; ++i) {
      lengths[leaves[leaf++].symbol] = static_cast<std::uint8_t>(length);
    }
  }
}

void canonical_codes(std::span<const std::uint8_t> lengths, std::span<std::uint16_t> codes) {
  std::array<unsigned, kMaxLength + 2> next_code{};
  for (const std::uint8_t length : lengths) next_code[length + 1u] += length > 0;
  for (std::size_t length = 1; length < next_code.size(); ++length) {
    next_code[length] = (next_code[length] + next_code[length - 1]) << 1;
  }
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    codes[i] = lengths[i] > 0 ? reversed(next_code[lengths[i]]++, lengths[i]) : std::uint16_t{0};
  }
}

}  // namespace sfumato
