#include "formats/deflate.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "formats/bit_writer.hpp"
#include "formats/huffman.hpp"

namespace sfumato {
namespace {

// RFC 1951.
constexpr std::size_t kLiteralCodes = 286;
constexpr std::size_t kDistanceCodes = 30;
constexpr std::size_t kHeaderCodes = 19;
constexpr unsigned kEndOfBlock = 256;
constexpr std::size_t kMaxMatch = 258;
constexpr std::size_t kMinMatch = 3;
constexpr std::size_t kMaxStored = 65'535;
constexpr int kMaxCodeLength = 14;  // four literals fill no more than BitWriter::kBitsPerFlush
constexpr int kMaxHeaderCodeLength = 7;
constexpr unsigned kStoredBlock = 0;
constexpr unsigned kFixedBlock = 1;
constexpr unsigned kDynamicBlock = 2;
constexpr std::array<std::uint8_t, kHeaderCodes> kHeaderOrder{16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                              11, 4,  12, 3, 13, 2, 14, 1, 15};

/// Shorter repetitions cost more than their literals: the most frequent byte takes a bit or two.
constexpr std::size_t kMinRun = 15;
constexpr std::size_t kWord = sizeof(std::uint64_t);

/// bytes[begin, end) repeat what stands `distance` before.
struct Run {
  std::uint32_t begin;
  std::uint32_t end;
};

/// A symbol of a code and the plain bits that follow it.
struct Symbol {
  unsigned code;
  unsigned extra;
  int extra_bits;
};

Symbol length_symbol(std::size_t length) {
  if (length == kMaxMatch) return {285, 0, 0};
  const auto value = static_cast<unsigned>(length - kMinMatch);
  if (value < 8) return {257 + value, 0, 0};
  const int extra_bits = std::bit_width(value) - 3;
  const unsigned group = value >> extra_bits;  // 4 to 7
  return {257 + 4 * static_cast<unsigned>(extra_bits) + group, value & ((1u << extra_bits) - 1),
          extra_bits};
}

Symbol distance_symbol(std::size_t distance) {
  const auto value = static_cast<unsigned>(distance - 1);
  if (value < 4) return {value, 0, 0};
  const int extra_bits = std::bit_width(value) - 2;
  const unsigned group = value >> extra_bits;  // 2 or 3
  return {2 * static_cast<unsigned>(extra_bits) + group, value & ((1u << extra_bits) - 1),
          extra_bits};
}

/// Calls emit(length) for the matches that make up a run; none is shorter than kMinMatch.
template <class Emit>
void for_each_match(const Run& run, Emit emit) {
  std::size_t rest = run.end - run.begin;
  while (rest > 0) {
    std::size_t length = std::min(rest, kMaxMatch);
    if (rest > length && rest - length < kMinMatch) length = rest - kMinMatch;
    emit(length);
    rest -= length;
  }
}

std::uint64_t load_word(const std::uint8_t* at) {
  std::uint64_t word;
  std::memcpy(&word, at, kWord);
  return word;
}

/// Every run of at least kMinRun ≥ 2 kWord - 1 bytes holds a whole word: words are looked at, then
/// the run is grown to both sides.
std::vector<Run> find_runs(std::span<const std::uint8_t> bytes, std::size_t distance) {
  static_assert(kMinRun >= 2 * kWord - 1);
  std::vector<Run> runs;
  std::size_t free_from = distance;  // where the next run may begin
  std::size_t i = distance;
  while (i + kWord <= bytes.size()) {
    if (load_word(&bytes[i]) != load_word(&bytes[i - distance])) {
      i += kWord;
      continue;
    }
    std::size_t begin = i;
    while (begin > free_from && bytes[begin - 1] == bytes[begin - 1 - distance]) --begin;
    std::size_t end = i + kWord;
    while (end < bytes.size() && bytes[end] == bytes[end - distance]) ++end;
    if (end - begin >= kMinRun) {
      runs.push_back({static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)});
    }
    free_from = end;
    i = end;
  }
  return runs;
}

/// Calls literals(begin, end) and run(r) in turn over all bytes.
template <class OnLiterals, class OnRun>
void for_each_part(std::size_t size, const std::vector<Run>& runs, OnLiterals on_literals,
                   OnRun on_run) {
  std::size_t done = 0;
  for (const Run& run : runs) {
    on_literals(done, run.begin);
    on_run(run);
    done = run.end;
  }
  on_literals(done, size);
}

using Counts = std::array<std::uint32_t, kLiteralCodes>;

void count_bytes(std::span<const std::uint8_t> bytes, Counts& counts) {
  // Four tables: the same byte twice would wait for its own count.
  std::array<std::array<std::uint32_t, 256>, 4> tables{};
  std::size_t i = 0;
  for (; i + 4 <= bytes.size(); i += 4) {
    for (std::size_t k = 0; k < 4; ++k) ++tables[k][bytes[i + k]];
  }
  for (; i < bytes.size(); ++i) ++tables[0][bytes[i]];
  for (std::size_t value = 0; value < 256; ++value) {
    for (const auto& table : tables) counts[value] += table[value];
  }
}

/// A block with a code of its own, planned: its size is known before a bit is written.
class DynamicBlock {
 public:
  DynamicBlock(std::span<const std::uint8_t> bytes, std::size_t distance);

