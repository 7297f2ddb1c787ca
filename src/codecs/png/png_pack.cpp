#include "codecs/png/png_pack.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "codecs/png/png_bits.hpp"
#include "codecs/png/png_code_lengths.hpp"
#include "codecs/png/png_huffman.hpp"

namespace sfumato::codecs {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::size_t kStoredHeadBytes = 5;
constexpr int kBlockHeadBits = 3;

constexpr std::size_t kEndOfBlock = 256;
constexpr std::size_t kLongestSymbol = 285;
constexpr std::size_t kShortestRun = 3;
constexpr std::size_t kLongestRun = 258;

/// Bytes that are compared together.
constexpr std::size_t kWordBytes = sizeof(std::uint64_t);

/// Returns a word with a 0 for each byte that equals the byte before it.
std::uint64_t changes(const std::uint8_t* bytes) {
  std::uint64_t word, word_before;
  std::memcpy(&word, bytes, kWordBytes);
  std::memcpy(&word_before, bytes - 1, kWordBytes);
  return word ^ word_before;
}

constexpr bool kLowByteIsFirst = std::endian::native == std::endian::little;

/// Returns the number of bytes before the first that changed.
std::size_t same_at_begin(std::uint64_t word) {
  return static_cast<std::size_t>(kLowByteIsFirst ? std::countr_zero(word)
                                                  : std::countl_zero(word)) /
         8;
}

/// Returns the number of bytes after the last that changed.
std::size_t same_at_end(std::uint64_t word) {
  return static_cast<std::size_t>(kLowByteIsFirst ? std::countl_zero(word)
                                                  : std::countr_zero(word)) /
         8;
}

/// Returns the end of a run that continues at `i` for at least a word.
std::size_t run_end(Bytes bytes, std::size_t i) {
  while (i + kWordBytes <= bytes.size()) {
    const std::uint64_t word = changes(bytes.data() + i);
    if (word != 0) return i + same_at_begin(word);
    i += kWordBytes;
  }
  while (i < bytes.size() && bytes[i] == bytes[i - 1]) ++i;
  return i;
}

/// Passes the bytes to a sink in order: literal(byte), literals(pointer to kWordBytes of them), and
/// repeat(count) for `count` more copies of the byte before. Short runs, below two words, are found
/// only if they fill a word: others would save little and take longer to find.
template <class Sink>
void for_each_run(Bytes bytes, Sink& sink) {
  const std::uint8_t* data = bytes.data();
  sink.literal(data[0]);
  std::size_t i = 1;
  while (i + 2 * kWordBytes <= bytes.size()) {
    if (changes(data + i + kWordBytes) != 0) {
      sink.literals(data + i);
      i += kWordBytes;
      continue;
    }
    const std::size_t begin = i + kWordBytes - same_at_end(changes(data + i));
    for (; i < begin; ++i) sink.literal(data[i]);
    i = run_end(bytes, i);
    sink.repeat(i - begin);
  }
  for (; i < bytes.size(); ++i) sink.literal(data[i]);
}

/// A run in deflate's form.
struct RunCode {
  std::size_t symbol;
  std::uint32_t extra;
  int extra_bits;
};

RunCode run_code(std::size_t count) {
  if (count == kLongestRun) return {kLongestSymbol, 0, 0};
  const auto more = static_cast<std::uint32_t>(count - kShortestRun);
  const int extra_bits = more < 8 ? 0 : static_cast<int>(std::bit_width(more)) - 3;
  const std::uint32_t step = more >> extra_bits;
  const std::size_t symbol = kEndOfBlock + 1 + 4 * static_cast<std::size_t>(extra_bits) + step;
  return {symbol, more - (step << extra_bits), extra_bits};
}

/// Splits a run into lengths that deflate allows.
template <class Use>
void for_each_part(std::size_t count, Use use) {
  while (count > kLongestRun) {
    const std::size_t part = std::min(kLongestRun, count - kShortestRun);
    use(run_code(part));
    count -= part;
  }
  use(run_code(count));
}

using SymbolCounts = std::array<std::uint32_t, kMostHuffmanSymbols>;

/// Counts how often each symbol occurs.
class Counter {
 public:
  void literal(std::uint8_t byte) { ++counts_[0][byte]; }
  void literals(const std::uint8_t* bytes) {
    // There are four tables because neighbouring bytes are often equal, and increments of one
    // counter wait for each other.
    for (std::size_t i = 0; i < kWordBytes; ++i) ++counts_[i % 4][bytes[i]];
  }
  void repeat(std::size_t count) {
    for_each_part(count, [this](const RunCode& code) {
      ++counts_[0][code.symbol];
      extra_bits_ += static_cast<std::size_t>(code.extra_bits) + 1;
    });
  }

  SymbolCounts sums() const {
    SymbolCounts sums = counts_[0];
    for (std::size_t i = 0; i < kEndOfBlock; ++i) {
      sums[i] += counts_[1][i] + counts_[2][i] + counts_[3][i];
    }
    sums[kEndOfBlock] = 1;
    return sums;
  }
  /// Code words of runs, including the bit for the distance.
  std::size_t extra_bits() const { return extra_bits_; }

