#include "codecs/png/png_pack.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

// zlib, which did not write the stream, decodes it.
namespace sfumato {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::uint8_t kEmptyLastBlock[] = {3, 0};

/// Appends packed bytes after existing ones, in the requested room.
void append_packed(const Bytes& bytes, Bytes& out) {
  Bytes room(out);
  room.reserve(out.size() + codecs::packed_bound(bytes.size()));
  const std::uint8_t* data = room.data();
  codecs::pack_runs(bytes, room);
  EXPECT_EQ(room.data(), data) << "grew beyond its bound";
  EXPECT_TRUE(std::equal(out.begin(), out.end(), room.begin()));
  out = std::move(room);
}

Bytes packed(const Bytes& bytes) {
  Bytes out;
  append_packed(bytes, out);
  return out;
}

/// Returns the content of the blocks; empty with an error if they are not valid deflate data.
Bytes unpacked(Bytes stream, std::size_t size) {
  stream.insert(stream.end(), std::begin(kEmptyLastBlock), std::end(kEmptyLastBlock));
  Bytes bytes(size + 1);
  z_stream inflater{};
  EXPECT_EQ(inflateInit2(&inflater, -MAX_WBITS), Z_OK);
  inflater.next_in = stream.data();
  inflater.avail_in = static_cast<uInt>(stream.size());
  inflater.next_out = bytes.data();
  inflater.avail_out = static_cast<uInt>(bytes.size());
  EXPECT_EQ(inflate(&inflater, Z_FINISH), Z_STREAM_END) << (inflater.msg ? inflater.msg : "");
  EXPECT_EQ(inflater.avail_in, 0u);
  bytes.resize(inflater.total_out);
  inflateEnd(&inflater);
  return bytes;
}

void expect_round_trip(const Bytes& bytes) {
  EXPECT_TRUE(unpacked(packed(bytes), bytes.size()) == bytes) << bytes.size() << " bytes";
}

Bytes noise(std::size_t size, std::uint32_t seed, unsigned value_count = 256) {
  std::mt19937 random(seed);
  Bytes bytes(size);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random() % value_count);
  return bytes;
}

/// Returns stretches of noise with few and many values, of one value, and of rising values.
Bytes mixture(std::size_t size, std::uint32_t seed) {
  std::mt19937 random(seed);
  Bytes bytes;
  while (bytes.size() < size) {
    const std::size_t length = 1 + random() % (std::size_t{1} << (random() % 14));
    const unsigned kind = random() % 4, value_count = 1 + random() % 255;
    auto value = static_cast<std::uint8_t>(random());
    for (std::size_t i = 0; i < length; ++i) {
      if (kind == 0) value = static_cast<std::uint8_t>(random());
      if (kind == 1) value = static_cast<std::uint8_t>(random() % value_count);
      if (kind == 2) ++value;
      bytes.push_back(value);
    }
  }
  bytes.resize(size);
  return bytes;
}

TEST(PngPack, gives_back_what_it_packed) {
  for (std::uint32_t seed = 0; seed < 400; ++seed) {
    std::mt19937 random(seed);
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_round_trip(mixture(1 + random() % (std::size_t{1} << (random() % 19)), seed));
  }
}

TEST(PngPack, gives_back_the_smallest_inputs) {
  for (std::size_t size = 0; size < 50; ++size) {
    expect_round_trip(Bytes(size, 7));
    expect_round_trip(noise(size, 1));
    expect_round_trip(noise(size, 2, 2));
  }
}

TEST(PngPack, gives_back_runs_of_any_length_at_any_place) {
  for (std::size_t length = 1; length < 800; ++length) {
    Bytes bytes = noise(1 + length % 19, static_cast<std::uint32_t>(length));
    bytes.insert(bytes.end(), length, static_cast<std::uint8_t>(length));
    const Bytes behind = noise(length % 17, 5);
    bytes.insert(bytes.end(), behind.begin(), behind.end());
    bytes.insert(bytes.end(), 3000, 0);  // so that it is not stored uncompressed
    expect_round_trip(bytes);
  }
}

TEST(PngPack, gives_back_what_fills_blocks) {
  for (const std::size_t blocks : {1, 2, 3}) {
    for (std::size_t size = 65'535 * blocks - 2; size <= 65'535 * blocks + 2; ++size) {
      SCOPED_TRACE(size);
      expect_round_trip(Bytes(size, 0));
      expect_round_trip(noise(size, 3));
      expect_round_trip(mixture(size, 4));
    }
  }
}

TEST(PngPack, gives_back_symbols_of_the_longest_code_words) {
  Bytes bytes;  // each value as often as the two before it together
  for (std::uint32_t value = 0, count = 1, next = 1; value < 22; ++value) {
    bytes.insert(bytes.end(), count, static_cast<std::uint8_t>(11 * value));
    next += count;
    count = next - count;
  }
  std::shuffle(bytes.begin(), bytes.end(), std::mt19937(1));
  expect_round_trip(bytes);
}

TEST(PngPack, streams_packed_apart_are_one_when_joined) {
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    std::mt19937 random(seed);
    Bytes all, stream;
    for (int i = 0; i < 20; ++i) {
      const std::size_t size = 1 + random() % 3000;
      const Bytes part = random() % 3 == 0 ? noise(size, random()) : mixture(size, random());
      all.insert(all.end(), part.begin(), part.end());
      append_packed(part, stream);
    }
    EXPECT_TRUE(unpacked(stream, all.size()) == all) << seed;
  }
}

TEST(PngPack, noise_grows_by_no_more_than_the_heads_of_its_blocks) {
  for (const std::size_t size : {1, 100, 65'535, 200'000}) {
    EXPECT_LE(packed(noise(size, 1)).size(), size + 6 * (size / 65'535 + 2)) << size;
  }
}

TEST(PngPack, one_value_shrinks_to_two_bits_for_a_run) {
  EXPECT_LE(packed(Bytes(131'072, 0)).size(), 131'072u / 258 / 4 + 60);
}

TEST(PngPack, run_is_found_from_its_first_byte_wherever_that_is) {
  std::size_t smallest = SIZE_MAX, largest = 0;
  constexpr std::size_t kRuns = 40;
  for (std::size_t shift = 0; shift < 8; ++shift) {
    Bytes bytes = noise(kRuns * 108, 1, 16);
    for (std::size_t i = 0; i < kRuns; ++i) {
      std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>((100 + shift) * i), 24, 16);
    }
    const std::size_t size = packed(bytes).size();
    smallest = std::min(smallest, size);
    largest = std::max(largest, size);
  }
  EXPECT_LT(largest, smallest + kRuns / 2);  // seven literals for each run would be 40 × 3 bytes
}

}  // namespace
}  // namespace sfumato