  std::size_t bit_count() const { return bit_count_; }
  void write(BitWriter& writer) const;

 private:
  void count_symbols();
  void plan_header();
  void count_bits();
  void write_header(BitWriter& writer) const;
  void write_literals(BitWriter& writer, std::size_t begin, std::size_t end) const;
  void write_run(BitWriter& writer, const Run& run) const;

  std::span<const std::uint8_t> bytes_;
  Symbol distance_;
  std::vector<Run> runs_;
  Counts counts_{};
  std::uint32_t match_count_ = 0;
  std::size_t extra_bit_count_ = 0;
  std::array<std::uint8_t, kLiteralCodes> lengths_{};
  std::array<std::uint16_t, kLiteralCodes> codes_{};
  std::array<std::uint8_t, kDistanceCodes> distance_lengths_{};
  std::array<std::uint16_t, kDistanceCodes> distance_codes_{};
  std::vector<Symbol> header_symbols_;
  std::array<std::uint8_t, kHeaderCodes> header_lengths_{};
  std::array<std::uint16_t, kHeaderCodes> header_codes_{};
  std::size_t header_code_count_ = 0;
  std::size_t bit_count_ = 0;
};

DynamicBlock::DynamicBlock(std::span<const std::uint8_t> bytes, std::size_t distance)
    : bytes_(bytes), distance_(distance_symbol(distance)), runs_(find_runs(bytes, distance)) {
  count_symbols();
  code_lengths(counts_, kMaxCodeLength, lengths_);
  canonical_codes(lengths_, codes_);
  std::array<std::uint32_t, kDistanceCodes> distance_counts{};
  distance_counts[distance_.code] = match_count_;
  code_lengths(distance_counts, kMaxCodeLength, distance_lengths_);
  canonical_codes(distance_lengths_, distance_codes_);
  plan_header();
  count_bits();
}

void DynamicBlock::count_symbols() {
  const auto on_run = [this](const Run& run) {
    for_each_match(run, [this](std::size_t length) {
      const Symbol symbol = length_symbol(length);
      ++counts_[symbol.code];
      ++match_count_;
      extra_bit_count_ += static_cast<std::size_t>(symbol.extra_bits + distance_.extra_bits);
    });
  };
  const auto on_literals = [this](std::size_t begin, std::size_t end) {
    count_bytes(bytes_.subspan(begin, end - begin), counts_);
  };
  for_each_part(bytes_.size(), runs_, on_literals, on_run);
  counts_[kEndOfBlock] = 1;
}

/// The lengths of both codes as symbols 0 to 18 of RFC 1951, 3.2.7.
std::vector<Symbol> run_length_coded(std::span<const std::uint8_t> lengths) {
  std::vector<Symbol> symbols;
  std::size_t i = 0;
  while (i < lengths.size()) {
    const unsigned value = lengths[i];
    std::size_t repeat = 1;
    while (i + repeat < lengths.size() && lengths[i + repeat] == value) ++repeat;
    i += repeat;
    if (value != 0) {
      symbols.push_back({value, 0, 0});
      --repeat;
    }
    while (repeat >= 3) {
      const std::size_t most = value != 0 ? 6 : repeat <= 10 ? 10 : 138;
      const auto taken = static_cast<unsigned>(std::min(repeat, most));
      if (value != 0) {
        symbols.push_back({16, taken - 3, 2});
      } else if (taken <= 10) {
        symbols.push_back({17, taken - 3, 3});
      } else {
        symbols.push_back({18, taken - 11, 7});
      }
      repeat -= taken;
    }
    symbols.insert(symbols.end(), repeat, {value, 0, 0});
  }
  return symbols;
}

void DynamicBlock::plan_header() {
  std::array<std::uint8_t, kLiteralCodes + kDistanceCodes> all{};
  std::ranges::copy(lengths_, all.begin());
  std::ranges::copy(distance_lengths_, all.begin() + kLiteralCodes);
  header_symbols_ = run_length_coded(all);
  std::array<std::uint32_t, kHeaderCodes> counts{};
  for (const Symbol& symbol : header_symbols_) ++counts[symbol.code];
  code_lengths(counts, kMaxHeaderCodeLength, header_lengths_);
  canonical_codes(header_lengths_, header_codes_);
  header_code_count_ = kHeaderCodes;
  while (header_code_count_ > 4 && header_lengths_[kHeaderOrder[header_code_count_ - 1]] == 0) {
    --header_code_count_;
  }
}

void DynamicBlock::count_bits() {
  bit_count_ = 3 + 5 + 5 + 4 + 3 * header_code_count_ + extra_bit_count_;
  for (const Symbol& symbol : header_symbols_) {
    bit_count_ += header_lengths_[symbol.code] + static_cast<std::size_t>(symbol.extra_bits);
  }
  for (std::size_t i = 0; i < kLiteralCodes; ++i) {
    bit_count_ += std::size_t{counts_[i]} * lengths_[i];
  }
  bit_count_ += std::size_t{match_count_} * distance_lengths_[distance_.code];
}

void DynamicBlock::write(BitWriter& writer) const {
  write_header(writer);
  for_each_part(
      bytes_.size(), runs_,
      [&](std::size_t begin, std::size_t end) { write_literals(writer, begin, end); },
      [&](const Run& run) { write_run(writer, run); });
  writer.put(codes_[kEndOfBlock], lengths_[kEndOfBlock]);
  writer.flush();
}

void DynamicBlock::write_header(BitWriter& writer) const {
  writer.put(kDynamicBlock << 1, 3);
  writer.put(kLiteralCodes - 257, 5);
  writer.put(kDistanceCodes - 1, 5);
  writer.put(header_code_count_ - 4, 4);
  writer.flush();
  for (std::size_t i = 0; i < header_code_count_; ++i) {
    writer.put(header_lengths_[kHeaderOrder[i]], 3);
    writer.flush();
  }
  for (const Symbol& symbol : header_symbols_) {
    writer.put(header_codes_[symbol.code], header_lengths_[symbol.code]);
    writer.put(symbol.extra, symbol.extra_bits);
    writer.flush();
  }
}

void DynamicBlock::write_literals(BitWriter& shared_writer, std::size_t begin,
                                  std::size_t end) const {
  BitWriter writer = shared_writer;  // a local one stays in registers
  const auto put = [&](std::size_t i) { writer.put(codes_[bytes_[i]], lengths_[bytes_[i]]); };
  std::size_t i = begin;
  for (; i + 4 <= end; i += 4) {
    for (std::size_t k = 0; k < 4; ++k) put(i + k);
    writer.flush();
  }
  for (; i < end; ++i) {
    put(i);
    writer.flush();
  }
  shared_writer = writer;
}

void DynamicBlock::write_run(BitWriter& writer, const Run& run) const {
  for_each_match(run, [&](std::size_t length) {
    const Symbol symbol = length_symbol(length);
    writer.put(codes_[symbol.code], lengths_[symbol.code]);
    writer.put(symbol.extra, symbol.extra_bits);
    writer.flush();
    writer.put(distance_codes_[distance_.code], distance_lengths_[distance_.code]);
    writer.put(distance_.extra, distance_.extra_bits);
    writer.flush();
  });
}

/// Header, length and its complement, after bits that do not fill a byte.
void append_stored_block(std::span<const std::uint8_t> bytes, std::vector<std::uint8_t>& out) {
  const auto size = static_cast<unsigned>(bytes.size());
  for (const unsigned byte :
       {kStoredBlock, size & 255, size >> 8, ~size & 255, (~size >> 8) & 255}) {
    out.push_back(static_cast<std::uint8_t>(byte));
  }
  out.insert(out.end(), bytes.begin(), bytes.end());
}

void append_stored_blocks(std::span<const std::uint8_t> bytes, std::vector<std::uint8_t>& out) {
  while (!bytes.empty()) {
    const std::size_t size = std::min(bytes.size(), kMaxStored);
    append_stored_block(bytes.first(size), out);
    bytes = bytes.subspan(size);
  }
}

}  // namespace

void append_deflate_blocks(std::span<const std::uint8_t> bytes, std::size_t distance,
                           std::vector<std::uint8_t>& out) {
  const DynamicBlock block(bytes, distance);
  if (block.bit_count() / 8 >= bytes.size()) return append_stored_blocks(bytes, out);
  const std::size_t begin = out.size();
  // An empty stored block, whose three header bits may fill the last byte, ends on a whole byte.
  const std::size_t block_bytes = (block.bit_count() + 3 + 7) / 8;
  out.resize(begin + block_bytes + BitWriter::kSlackBytes);
  BitWriter writer(out.data() + begin);
  block.write(writer);
  writer.put(kStoredBlock, 3);
  writer.flush();
  out.resize(begin + block_bytes);
  out.insert(out.end(), {0x00, 0x00, 0xff, 0xff});
}

void append_deflate_end(std::vector<std::uint8_t>& out) {
  out.insert(out.end(), {kFixedBlock << 1 | 1, 0});
}

}  // namespace sfumato