 private:
  std::array<SymbolCounts, 4> counts_{};
  std::size_t extra_bits_ = 0;
};

/// Has its own BitWriter, which the compiler keeps in registers: another's members might be among
/// the bytes that are written.
class Writer {
 public:
  Writer(const BitWriter& bits, const HuffmanWord* words) : bits_(bits), words_(words) {}

  /// Returns the writer after what was written.
  const BitWriter& bits() const { return bits_; }

  void literal(std::uint8_t byte) { symbol(byte); }
  void literals(const std::uint8_t* bytes) {
    put_four(bytes);
    put_four(bytes + 4);
  }
  void repeat(std::size_t count) {
    for_each_part(count, [this](const RunCode& code) {
      symbol(code.symbol);
      bits_.put(code.extra, code.extra_bits + 1);  // with a 0 for the distance
      bits_.flush();
    });
  }
  void symbol(std::size_t symbol) {
    bits_.put(words_[symbol].bits, words_[symbol].bit_count);
    bits_.flush();
  }

 private:
  /// Pairs are joined first, so that fewer shifts wait for each other.
  void put_four(const std::uint8_t* bytes) {
    const HuffmanWord a = words_[bytes[0]], b = words_[bytes[1]];
    const HuffmanWord c = words_[bytes[2]], d = words_[bytes[3]];
    const std::uint64_t ab = a.bits | std::uint64_t{b.bits} << a.bit_count;
    const std::uint64_t cd = c.bits | std::uint64_t{d.bits} << c.bit_count;
    const int ab_count = a.bit_count + b.bit_count;
    bits_.put(ab | cd << ab_count, ab_count + c.bit_count + d.bit_count);
    bits_.flush();
  }

  BitWriter bits_;
  const HuffmanWord* words_;
};

/// Returns the bits of a block with its own Huffman code.
std::size_t bits_of(const SymbolCounts& counts, std::span<const HuffmanWord> words,
                    const CodeLengths& lengths, std::size_t extra_bits) {
  std::size_t bits = kBlockHeadBits + lengths.bit_count() + extra_bits;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    bits += std::size_t{counts[i]} * words[i].bit_count;
  }
  return bits;
}

/// Appends blocks. The head of a block has a bit for "not the last" and two bits for the kind.
class Packer {
 public:
  explicit Packer(std::vector<std::uint8_t>& out) : out_(out), bits_(out.data() + out.size()) {}

  void pack(Bytes bytes) {
    Counter counter;
    for_each_run(bytes, counter);
    const SymbolCounts counts = counter.sums();
    std::array<HuffmanWord, kMostHuffmanSymbols> words;
    make_huffman_code(counts, kMostHuffmanBits, words);
    const CodeLengths lengths(words);
    const std::size_t packed_bytes = bits_of(counts, words, lengths, counter.extra_bits()) / 8;
    if (packed_bytes >= kStoredHeadBytes + bytes.size()) return store(bytes);
    touch(packed_bytes);
    bits_.put(0b100, kBlockHeadBits);
    lengths.write(bits_);
    Writer writer(bits_, words.data());
    for_each_run(bytes, writer);
    writer.symbol(kEndOfBlock);
    bits_ = writer.bits();
  }

  void store(Bytes bytes) {
    touch(kStoredHeadBytes + bytes.size());
    const auto size = static_cast<std::uint32_t>(bytes.size());
    bits_.put(0, kBlockHeadBits);
    bits_.align();
    bits_.put(size | (~size & 0xffff) << 16, 32);
    bits_.flush();
    bits_.copy(bytes);
  }

  /// Called after store(): cuts off the bytes that were touched beyond the last block.
  void end() { out_.resize(written_bytes()); }

 private:
  std::size_t written_bytes() const { return static_cast<std::size_t>(bits_.end() - out_.data()); }
  /// Makes this many bytes, and the partial bytes at both ends, part of the table. It does not take
  /// all of its room at once, because touching memory for the first time takes longer than packing.
  void touch(std::size_t byte_count) {
    out_.resize(written_bytes() + byte_count + 2 + BitWriter::kSlack);
  }

  std::vector<std::uint8_t>& out_;
  BitWriter bits_;
};

std::size_t block_count(std::size_t byte_count) {
  return (byte_count + kPackBlockBytes - 1) / kPackBlockBytes;
}

}  // namespace

std::size_t packed_bound(std::size_t byte_count) {
  // A block is at most as long as a stored one, and has parts of bytes at both ends.
  const std::size_t head_bytes = (kStoredHeadBytes + 2) * (block_count(byte_count) + 1);
  return byte_count + head_bytes + BitWriter::kSlack;
}

void pack_runs(Bytes bytes, std::vector<std::uint8_t>& out) {
  Packer packer(out);
  const std::size_t count = block_count(bytes.size());
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t first = i * bytes.size() / count, end = (i + 1) * bytes.size() / count;
    packer.pack(bytes.subspan(first, end - first));
  }
  packer.store({});
  packer.end();
}

}  // namespace sfumato::codecs
