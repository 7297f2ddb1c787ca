#include "formats/deflate.hpp"

#include <gtest/gtest.h>
#include <libdeflate.h>

#include <array>
#include <cmath>
#include <numeric>

#include "formats/huffman.hpp"

namespace sfumato {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes inflated(const Bytes& stream, std::size_t size) {
  Bytes bytes(size);
  std::size_t actual = 0;
  libdeflate_decompressor* const decompressor = libdeflate_alloc_decompressor();
  const libdeflate_result result = libdeflate_deflate_decompress(
      decompressor, stream.data(), stream.size(), bytes.data(), bytes.size(), &actual);
  libdeflate_free_decompressor(decompressor);
  EXPECT_EQ(result, LIBDEFLATE_SUCCESS);
  EXPECT_EQ(actual, size);
  return bytes;
}

void expect_round_trip(const Bytes& bytes, std::size_t distance) {
  Bytes stream;
  append_deflate_blocks(bytes, distance, stream);
  append_deflate_end(stream);
  EXPECT_TRUE(inflated(stream, bytes.size()) == bytes)
      << bytes.size() << " bytes, distance " << distance;
}

class Random {
 public:
  std::uint32_t next() {
    state_ = state_ * 1'664'525u + 1'013'904'223u;
    return state_ >> 8;
  }

 private:
  std::uint32_t state_ = 1;
};

TEST(Deflate, nothing_comes_back_as_nothing) {
  expect_round_trip({}, 3);
}

TEST(Deflate, every_short_length_comes_back) {
  Random random;
  Bytes bytes;
  for (int size = 1; size < 600; ++size) {
    bytes.push_back(static_cast<std::uint8_t>(random.next() % 3));
    expect_round_trip(bytes, 1);
    expect_round_trip(bytes, 8);
  }
}

TEST(Deflate, runs_of_every_length_come_back) {
  for (std::size_t length = 1; length < 900; ++length) {
    Bytes bytes{9, 8, 7};
    for (std::size_t i = 0; i < length; ++i) bytes.push_back(bytes[i]);
    bytes.push_back(1);
    expect_round_trip(bytes, 3);
  }
}

TEST(Deflate, random_mixtures_of_runs_and_literals_come_back) {
  Random random;
  for (int round = 0; round < 200; ++round) {
    const std::size_t distance = 1 + random.next() % 9;
    const std::uint32_t values = 1u << (random.next() % 9);
    Bytes bytes;
    while (bytes.size() < 20'000) {
      const std::size_t literals = random.next() % 50;
      for (std::size_t i = 0; i < literals; ++i) {
        bytes.push_back(static_cast<std::uint8_t>(random.next() % values));
      }
      const std::size_t run = bytes.size() < distance ? 0 : random.next() % 700;
      for (std::size_t i = 0; i < run; ++i) bytes.push_back(bytes[bytes.size() - distance]);
    }
    expect_round_trip(bytes, distance);
  }
}

TEST(Deflate, bytes_as_unequal_as_fibonacci_numbers_come_back) {
  Bytes bytes;
  std::size_t a = 1;
  std::size_t b = 1;
  for (std::uint8_t value = 0; value < 28; ++value) {
    for (std::size_t i = 0; i < a; ++i) bytes.push_back(static_cast<std::uint8_t>(value * 7));
    b += a;
    std::swap(a, b);
  }
  // Out of order, so that there are no runs.
  Bytes mixed(bytes.size());
  for (std::size_t i = 0; i < bytes.size(); ++i) mixed[i * 100'003 % bytes.size()] = bytes[i];
  expect_round_trip(mixed, 1);
}

TEST(Deflate, noise_is_stored) {
  Random random;
  Bytes bytes;
  for (int i = 0; i < 200'000; ++i) bytes.push_back(static_cast<std::uint8_t>(random.next()));
  expect_round_trip(bytes, 4);
  Bytes stream;
  append_deflate_blocks(bytes, 4, stream);
  EXPECT_LE(stream.size(), bytes.size() + 5 * 4);
}

TEST(Deflate, pieces_made_apart_join_to_one_stream) {
  Random random;
  Bytes all;
  Bytes stream;
  for (std::size_t size : {1u, 3000u, 70'000u, 17u, 0u, 40'000u}) {
    const std::uint32_t values = size == 70'000u ? 256 : 5;
    Bytes piece;
    while (piece.size() < size) piece.push_back(static_cast<std::uint8_t>(random.next() % values));
    append_deflate_blocks(piece, 3, stream);
    all.insert(all.end(), piece.begin(), piece.end());
  }
  append_deflate_end(stream);
  EXPECT_TRUE(inflated(stream, all.size()) == all);
}

TEST(Huffman, lengths_of_a_code_that_is_known) {
  const std::array<std::uint32_t, 5> counts{40, 0, 20, 10, 30};
  std::array<std::uint8_t, 5> lengths{};
  code_lengths(counts, 15, lengths);
  EXPECT_EQ(lengths, (std::array<std::uint8_t, 5>{1, 0, 3, 3, 2}));
}

// The example of RFC 1951, 3.2.2, with the first bit lowest.
TEST(Huffman, codes_of_the_standards_example) {
  const std::array<std::uint8_t, 8> lengths{3, 3, 3, 3, 3, 2, 4, 4};
  std::array<std::uint16_t, 8> codes{};
  canonical_codes(lengths, codes);
  EXPECT_EQ(codes, (std::array<std::uint16_t, 8>{0b010, 0b110, 0b001, 0b101, 0b011, 0b00, 0b0111,
                                                 0b1111}));
}

TEST(Huffman, one_symbol_gets_a_partner) {
  const std::array<std::uint32_t, 4> counts{0, 0, 9, 0};
  std::array<std::uint8_t, 4> lengths{};
  code_lengths(counts, 15, lengths);
  EXPECT_EQ(lengths, (std::array<std::uint8_t, 4>{1, 0, 1, 0}));
}

TEST(Huffman, limited_codes_use_the_whole_code_space) {
  Random random;
  for (int round = 0; round < 500; ++round) {
    std::vector<std::uint32_t> counts(2 + random.next() % 250);
    for (std::uint32_t& count : counts) count = 1u << (random.next() % 23);
    std::vector<std::uint8_t> lengths(counts.size());
    const int max_length = 8 + static_cast<int>(random.next() % 8);
    code_lengths(counts, max_length, lengths);
    double kraft = 0;
    for (const std::uint8_t length : lengths) {
      ASSERT_GE(length, 1);
      ASSERT_LE(length, max_length);
      kraft += std::ldexp(1.0, -length);
    }
    EXPECT_EQ(kraft, 1);
  }
}

}  // namespace
}  // namespace sfumato
